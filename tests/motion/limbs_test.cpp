#include "motion/limbs.h"

#include <gtest/gtest.h>

#include <cmath>

#include "motion/posed.h"

namespace frond {
namespace {

/// A stem with limbs that have twigs.
Skeleton small_tree() {
  Skeleton s;
  std::int32_t below = s.add(Vec3(0), 0.1f, Skeleton::kRoot, 0);
  std::vector<std::int32_t> stem{below};
  for (int i = 1; i <= 20; ++i)
    stem.push_back(below = s.add(Vec3(0, 0.2f * static_cast<float>(i), 0), 0.08f, below, 0));
  for (int i = 8; i < 20; i += 3) {
    std::int32_t limb = stem[static_cast<std::size_t>(i)];
    for (int k = 1; k <= 10; ++k) {
      limb = s.add(s.position[limb] + Vec3(0.15f, 0.05f, 0.02f * static_cast<float>(i)), 0.03f, limb, 1);
      std::int32_t twig = limb;
      for (int j = 0; j < 3; ++j) twig = s.add(s.position[twig] + Vec3(0, 0.02f, 0.08f), 0.005f, twig, 2);
    }
  }
  order_branches(s);
  set_tip_distances(s);
  return s;
}

Motion windy() {
  Motion motion;
  motion.limbs = true;
  motion.wave.amplitude = 0.25;
  motion.wave.speed = 0.3;
  motion.film_length = 4;
  return motion;
}

TEST(Limbs, NothingComesApart) {
  Skeleton s = small_tree();
  for (double time : {0.0, 0.4, 1.7, 3.1}) {
    Pose pose = posed(s, windy(), time);
    EXPECT_EQ(pose.position[0], s.position[0]);
    for (std::size_t i = 1; i < s.size(); ++i)
      EXPECT_NEAR(glm::distance(pose.position[i], pose.position[s.parent[i]]),
                  glm::distance(s.position[i], s.position[s.parent[i]]), 1e-4f);
  }
}

TEST(Limbs, TheFilmLoops) {
  Skeleton s = small_tree();
  Pose first = posed(s, windy(), 0.3), again = posed(s, windy(), 4.3);
  for (std::size_t i = 0; i < s.size(); ++i)
    EXPECT_LT(glm::distance(first.position[i], again.position[i]), 1e-3f);
  EXPECT_NEAR(std::sin(first.flutter_phase), std::sin(again.flutter_phase), 1e-4);
}

/// How often the turns of nodes of an order change their direction over the film.
double swings(const Skeleton& s, int order) {
  int count = 0, nodes = 0;
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (s.order[i] != order || s.to_tip[i] > 0.3f) continue;
    ++nodes;
    Vec3 last(0), before(0);
    for (int frame = 0; frame <= 200; ++frame) {
      Pose pose = posed(s, windy(), 4.0 * frame / 200);
      std::int32_t base = static_cast<std::int32_t>(i);
      while (s.parent[base] != Skeleton::kRoot && s.order[s.parent[base]] == order) base = s.parent[base];
      std::int32_t bearer = s.parent[base] == Skeleton::kRoot ? base : s.parent[base];
      Quat own = glm::conjugate(pose.turn[bearer]) * pose.turn[i];
      Vec3 now(own.x, own.y, own.z);
      if (frame > 1 && (now.z - last.z) * (last.z - before.z) < 0) ++count;
      before = last, last = now;
    }
    if (nodes == 6) break;
  }
  return static_cast<double>(count) / nodes;
}

TEST(Limbs, SmallerOnesSwingFaster) {
  Skeleton s = small_tree();
  EXPECT_GT(swings(s, 1), 1.2 * swings(s, 0));
  EXPECT_GT(swings(s, 2), 1.2 * swings(s, 1));
}

TEST(Limbs, NoNodeJumps) {
  Skeleton s = small_tree();
  Pose last = posed(s, windy(), 0);
  for (int frame = 1; frame <= 96; ++frame) {
    Pose now = posed(s, windy(), frame / 24.0);
    for (std::size_t i = 0; i < s.size(); ++i)
      EXPECT_LT(glm::distance(now.position[i], last.position[i]), 0.12f);
    last = now;
  }
}

TEST(Limbs, WithoutWindTheTreeIsStill) {
  Skeleton s = small_tree();
  Motion motion = windy();
  motion.wave.amplitude = 0;
  Pose pose = posed(s, motion, 1.3);
  EXPECT_EQ(pose.flutter, 0);
  for (std::size_t i = 0; i < s.size(); ++i) EXPECT_LT(glm::distance(pose.position[i], s.position[i]), 1e-5f);
}

}  // namespace
}  // namespace frond
