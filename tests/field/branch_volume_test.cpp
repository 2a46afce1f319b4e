#include "field/branch_volume.h"

#include <gtest/gtest.h>

#include "field/fused.h"

namespace frond {
namespace {

/// A trunk that forks in a Y, arms of the given radius at the given angle from the vertical.
Skeleton fork(double angle, float radius = 0.1f) {
  Skeleton s;
  s.add({0, -1, 0}, radius, Skeleton::kRoot, 0);
  s.add({0, 0, 0}, radius, 0, 0);
  auto x = static_cast<float>(std::sin(angle)), y = static_cast<float>(std::cos(angle));
  s.add({x, y, 0}, radius, 1, 0);
  s.add({-x, y, 0}, radius, 1, 1);
  return s;
}

FieldSample sample(const BranchVolume& boughs, Vec3 at) { return sample_boughs(boughs, all_of(boughs), at); }

TEST(RoundCone, distance_is_that_to_the_spheres_it_is_the_hull_of) {
  RoundCone cone = make_cone({0, 0, 0}, 0.5f, {2, 1, 0}, 0.2f, 0);
  for (int i = 0; i < 300; ++i) {
    Seed seed = Seed{1}.child(static_cast<std::uint64_t>(i));
    Vec3 at(seed.child(0).range(-1, 3), seed.child(1).range(-1, 2), seed.child(2).range(-1, 1));
    double least = 1e9;
    for (int k = 0; k <= 4000; ++k) {
      float t = static_cast<float>(k) / 4000;
      least = std::min<double>(least, glm::distance(at, t * Vec3(2, 1, 0)) - (0.5 - 0.3 * t));
    }
    EXPECT_NEAR(distance(cone, at), least, 1e-4);
  }
}

TEST(RoundCone, that_holds_its_other_end_is_a_ball) {
  RoundCone cone = make_cone({0, 0, 0}, 0.1f, {0, 0.2f, 0}, 0.5f, 0);
  EXPECT_NEAR(distance(cone, {1, 0.2f, 0}), 0.5f, 1e-6);
  EXPECT_NEAR(distance(cone, {0, -0.4f, 0}), 0.1f, 1e-6);
}

TEST(BranchVolume, a_fork_has_a_fillet_in_its_crotch_only) {
  BranchVolume sharp = boughs_of(fork(radians(40.0)), 0), round = boughs_of(fork(radians(40.0)), 1);
  // The crotch: where the surfaces of both arms meet above the fork.
  Vec3 crotch(0, 0.1f / static_cast<float>(std::sin(radians(40.0))), 0);
  EXPECT_NEAR(sample(sharp, crotch).distance, 0, 1e-4);
  EXPECT_LT(sample(round, crotch).distance, -0.02f);
  // Nothing swells behind the fork, where all arms lie within each other, nor far from it.
  for (Vec3 at : {Vec3(0, -0.3f, 0.1f), Vec3(0.1f, -0.6f, 0), Vec3(0.7f, 0.7f, 0)})
    EXPECT_NEAR(sample(round, at).distance, sample(sharp, at).distance, 1e-5);
  EXPECT_GT(sample(round, {0, 0, 0.1f}).distance, -0.006f);
}

TEST(BranchVolume, fillets_do_not_depend_on_the_order_of_branches) {
  BranchVolume one = boughs_of(fork(radians(30.0)), 1), other = boughs_of(fork(radians(-30.0)), 1);
  for (int i = 0; i < 200; ++i) {
    Seed seed = Seed{2}.child(static_cast<std::uint64_t>(i));
    Vec3 at(seed.child(0).range(-0.4, 0.4), seed.child(1).range(-0.3, 0.6), seed.child(2).range(-0.2, 0.2));
    EXPECT_NEAR(sample(one, at).distance, sample(other, at).distance, 1e-6);
  }
}

TEST(BranchVolume, strangers_that_pass_each_other_have_no_fillet) {
  Skeleton s;
  s.add({-1, 0, 0}, 0.1f, Skeleton::kRoot, 0);
  s.add({1, 0, 0}, 0.1f, 0, 0);
  s.add({0, -1, 0.1f}, 0.1f, Skeleton::kRoot, 0);
  s.add({0, 1, 0.1f}, 0.1f, 2, 0);
  BranchVolume boughs = boughs_of(s, 2);
  EXPECT_TRUE(boughs.forks.forks.empty());
  Vec3 at(0.1f, 0.1f, 0.05f);
  EXPECT_EQ(sample(boughs, at).distance,
            std::min(distance(boughs.cones[0], at), distance(boughs.cones[1], at)));
}

TEST(BranchVolume, bends_of_an_arm_leave_no_step) {
  // A fork whose one arm bends sharply back over the other: across the bend its direction turns.
  Skeleton s;
  s.add({0, -1, 0}, 0.1f, Skeleton::kRoot, 0);
  s.add({0, 0, 0}, 0.1f, 0, 0);
  s.add({0, 1, 0}, 0.1f, 1, 0);
  s.add({0.25f, 0.1f, 0}, 0.1f, 1, 1);
  s.add({0.3f, 0.5f, 0}, 0.1f, 3, 1);
  BranchVolume boughs = boughs_of(s, 1.5f);
  for (int i = 0; i < 20000; ++i) {
    Seed seed = Seed{5}.child(static_cast<std::uint64_t>(i));
    Vec3 at(seed.child(0).range(0, 0.4), seed.child(1).range(-0.1, 0.6), seed.child(2).range(-0.15, 0.15));
    Vec3 way(seed.child(3).normal(), seed.child(4).normal(), seed.child(5).normal());
    way = glm::normalize(way) * 0.0002f;
    ASSERT_LT(std::abs(sample(boughs, at + way).distance - sample(boughs, at).distance), 0.0015f);
  }
}

TEST(BranchVolume, the_field_is_continuous_and_its_normal_is_its_slope) {
  Skeleton s = test_coral(3, 0.06);
  BranchVolume boughs = boughs_of(s, 1);
  int astray = 0;
  for (int i = 0; i < 500; ++i) {
    Seed seed = Seed{3}.child(static_cast<std::uint64_t>(i));
    Vec3 at(seed.child(0).range(-0.4, 0.4), seed.child(1).range(0, 1), seed.child(2).range(-0.4, 0.4));
    Vec3 way(seed.child(3).normal(), seed.child(4).normal(), seed.child(5).normal());
    way = glm::normalize(way) * 0.0005f;
    float here = sample(boughs, at).distance, there = sample(boughs, at + way).distance;
    EXPECT_LT(std::abs(there - here), 2 * 0.0005f);
    float slope = (there - here) / 0.0005f, expected = glm::dot(sample(boughs, at).normal, way) / 0.0005f;
    astray += std::abs(slope - expected) > 0.2f;
  }
  EXPECT_LE(astray, 10);  // creases
}

}  // namespace
}  // namespace frond
