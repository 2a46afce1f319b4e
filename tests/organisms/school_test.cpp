#include "organisms/school/school.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <set>

#include "core/parallel.h"

namespace frond {
namespace {

/// Alignment of the headings at a step: 0 random .. 1 all equal.
double polarization(const Trajectory& trajectory, int step) {
  Vec3 sum(0);
  for (int i = 0; i < trajectory.count; ++i) sum += trajectory.heading[trajectory.at(step, i)];
  return trajectory.count > 0 ? glm::length(sum) / static_cast<float>(trajectory.count) : 0;
}

constexpr double kFilm = 4;
constexpr int kFish = 80;

/// A few swaying posts among which fish swim, and a stone.
std::unique_ptr<const World> reef() {
  auto world = std::make_unique<World>(Seed{1}, Heights([](double, double) { return 0.0; }), kFilm, true);
  Specimen coral{{"coral", 0}, {}};
  Skeleton& s = coral.model.skeleton;
  for (int post = 0; post < 5; ++post)
    for (int i = 0; i < 12; ++i) {
      std::int32_t parent = i == 0 ? Skeleton::kRoot : static_cast<std::int32_t>(s.size()) - 1;
      s.add({0.45f * static_cast<float>(post - 2), 0.12f * static_cast<float>(i),
             0.3f * static_cast<float>(post % 2)},
            0.04f, parent, 0);
    }
  set_tip_distances(s);
  coral.motion.wave.amplitude = 0.2;
  coral.motion.film_length = kFilm;
  std::vector<Specimen> all;
  all.push_back(std::move(coral));
  world->add(std::move(all));
  return world;
}

SwimTask task() {
  SwimTask task;
  task.count = kFish;
  task.home = Vec3(0, 0.9f, 0);
  task.film = kFilm;
  task.seed = Seed{7};
  return task;
}

Trajectory swum_among(const World& world) {
  SwimTask swims = task();
  Vec3 reach(2.6f, 1.5f, 2.6f);
  return swim(swims, 2.2, 0.12, clearance_of(world, swims.home - reach, swims.home + reach, 0.04f));
}

/// Shared, as each test asks of the same school.
const Trajectory& trajectory() {
  static const Trajectory made = swum_among(*reef());
  return made;
}

float distance_to(Vec3 at, Vec3 a, Vec3 b) {
  Vec3 way = b - a;
  float t = glm::clamp(glm::dot(at - a, way) / std::max(1e-12f, glm::dot(way, way)), 0.0f, 1.0f);
  return glm::distance(at, a + t * way);
}

TEST(School, IsTheSameForAnyThreads) {
  std::unique_ptr<const World> world = reef();
  limit_threads(1);
  Trajectory one = swum_among(*world);
  limit_threads(4);
  Trajectory four = swum_among(*world);
  limit_threads(0);
  EXPECT_EQ(one.position, four.position);
  EXPECT_EQ(one.heading, four.heading);
  EXPECT_EQ(one.stroke, four.stroke);
}

TEST(School, KeepsClearOfWhatStands) {
  std::unique_ptr<const World> world = reef();
  const Specimen& coral = world->standing()[0];
  float least = static_cast<float>(task().length) / 2;
  for (int frame = 0; frame < 96; ++frame) {
    double time = kFilm * frame / 96;
    Pose pose;
    pose_skeleton(coral.model.skeleton, coral.motion, time, pose);
    for (int i = 0; i < kFish; ++i) {
      Vec3 at = fish_at(trajectory(), i, time).position;
      ASSERT_GT(at.y, least) << "over the ground";
      for (std::size_t n = 0; n < pose.position.size(); ++n) {
        std::int32_t parent = coral.model.skeleton.parent[n];
        if (parent < 0) continue;
        ASSERT_GT(distance_to(at, pose.position[static_cast<std::size_t>(parent)], pose.position[n]),
                  pose.radius[n] + least)
            << "fish " << i << " at " << time;
      }
    }
  }
}

TEST(School, KeepsApart) {
  const Trajectory& s = trajectory();
  for (int step = 0; step <= s.steps; ++step)
    for (int i = 0; i < kFish; ++i)
      for (int j = i + 1; j < kFish; ++j)
        ASSERT_GT(glm::distance(s.position[s.at(step, i)], s.position[s.at(step, j)]),
                  0.3 * task().params.spacing)
            << i << " and " << j << " at step " << step;
}

TEST(School, ClosesTheFilm) {
  const Trajectory& s = trajectory();
  EXPECT_EQ(std::set<int>(s.next.begin(), s.next.end()).size(), static_cast<std::size_t>(kFish));
  for (int i = 0; i < kFish; ++i) {
    FishPose end = fish_at(s, i, kFilm), begin = fish_at(s, s.next[static_cast<std::size_t>(i)], 0);
    EXPECT_LT(glm::distance(end.position, begin.position), 1e-4f);
    EXPECT_LT(glm::distance(end.heading, begin.heading), 1e-3f);
    EXPECT_NEAR(end.size, begin.size, 1e-5f);
    EXPECT_NEAR(std::remainder(end.stroke - begin.stroke, 1.0f), 0, 1e-3f);
  }
}

TEST(School, AFilmOfTwoFramesIsSwumAsAnyOther) {
  SwimTask swims = task();
  swims.film = 2.0 / 24;
  Trajectory made = swim(swims, 2.2, 0.12, clearance_of(*reef(), Vec3(-3, -1, -3), Vec3(3, 3, 3), 0.04f));
  EXPECT_GE(made.steps, 3) << "directions are taken over three steps to each side";
  ASSERT_EQ(made.heading.size(), made.position.size());
  for (const Vec3& heading : made.heading) EXPECT_NEAR(glm::length(heading), 1, 1e-4);
}

TEST(School, SwimsSmoothly) {
  const Trajectory& s = trajectory();
  double fastest = task().params.speed * (1.5 + glm::length(task().params.current));
  for (int step = 0; step < s.steps; ++step)
    for (int i = 0; i < kFish; ++i)
      ASSERT_LT(glm::distance(s.position[s.at(step, i)], s.position[s.at(step + 1, i)]), 2 * fastest * s.step)
          << "fish " << i << " at step " << step;
}

TEST(School, HeadsOneWay) {
  double chance = 1 / std::sqrt(static_cast<double>(kFish)), sum = 0;
  for (int step = 0; step <= trajectory().steps; ++step) sum += polarization(trajectory(), step);
  EXPECT_GT(sum / (trajectory().steps + 1), 4 * chance);
}

TEST(School, FrameAloneIsThatOfAFilm) {
  SchoolParams params;
  Organs alone = school_organs(params, trajectory(), 2.5);
  for (int frame = 0; frame < 60; ++frame) school_organs(params, trajectory(), frame / 24.0);
  Organs in_order = school_organs(params, trajectory(), 60 / 24.0);
  EXPECT_EQ(alone.position, in_order.position);
  EXPECT_EQ(alone.prototype, in_order.prototype);
}

TEST(School, FishAreSoundMeshes) {
  SchoolParams params;
  for (const Prototype& shape : fish_prototypes(params.fish)) {
    const Surface& mesh = shape.parts[0].surface;
    EXPECT_EQ(mesh.find_fault(), "");
    float front = -1, back = 1;
    for (Vec3 p : mesh.position) front = std::max(front, p.y), back = std::min(back, p.y);
    EXPECT_NEAR(front - back, 1, 0.05);
  }
}

TEST(School, DistancesAreThoseOfTheBodies) {
  Clearance grid(Vec3(-1), Vec3(1), 0.05f);
  grid.add(Vec3(0), 0.2f);
  grid.measure();
  for (float x : {0.4f, 0.6f, 0.9f}) EXPECT_NEAR(grid({x, 0.03f, -0.02f}), x - 0.2f, 0.06f);
  EXPECT_GT(grid.away({0.6f, 0, 0}).x, 0.8f);
}

}  // namespace
}  // namespace frond
