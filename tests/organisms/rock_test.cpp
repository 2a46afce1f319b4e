#include "organisms/rock/rock.h"

#include "images/describe_mask.h"
#include "organisms/pebbles/pebbles.h"

#include <gtest/gtest.h>

#include <set>

namespace frond {
namespace {

RockParams quick() {
  RockParams params;
  params.shape.cells = {4, 0.002};
  return params;
}

TEST(BuildRock, MakesOneSolidALittleInTheGround) {
  RockParams params = quick();
  params.stone.kind = StoneKind::basalt;
  params.stone.color = Color{0.5f, 0.4f, 0.3f};
  params.stone.moss = 0.7;
  params.stone.variation = 0;
  Model model = *build_rock(params, Seed{1});
  EXPECT_EQ(model.find_fault(), "");
  ASSERT_EQ(model.solids.size(), 1u);
  EXPECT_EQ(model.skeleton.size(), 0u);
  const Solid& rock = model.solids.shapes[0];
  EXPECT_EQ(rock.material.matter, Matter::basalt);
  EXPECT_EQ(rock.material.color, (Color{0.5f, 0.4f, 0.3f}));
  EXPECT_EQ(rock.material.moss, 0.7);
  EXPECT_FALSE(rock.native.has_value());
  float high = 0;
  for (Vec3 p : rock.surface.position) high = std::max(high, p.y);
  EXPECT_NEAR(model.solids.position[0].y, -0.06f * high, 1e-5);
}

TEST(BuildRock, HasTheDefaultsOfTheSource) {
  RockParams params;
  EXPECT_EQ(params.shape.chance.count, 6);
  EXPECT_EQ(params.shape.chance.least_radius, 0.5);
  EXPECT_EQ(params.shape.chance.most_radius, 2);
  EXPECT_EQ(params.shape.falloff, Falloff::gaussian);
  EXPECT_EQ(params.shape.level, 1);
}

TEST(BuildRock, IsNativeOnRequest) {
  RockParams params = quick();
  params.native = true;
  for (Falloff falloff : {Falloff::gaussian, Falloff::soft, Falloff::cubic}) {
    params.shape.falloff = falloff;
    Model model = *build_rock(params, Seed{3});
    ASSERT_TRUE(model.solids.shapes[0].native.has_value());
    EXPECT_EQ(model.solids.shapes[0].native->blobs.falloff, falloff);
    EXPECT_GT(model.solids.shapes[0].surface.triangle.size(), 100u);
  }
}

TEST(BuildRock, RefusesBlobsWithoutAnInside) {
  RockParams params = quick();
  params.shape.chance.count = 1;
  EXPECT_FALSE(build_rock(params, Seed{1}).ok());
  EXPECT_FALSE(check_rock(params.shape).empty());
  params.shape.level = 0.5;
  EXPECT_TRUE(check_rock(params.shape).empty());
  EXPECT_TRUE(build_rock(params, Seed{1}).ok());
  // Far apart: their sum nowhere reaches the level.
  params = quick();
  params.shape.own = {{DVec3(1), DVec3(-9, 0, 0)}, {DVec3(1), DVec3(9, 0, 0)}};
  EXPECT_FALSE(build_rock(params, Seed{1}).ok());
  params.shape.own = {};
  params.shape.chance.least_radius = 3;
  EXPECT_EQ(check_rock(params.shape)[0].what, "least_radius is above most_radius");
}

TEST(BuildRock, IsAFrameworkOrRubbleOnRequest) {
  RockParams params = quick();
  std::size_t blobs = build_rock(params, Seed{3})->solids.shapes[0].surface.triangle.size();
  params.shape.form = RockForm::framework;
  params.shape.chance.count = 0;  // of no account
  Model framework = *build_rock(params, Seed{3});
  EXPECT_EQ(framework.find_fault(), "");
  EXPECT_NE(framework.solids.shapes[0].surface.triangle.size(), blobs);
  params.shape.form = RockForm::rubble;
  Model rubble = *build_rock(params, Seed{3});
  EXPECT_LT(height_of(rubble.solids.shapes[0].surface), height_of(framework.solids.shapes[0].surface));
}

TEST(BuildPebbles, LayManyThatDiffer) {
  PebblesParams params;
  params.shape.cells = {4, 0.002};
  params.shapes = 5;
  params.number = 200;
  Model model = *build_pebbles(params, Seed{6});
  EXPECT_EQ(model.find_fault(), "");
  const Solids& s = model.solids;
  EXPECT_TRUE(s.follow_ground);
  EXPECT_EQ(s.shapes.size(), 5u);
  EXPECT_GT(s.size(), 190u);
  std::set<std::uint16_t> used(s.shape.begin(), s.shape.end());
  EXPECT_EQ(used.size(), 5u);
  double middle = (params.least_size + params.most_size) / 2;
  std::size_t small = 0;
  for (std::size_t i = 0; i < s.size(); ++i) {
    double size = s.scale[i].x * middle;
    EXPECT_GE(size, params.least_size * 0.999);
    EXPECT_LE(size, params.most_size * 1.001);
    small += size < middle;
    EXPECT_LE(std::hypot(s.position[i].x, s.position[i].z), params.radius);
    EXPECT_LT(s.position[i].y, 0);
    for (std::size_t k = 0; k < i; ++k) {
      double apart = std::hypot(s.position[i].x - s.position[k].x, s.position[i].z - s.position[k].z);
      EXPECT_GT(apart, 0.45 * middle * (s.scale[i].x + s.scale[k].x));
    }
  }
  EXPECT_GT(small, s.size() * 3 / 4);
}

TEST(BuildPebbles, LeaveOutWhatFindsNoRoom) {
  PebblesParams params;
  params.shape.cells = {4, 0.002};
  params.number = 500;
  params.radius = 0.2;
  EXPECT_LT(build_pebbles(params, Seed{6})->solids.size(), 60u);
  params.least_size = 1;
  EXPECT_FALSE(build_pebbles(params, Seed{6}).ok());
}

/// Its picture as frames have it, read again.
Mask read_again(const StoneLook& look) {
  Appearance appearance = stone_appearance(look);
  EXPECT_EQ(appearance.look.pictures.size(), 1u);
  Result<std::vector<Picture>> drawn = appearance.look.pictures.at(0).draw();
  EXPECT_TRUE(drawn && drawn->at(0).name == look.moss_map.picture_name());
  Mask mask;
  EXPECT_TRUE(load_mask({"moss.png", drawn->at(0).bytes}, mask).empty());
  return mask;
}

TEST(Stone, WearsTheMapOfItsMossWhichHasAnArea) {
  StoneLook look;
  EXPECT_TRUE(check_stone(look).empty() && stone_appearance(look).look.pictures.empty());
  EXPECT_FALSE(material_of(look, Seed{1}).moss_map);
  look.moss_map.file = {"moss.png", "abc"};
  EXPECT_EQ(check_stone(look).front().where, "/stone/moss_map");
  look.moss_map.area = {Vec2(0), Vec2(1)};
  EXPECT_TRUE(check_stone(look).empty());
  look.moss_map.width = 2, look.moss_map.height = 1;
  look.moss_map.grey = std::make_shared<const std::vector<float>>(std::vector{0.0f, 0.6f});
  EXPECT_TRUE(material_of(look, Seed{1}).moss_map);
  Mask again = read_again(look);
  for (int i = 0; i <= 8; ++i)
    EXPECT_NEAR(again.at_share(i / 8.0, 0.5), look.moss_map.at_share(i / 8.0, 0.5), 0.003);
  look.moss_map.grey = std::make_shared<const std::vector<float>>(std::vector{1.0f, 1.0f});
  EXPECT_TRUE(read_again(look).empty()) << "white all over is as none";
}

}  // namespace
}  // namespace frond
