#include "land/turf.h"

#include <gtest/gtest.h>

#include <cmath>

#include "land/herb.h"

namespace frond {
namespace {

TurfShape only(MeadowPlant kind) { return {.side = 0.5, .density = 800, .sward = {{kind}}}; }

double highest(const Surface& s) {
  float top = 0;
  for (Vec3 at : s.position) top = std::max(top, at.y);
  return top;
}

TEST(Turf, EachKindIsASoundMeshOfItsOwn) {
  for (MeadowPlant kind :
       {MeadowPlant::grass, MeadowPlant::fescue, MeadowPlant::cocksfoot, MeadowPlant::panicle,
        MeadowPlant::clover, MeadowPlant::daisy, MeadowPlant::buttercup, MeadowPlant::plantain}) {
    Turf turf = turf_surface(only(kind), Seed{3});
    bool grass = kind == MeadowPlant::grass || kind == MeadowPlant::fescue || kind == MeadowPlant::cocksfoot;
    for (const Surface* part : {&turf.blades, &turf.leaves, &turf.flowers}) EXPECT_EQ(part->find_fault(), "");
    EXPECT_FALSE(turf.blades.triangle.empty());
    EXPECT_EQ(turf.leaves.triangle.empty(), grass || kind == MeadowPlant::panicle);
    EXPECT_EQ(turf.flowers.triangle.empty(), grass || kind == MeadowPlant::clover);
  }
}

TEST(Turf, PaniclesStandAboveTheGrassAndFescueIsFine) {
  Turf grass = turf_surface(only(MeadowPlant::grass), Seed{3}),
       panicle = turf_surface(only(MeadowPlant::panicle), Seed{3}),
       fescue = turf_surface(only(MeadowPlant::fescue), Seed{3});
  EXPECT_GT(highest(panicle.flowers), 1.3 * highest(grass.blades));
  EXPECT_LT(area(fescue.blades), 0.6 * area(grass.blades));
}

TEST(Turf, SharesAreKept) {
  TurfShape shape = only(MeadowPlant::grass);
  shape.sward.push_back({MeadowPlant::clover, 1.0 / 3});
  Turf turf = turf_surface(shape, Seed{3});
  // A leaf of clover has 18 triangles, a blade or a stalk 5.
  EXPECT_NEAR(static_cast<double>(turf.leaves.triangle.size()) / 18, 50, 18);
  EXPECT_EQ(turf.blades.triangle.size(), 5u * 200);
}

TEST(Turf, BareEarthHasAlmostNoGrass) {
  TurfShape shape = only(MeadowPlant::grass);
  auto within = [&](bool thin) {
    shape.thin = thin;
    int count = 0;
    Turf turf = turf_surface(shape, Seed{3});
    for (std::size_t i = 0; i < turf.blades.position.size(); i += 7)
      count += glm::length(0.5f * (turf.blades.position[i] + turf.blades.position[i + 1])) < 0.04;
    return count;
  };
  EXPECT_GE(within(false), 2);
  EXPECT_LE(within(true), 1);
  EXPECT_FALSE(turf_surface(shape, Seed{3}).leaves.triangle.empty());
}

TEST(Turf, BlendedPatchesReachIntoTheirNeighboursByHalf) {
  TurfShape shape = only(MeadowPlant::grass);
  shape.blend = 0.2;
  Turf turf = turf_surface(shape, Seed{3});
  float far = 0;
  for (std::size_t i = 0; i < turf.blades.position.size(); i += 7)
    far = std::max(far, std::abs(turf.blades.position[i].x));
  EXPECT_GT(far, 0.26f);
  EXPECT_LT(far, 0.36f);
}

}  // namespace
}  // namespace frond
