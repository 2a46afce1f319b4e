#include "accretion/accretion.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "accretion/reaction.h"
#include "accretion/refine.h"
#include "closed.h"
#include "core/parallel.h"

namespace frond {
namespace {

Accretion small() {
  return {
      .across = 0.1, .up = 0.14, .layers = 50, .edge = 0.009, .hunger = 2, .lumps = 0.7, .lump_size = 0.03};
}

Surface at_step(const Accreted& skin, std::size_t step) {
  Surface s = skin.surface;
  if (step < skin.past.size()) s.position = skin.past[step];
  return s;
}

TEST(Accretion, StaysOneClosedBodyThatOnlyGrows) {
  for (std::uint64_t seed : {1, 2, 3}) {
    Accreted skin = accrete(small(), {}, Seed{seed});
    Body body = body_of(skin.surface);
    EXPECT_EQ(body.loose, 0u);
    EXPECT_EQ(body.euler, 2);
    double before = 0;
    for (std::size_t step = 0; step <= skin.past.size(); ++step) {
      double volume = volume_of(at_step(skin, step));
      EXPECT_GT(volume, before) << seed << " " << step;
      before = volume;
    }
  }
}

TEST(Accretion, ComesAsFarAsItMay) {
  Accreted skin = accrete(small(), {}, Seed{4});
  float up = 0, across = 0;
  for (const Vec3& p : skin.surface.position) {
    up = std::max(up, p.y);
    across = std::max(across, glm::length(Vec2(p.x, p.z)));
  }
  EXPECT_NEAR(up, 0.14, 0.03);
  EXPECT_NEAR(across, 0.1, 0.03);
}

TEST(Accretion, HungerMakesFingers) {
  Accretion dome = small(), fingers = small();
  dome.hunger = 0, dome.lumps = 0.1, fingers.hunger = 4, fingers.lumps = 1;
  auto spread_out = [](const Accretion& law) {
    Accreted skin = accrete(law, {}, Seed{5});
    return area(skin.surface) / std::pow(volume_of(skin.surface), 2.0 / 3);
  };
  EXPECT_GT(spread_out(fingers), 1.2 * spread_out(dome));
}

TEST(Accretion, KeepsOutOfWhatStandsThere) {
  AccretionWorld wall;
  wall.room = [](Vec3 at, float) { return 0.04f - at.x; };
  Accreted held = accrete(small(), wall, Seed{6}), freed = accrete(small(), {}, Seed{6});
  float most = 0, most_freed = 0;
  for (const Vec3& p : held.surface.position) most = std::max(most, p.x);
  for (const Vec3& p : freed.surface.position) most_freed = std::max(most_freed, p.x);
  EXPECT_LT(most, 0.04f);
  EXPECT_GT(most_freed, 0.07f);
}

TEST(Accretion, IsTheSameOnOneThread) {
  Accreted many = accrete(small(), {}, Seed{7});
  limit_threads(1);
  Accreted one = accrete(small(), {}, Seed{7});
  limit_threads(0);
  EXPECT_EQ(many.surface.position, one.surface.position);
  EXPECT_EQ(many.past, one.past);
}

TEST(Reaction, RidgesComeAsOftenAsAsked) {
  Accretion dome = small();
  dome.hunger = 0, dome.lumps = 0;
  Accreted skin = accrete(dome, {}, Seed{8});
  refine(skin, 1);
  EXPECT_EQ(body_of(skin.surface).loose, 0u);
  auto walls = [&](double wave) {  // edges between valley and ridge
    std::vector<float> tone = react(skin.surface, {.wave = wave, .steps = 1500}, Seed{9});
    EXPECT_LE(*std::ranges::max_element(tone), 1);
    EXPECT_GE(*std::ranges::min_element(tone), 0);
    std::size_t count = 0;
    for (const auto& t : skin.surface.triangle)
      for (std::size_t k = 0; k < 3; ++k) count += (tone[t[k]] < 0.4f) != (tone[t[(k + 1) % 3]] < 0.4f);
    return static_cast<double>(count);
  };
  // Half the wave, twice as much wall.
  EXPECT_NEAR(walls(0.02) / walls(0.04), 2, 0.5);
}

}  // namespace
}  // namespace frond
