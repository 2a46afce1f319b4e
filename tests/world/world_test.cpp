#include "world/world.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <ctime>

#include "core/parallel.h"
#include "shapes.h"

namespace frond {
namespace {

/// A level square of 2 `half` metres, `high` above the ground, as a body.
Specimen roof(const std::string& name, float high, float half) {
  Surface s;
  for (float x : {-half, half})
    for (float z : {-half, half}) s.position.emplace_back(x, high, z), s.normal.emplace_back(0, 1, 0);
  s.triangle = {{0, 1, 2}, {1, 3, 2}};
  Specimen roof;
  roof.name = name;
  roof.entry = 0;
  roof.model.solids.place(roof.model.solids.add_shape({std::move(s), {}}));
  return roof;
}

World open_world() { return World(Seed{1}, Heights(), 4, true); }

TEST(World, ToldOfNothingToGrowOnNobodyIsToldOfTriangles) {
  World world = open_world();
  EXPECT_EQ(world.host({}, "ivy").errors()[0].text(),
            "ivy: nothing stands here to grow on; expected a body such as a wall, a rock or a mesh");
}

TEST(World, FindsTheClosestPointAndTheFirstCrossingOfBodiesByName) {
  World world = open_world();
  EXPECT_FALSE(world.host({}, "nobody"));
  world.add({});
  std::vector<Specimen> grown;
  grown.push_back(roof("low", 1, 2));
  grown.push_back(roof("high", 3, 2));
  world.add(std::move(grown));
  auto all = world.host({}, "test"), high = world.host({"high"}, "test");
  ASSERT_TRUE(all && high);
  EXPECT_NEAR((*all)->closest(DVec3(0, 0, 0))->distance, 1, 1e-6);
  EXPECT_NEAR((*high)->closest(DVec3(0, 0, 0))->distance, 3, 1e-6);
  EXPECT_NEAR((*all)->crossing(DVec3(0, 0, 0), DVec3(0, 4, 0))->share, 0.25, 1e-6);
  EXPECT_NE(world.host({"neither"}, "test").errors()[0].text().find("of \"neither\" to grow on"),
            std::string::npos);
  EXPECT_EQ(world.host({"high"}, "test")->get(), high->get()) << "made once";
}

TEST(World, FindsOnceThatThereIsNoHost) {
  Surface flat;  // of a million triangles, none of which has an area
  flat.position = {Vec3(0, 1, 0), Vec3(1, 1, 0), Vec3(2, 1, 0)};
  flat.normal.assign(3, Vec3(0, 1, 0));
  flat.triangle.assign(1'000'000, {0, 1, 2});
  Specimen body;
  body.name = "flat", body.entry = 0;
  body.model.solids.place(body.model.solids.add_shape({std::move(flat), {}}));
  World world = open_world();
  std::vector<Specimen> grown;
  grown.push_back(std::move(body));
  world.add(std::move(grown));
  std::clock_t begin = std::clock();
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(world.open_sky(DVec3(0)), 1);
  EXPECT_LT(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, 10.0) << "merged again each time";
  EXPECT_EQ(world.host({}, "one").errors()[0].where, "one");
  EXPECT_EQ(world.host({}, "other").errors()[0].where, "other") << "whoever asked first";
  std::vector<Specimen> more;
  more.push_back(roof("roof", 1, 2));
  world.add(std::move(more));
  EXPECT_TRUE(world.host({}, "other")) << "what is added may be one";
}

TEST(World, ManyTasksMayAskForAHostThatIsNotBuiltYet) {
  // Embree builds by tasks of the same pool, in which others ask for the same host and the same obstacles.
  Surface hills;
  constexpr int kSide = 120;
  for (int i = 0; i < kSide * kSide; ++i)
    hills.position.emplace_back(i % kSide, std::sin(0.1 * i), i / kSide);
  for (std::uint32_t i = 0; i + kSide + 1 < kSide * kSide; ++i)
    if (i % kSide + 1 < kSide) {
      hills.triangle.push_back({i, i + kSide, i + 1});
      hills.triangle.push_back({i + 1, i + kSide, i + kSide + 1});
    }
  set_normals(hills);
  for (int round = 0; round < 12; ++round) {
    Specimen body;
    body.name = "hills", body.entry = 0;
    body.model.solids.place(body.model.solids.add_shape({hills, {}}));
    World world = open_world();
    std::vector<Specimen> grown;
    grown.push_back(std::move(body));
    world.add(std::move(grown));
    std::atomic<int> met = 0;
    parallel_for(64, [&](std::size_t i) {
      auto host = world.host(i % 2 ? std::vector<std::string>{} : std::vector<std::string>{"hills"}, "test");
      auto obstacles = world.obstacles();
      met += host && obstacles && (*obstacles)->near({Vec3(1), Vec3(2)});
    });
    EXPECT_EQ(met, 64);
  }
}

TEST(World, HasLessLightUnderARoof) {
  World world = open_world();
  EXPECT_EQ(world.open_sky(DVec3(0, 0.5, 0)), 1);
  std::vector<Specimen> grown;
  grown.push_back(roof("roof", 3, 2));
  world.add(std::move(grown));
  double below = world.open_sky(DVec3(0, 2.5, 0)), beside = world.open_sky(DVec3(9, 2.5, 0)),
         above = world.open_sky(DVec3(0, 3.5, 0));
  EXPECT_LT(below, 0.2);
  EXPECT_GT(beside, 0.9);
  EXPECT_EQ(above, 1);
}

TEST(World, KnowsWhatIsTaken) {
  TakenSpots spots;
  spots.add({Vec2(1, 0), 0.5f});
  World world(Seed{1}, Heights(), 4, true, spots);
  EXPECT_TRUE(world.taken(Vec2(0.2f, 0), 0.4f));
  EXPECT_FALSE(world.taken(Vec2(0, 0), 0.4f));
}

TEST(World, KnowsWhereFoodIs) {
  std::vector<Specimen> grown(3);
  grown[0].motion.food.strength = grown[1].motion.food.strength = 0.5;
  grown[0].motion.food.position = grown[1].motion.food.position =
      Animated<Vec3>({{0, Vec3(0)}, {2, Vec3(2, 0, 0)}});
  EXPECT_EQ(food_places(grown, 2), (std::vector<FoodLeft>{{Vec3(2, 0, 0), 1}}));
  // Of more food each is told, and what is eaten is gone.
  grown[1].motion.food.others = {{Vec3(0, 1, 0)}, {Vec3(0, 2, 0)}};
  grown[1].motion.food.reached = {9, 9, 0.25};
  EXPECT_EQ(food_places(grown, 2).size(), 2u);
}

TEST(Put, ScalesAllThatAModelHas) {
  Model model;
  model.skeleton = candelabrum(3, Seed{1});
  model.girth = model.skeleton.radius;
  Model moved = model;
  transform(moved, Vec3(1, 0, 0), Quat(1, 0, 0, 0), 2);
  EXPECT_EQ(moved.skeleton.position[2], Vec3(1, 0, 0) + 2.0f * model.skeleton.position[2]);
  EXPECT_EQ(moved.girth[2], 2 * model.girth[2]);
  EXPECT_EQ(moved.skeleton.radius[2], 2 * model.skeleton.radius[2]);
}

}  // namespace
}  // namespace frond
