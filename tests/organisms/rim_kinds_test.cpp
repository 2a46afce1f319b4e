#include <gtest/gtest.h>

#include "closed.h"
#include "core/parallel.h"
#include "crossings.h"
#include "organisms/encrusting/encrusting.h"
#include "organisms/fan/fan.h"
#include "organisms/foliose/foliose.h"
#include "organisms/mushroom/mushroom.h"
#include "organisms/table/table.h"
#include "organisms/tube/tube.h"

namespace frond {
namespace {

std::vector<Model> all_of(Seed seed) {
  std::vector<Model> models;
  Surroundings open;
  models.push_back(*grow_foliose({}, open, seed));
  models.push_back(*grow_foliose({.form = FolioseForm::plate, .tissue = {}, .growth = {}}, open, seed));
  models.push_back(*grow_table({}, open, seed));
  models.push_back(*grow_encrusting({}, open, seed));
  models.push_back(*grow_tube({}, open, seed));
  models.push_back(*grow_mushroom({}, open, seed));
  return models;
}

TEST(RimKinds, AreClosedBodiesWithAPast) {
  for (const Model& model : all_of(Seed{5})) {
    EXPECT_EQ(model.find_fault(), "");
    const Solid& solid = model.solids.shapes.at(0);
    Body body = body_of(solid.surface);
    EXPECT_EQ(body.loose, 0u);
    EXPECT_GT(body.volume, 0);
    EXPECT_EQ(solid.past.size(), 16u);
    EXPECT_EQ(solid.surface.uv.size(), solid.surface.position.size());
  }
}

/// From step to step nothing jumps: by no more than a few times what it may grow.
TEST(RimKinds, NothingPopsAsTheyGrow) {
  for (const Model& model : all_of(Seed{6})) {
    const Solid& solid = model.solids.shapes.at(0);
    Vec3 low(1e9f), high(-1e9f);
    for (Vec3 p : solid.surface.position) low = glm::min(low, p), high = glm::max(high, p);
    float size = glm::length(high - low);
    for (std::size_t k = 0; k < solid.past.size(); ++k) {
      const auto& next = k + 1 < solid.past.size() ? solid.past[k + 1] : solid.surface.position;
      float most = 0;
      for (std::size_t v = 0; v < next.size(); ++v)
        most = std::max(most, glm::distance(next[v], solid.past[k][v]));
      EXPECT_LT(most, 0.22f * size) << "step " << k;
    }
  }
}

/// Such sheets as lettuce_coral, plate_coral and table_coral have.
TEST(RimKinds, SheetsNeverCrossThemselves) {
  FolioseParams lettuce, plate;
  lettuce.sheets = 12, lettuce.excess = 2.6, lettuce.ruffle = 0.035, lettuce.edge = 0.0036;
  plate.form = FolioseForm::plate, plate.across = 0.6, plate.height = 0.32, plate.sheets = 6;
  plate.excess = 1.05, plate.ruffle = 0.2, plate.lobes = 0.2, plate.edge = 0.007;
  auto crossings = [](const Sheet& sheet, double edge) {
    Surface surface;
    surface.position = sheet.position, surface.triangle = sheet.triangle;
    return crossings_of(surface, static_cast<float>(1.6 * edge));
  };
  Surroundings open;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    EXPECT_EQ(crossings(foliose_sheets(plate, open, Seed{seed}), plate.edge), 0u) << seed;
    EXPECT_EQ(crossings(table_sheet({}, open, Seed{seed}), TableParams().edge), 0u) << seed;
  }
  for (std::uint64_t seed : {1, 4, 7, 8})
    EXPECT_EQ(crossings(foliose_sheets(lettuce, open, Seed{seed}), lettuce.edge), 0u) << seed;
}

TEST(RimKinds, AreTheSameOnOneThreadAndOnTwo) {
  limit_threads(1);
  std::vector<Model> one = all_of(Seed{9});
  limit_threads(2);
  std::vector<Model> two = all_of(Seed{9});
  limit_threads(0);
  for (std::size_t i = 0; i < one.size(); ++i)
    EXPECT_EQ(one[i].solids.shapes[0].surface.position, two[i].solids.shapes[0].surface.position);
}

TEST(Fan, IsANetThatFlowsTogether) {
  FanParams params;
  Skeleton fan = grow_fan(params, Seed{2});
  EXPECT_EQ(fan.find_fault(), "");
  EXPECT_GT(fan.size(), 2000u);
  std::size_t roots = 0;
  for (std::size_t i = 0; i < fan.size(); ++i) {
    if (fan.parent[i] == Skeleton::kRoot) {
      ++roots;
      continue;
    }
    auto below = static_cast<std::size_t>(fan.parent[i]);
    EXPECT_LE(fan.radius[i], fan.radius[below] * 1.0001f);
    EXPECT_GE(fan.birth[i], fan.birth[below]);
    EXPECT_LT(std::abs(fan.position[i].z), 0.1 * params.height);
  }
  EXPECT_EQ(roots, 1u);
  EXPECT_EQ(grow_fan(params, Seed{2}).position, fan.position);
}

}  // namespace
}  // namespace frond
