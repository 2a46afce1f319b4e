#include "draw/draw_list.h"

#include <gtest/gtest.h>

#include <set>

#include "closed.h"
#include "geometry/far.h"
#include "scene_at.h"

namespace frond {
namespace {

TEST(DrawList, HoldsAllThatAGrownSpecimenIsMadeOf) {
  std::size_t organs = 0, blades = 0, bodies = 0, branches = 0;
  for (const char* preset : {"tiny_plant", "tiny_garden", "tiny_shell", "tiny_reef"}) {
    Scene scene = scene_at(std::string("tests/presets/") + preset + ".json");
    for (const Specimen& grown : scene.specimens) {
      double end = scene.film.time(scene.film.frames) + 100;  // long after all growth
      auto now = *developed(grown, end);
      const Specimen& s = *now;
      DrawList drawn(s, end);
      std::size_t listed = 0, placed = 0;
      for (const OrganGroup& group : drawn.organs.groups) {
        EXPECT_EQ(drawn.organs.places(group).size(), drawn.organs.organs(group).size());
        listed += drawn.organs.places(group).size();
      }
      EXPECT_EQ(listed, s.model.organs.size()) << preset;
      double sheet = 0;
      for (const DrawnBlades& some : drawn.blades) sheet += area(some.surface);
      EXPECT_NEAR(sheet, area(s.model.blades.surface), 1e-4 * sheet) << preset;
      for (const DrawnBody& body : drawn.bodies) placed += body.places.size();
      EXPECT_EQ(placed, s.model.solids.size()) << preset;
      EXPECT_EQ(drawn.branches.has_value(), s.look.branches.drawn());
      organs += listed, blades += drawn.blades.size(), bodies += placed,
          branches += drawn.branches.has_value();
    }
  }
  EXPECT_GT(organs, 0u);
  EXPECT_GT(blades, 0u);
  EXPECT_GT(bodies, 0u);
  EXPECT_GT(branches, 0u);
}

TEST(DrawList, BodiesThatGrowAreSmallerBeforeAndNotThereBeforeTheBeginning) {
  Surface ball;  // an octahedron
  for (int axis = 0; axis < 3; ++axis)
    for (float side : {-1.0f, 1.0f}) {
      Vec3 p(0);
      p[axis] = side;
      ball.position.push_back(p), ball.normal.push_back(p);
    }
  for (std::uint32_t x : {0u, 1u})
    for (std::uint32_t y : {2u, 3u})
      for (std::uint32_t z : {4u, 5u})
        ball.triangle.push_back((x + y + z) % 2 == 1 ? std::array{x, y, z} : std::array{x, z, y});
  Solid solid{ball, {}};
  std::vector<Vec3>& seed = solid.past.emplace_back();
  for (const Vec3& p : ball.position) seed.push_back(0.1f * p);
  Specimen s;
  s.motion.growth = {.start = 1, .duration = 2};
  s.model.solids.place(s.model.solids.add_shape(solid));
  EXPECT_TRUE(DrawList(s, 0.5).bodies.empty());
  double before = 0;
  for (double time : {1.5, 2.0, 4.0}) {
    DrawList drawn(s, time);
    ASSERT_EQ(drawn.bodies.size(), 1u);
    double volume = std::abs(volume_of(drawn.bodies[0].surface()));
    EXPECT_GT(volume, before) << time;
    before = volume;
  }
  EXPECT_NEAR(before, 4.0 / 3, 1e-3);
}

TEST(DrawList, OfAModelAtRestIsThatOfASpecimenLongGrown) {
  Scene scene = scene_at("presets/lsystems/plants-1.24.json");
  const Specimen& s = scene.specimens[0];
  DrawList rest(s, s.model);
  EXPECT_EQ(rest.pose.position, s.model.skeleton.position);
  EXPECT_EQ(rest.pose.radius, s.model.skeleton.radius);
}

TEST(PlainLook, IsThatOfTheTissueAndItsColour) {
  Prototype flower{"flower",
                   {{Tissue::petal, {}}, {Tissue::heart, {}}, {Tissue::fruit, {}}},
                   {Color{1, 0, 0}, Color{0, 0, 1}},
                   Color{1, 1, 0}};
  EXPECT_EQ(plain_look(flower, 0, 1).color.blue, 1);
  EXPECT_TRUE(plain_look(flower, 0, 0).both_sides);
  EXPECT_GT(plain_look(flower, 0, 0).light_through, 0);
  EXPECT_EQ(plain_look(flower, 1, 1).color.green, 1) << "the heart has a colour of its own";
  EXPECT_FALSE(plain_look(flower, 2, 0).both_sides);
  flower.luster = Luster{.through = 0.6, .gloss = 0.9};
  EXPECT_EQ(plain_look(flower, 0, 0).light_through, 0.6);
  EXPECT_EQ(plain_look(flower, 0, 0).gloss, 0.9);
  Material glass;
  glass.matter = Matter::glass;
  EXPECT_LT(plain_look(glass).opacity, 1);
  EXPECT_EQ(plain_look(Material{}).opacity, 1);
}

}  // namespace
}  // namespace frond
