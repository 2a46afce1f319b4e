#include "grove/resource.h"

#include <gtest/gtest.h>

#include "core/seed.h"

namespace frond {
namespace {

/// A random tree: each metamer goes on from the last one of an axis or leaves one sideways.
Metamers random_tree(int size, std::uint64_t seed) {
  Metamers t;
  t.resize(static_cast<std::size_t>(size));
  t.parent[0] = Metamers::kRoot;
  t.flags[0] = Metamers::leading;
  for (int i = 1; i < size; ++i) {
    Seed s = Seed{seed}.child(static_cast<std::uint64_t>(i));
    std::vector<std::int32_t> leaders, buds;
    for (int k = 0; k < i; ++k) {
      if (t.has(k, Metamers::leading)) leaders.push_back(k);
      if (t.has(k, Metamers::bud)) buds.push_back(k);
    }
    bool side = !buds.empty() && s.child(0).unit() < 0.4;
    auto& from = side ? buds : leaders;
    std::int32_t p = from[s.child(1).bits() % from.size()];
    t.clear(p, side ? Metamers::bud : Metamers::leading);
    t.parent[i] = p;
    t.flags[i] =
        static_cast<std::uint8_t>((side ? Metamers::side_shoot : 0) | Metamers::leading | Metamers::bud);
    t.order[i] = static_cast<std::uint8_t>(t.order[p] + (side ? 1 : 0));
    t.light[i] = static_cast<float>(s.child(2).unit());
  }
  return t;
}

float bud_light(const Metamers& t) {
  float sum = 0;
  for (std::size_t i = 0; i < t.size(); ++i)
    sum += t.light[i] * static_cast<float>(t.has(i, Metamers::leading) + t.has(i, Metamers::bud));
  return sum;
}

/// What arrives at buds.
float handed_out(const Metamers& t) {
  float sum = 0;
  for (std::size_t i = 0; i < t.size(); ++i) {
    if (t.has(i, Metamers::leading)) sum += t.to_leader[i];
    if (t.has(i, Metamers::bud)) sum += t.to_side[i];
  }
  return sum;
}

TEST(Resource, LightIsSummedFromTheTipsDown) {
  Metamers t = random_tree(400, 3);
  EXPECT_NEAR(gather_light(t), bud_light(t), 1e-3);
  EXPECT_EQ(t.count[0], 400);
}

TEST(Resource, AllOfItArrivesAtBuds) {
  Species species;
  for (std::uint64_t seed : {1, 2, 3}) {
    for (Sharing sharing : {Sharing::borchert_honda, Sharing::priority}) {
      Metamers t = random_tree(500, seed);
      float light = gather_light(t), resource = 2 * light;
      (sharing == Sharing::priority ? share_by_priority : share_by_forks)(t, species, 10, resource);
      EXPECT_NEAR(handed_out(t), resource, 2e-3f * resource);
    }
  }
}

/// At each fork: what goes to the two sides is what came in.
TEST(Resource, ForksKeepWhatTheyGet) {
  Species species;
  Metamers t = random_tree(500, 9), before = t;
  float resource = gather_light(before);
  t = before;
  share_by_forks(t, species, 5, resource);
  for (std::size_t i = 1; i < t.size(); ++i) {
    float in = t.has(i, Metamers::side_shoot) ? t.to_side[t.parent[i]] : t.to_leader[t.parent[i]];
    if (before.to_leader[i] + before.to_side[i] == 0) continue;
    EXPECT_NEAR(t.to_leader[i] + t.to_side[i], in, 1e-5f + 1e-4f * in);
    double apical = apical_control(species, 5, t.order[i]);
    double leader = apical * before.to_leader[i], side = (1 - apical) * before.to_side[i];
    EXPECT_NEAR(t.to_leader[i], in * leader / (leader + side), 1e-4f * in + 1e-6f);
  }
}

TEST(Resource, ApicalControlFavoursTheLeader) {
  Metamers t = random_tree(300, 5);
  std::fill(t.light.begin(), t.light.end(), 1.0f);
  float share[2];
  for (int high : {0, 1}) {
    for (Sharing sharing : {Sharing::borchert_honda, Sharing::priority}) {
      Species species;
      species.apical_control = species.apical_control_old = high ? 0.7 : 0.45;
      Metamers own = t;
      float light = gather_light(own);
      (sharing == Sharing::priority ? share_by_priority : share_by_forks)(own, species, 5, light);
      share[high] = 0;
      for (std::size_t i = 0; i < own.size(); ++i)
        if (own.order[i] == 0 && own.has(i, Metamers::leading)) share[high] += own.to_leader[i];
    }
  }
  EXPECT_GT(share[1], 1.5f * share[0]);
}

TEST(Resource, ControlFadesWithAge) {
  Species species;
  species.apical_control = 0.7, species.apical_control_old = 0.5, species.maturity = 20;
  species.branch_control = -0.1;
  EXPECT_DOUBLE_EQ(apical_control(species, 0, 0), 0.7);
  EXPECT_DOUBLE_EQ(apical_control(species, 40, 0), 0.5);
  EXPECT_NEAR(apical_control(species, 0, 2), 0.6, 1e-12);
}

}  // namespace
}  // namespace frond
