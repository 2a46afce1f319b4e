#include "land/far_objects.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/noise.h"
#include "core/parallel.h"
#include "land/far_shapes.h"

namespace frond {

namespace {

constexpr double kTreeCell = 6.2, kHedgeCell = 3.6;  // metres from one to the next, about
constexpr double kCrown = 8, kHedgeHeight = 2.4;     // metres
constexpr double kFewestPixels = 3;                  // across a crown
constexpr double kPixelsEach = 45;                   // of the picture for each copy
constexpr double kWoodEdge = 26;                     // metres into a wood that trees stand before its canopy
constexpr double kMantle = 9;                        // metres into a wood that shrubs stand below those
constexpr int kHouseShapes = 4;
constexpr int kMostCells = 100'000;  // more than there are on one side of the middle

/// Adds to a list what `visit(list, seed, place)` adds for each square of a grid that is in view and no
/// farther away than `reach`; each has a seed and a place within.
template <class Visit>
void each_cell(std::vector<FarObject>& all, const FarLand& land, const FarView& view, double cell,
               double reach, Seed seed, const Visit& visit) {
  auto half = static_cast<int>(std::ceil(reach / cell));
  std::vector<std::vector<FarObject>> rows(static_cast<std::size_t>(2 * half + 1));
  parallel_for(rows.size(), [&](std::size_t row) {
    int j = static_cast<int>(row) - half;
    for (int i = -half; i <= half; ++i) {
      Seed own = seed.child(static_cast<std::uint64_t>(j + kMostCells))
                     .child(static_cast<std::uint64_t>(i + kMostCells));
      Vec2 at((i + own.child(0).range(-0.45, 0.45)) * cell, (j + own.child(1).range(-0.45, 0.45)) * cell);
      if (land.edge().outside(at) > 4 && glm::length(at) < reach && view.holds(at)) visit(rows[row], own, at);
    }
  });
  for (const auto& row : rows) all.insert(all.end(), row.begin(), row.end());
}

std::uint64_t shapes_of(FarKind kind) { return kind == FarKind::house ? kHouseShapes : 3; }

FarObject far_object(FarKind kind, const FarLand& land, Vec2 at, Seed own) {
  return {.kind = kind,
          .shape = static_cast<int>(own.child("shape").bits() % shapes_of(kind)),
          .foot = Vec3(at.x, land.height(at), at.y),
          .turn = static_cast<float>(own.child("turn").range(0, 2 * kPi)),
          .tint = static_cast<int>(own.child("tint").bits() % kFarTints)};
}

FarObject far_tree(const FarLand& land, Vec2 at, bool conifer, double tallest, Seed own) {
  FarObject tree = far_object(conifer ? FarKind::conifer : FarKind::broadleaf, land, at, own);
  double height = tallest * own.child("height").range(0.65, 1.1);
  double wide = height * own.child("wide").range(0.85, 1.2);
  tree.size = Vec3(wide, height, wide);
  return tree;
}

void add_trees(std::vector<FarObject>& all, const FarLand& land, const FarView& view, double reach,
               Seed seed) {
  auto level = static_cast<float>(seed.child("conifers").range(0, 99));
  // Where nothing is wooded and no border has a hedge, it is open land: no tree stands alone either.
  const double single = land.shape().woods > 0 || land.shape().hedges > 0 ? 0.004 : 0;
  auto plant = [&](auto& list, Seed own, Vec2 at) {
    double roll = own.child("there").unit();
    if (roll > 0.9) return;
    Parcel parcel = land.parcel(at);
    bool wooded = land.wooded(parcel), bordered = parcel.border.child("hedge").unit() < land.shape().hedges;
    // Some stand out of the canopy.
    bool edge = (parcel.edge < kWoodEdge && !land.wooded(land.parcel(parcel.next))) ||
                land.edge().outside(at) < kWoodEdge;
    double chance = wooded ? (edge ? 0.9 : 0.04) : bordered && parcel.edge < 4 ? 0.09 : single;
    if (roll > chance || (!wooded && land.edge().outside(at) < 25)) return;
    double height = land.height(at);
    FarCover cover = land.cover(at, parcel, height, land.slope(at, 20));
    bool grass = cover == FarCover::meadow || cover == FarCover::pasture;
    if (wooded ? cover != FarCover::wood : chance < 0.01 && !grass) return;
    bool conifer = wooded && (noise(Vec3(at.x / 400, level, at.y / 400)) > 0.25 || height > 500);
    list.push_back(far_tree(land, at, conifer, !wooded ? 13 : conifer ? 22 : 18, own));
  };
  each_cell(all, land, view, kTreeCell, reach, seed, plant);
}

/// A shrub at the edge of a wood.
FarObject far_shrub(const FarLand& land, Vec2 at, Seed own) {
  FarObject shrub = far_object(FarKind::hedge, land, at, own);
  double height = own.child("height").range(2.0, 5.5);
  shrub.size = Vec3(own.child("wide").range(3, 6.5), height, height);
  return shrub;
}

/// Hedges stand on the borders of parcels, a piece in each square that one crosses; shrubs at the edges of
/// woods, which close what is below their crowns.
void add_hedges(std::vector<FarObject>& all, const FarLand& land, const FarView& view, double reach,
                Seed seed) {
  each_cell(all, land, view, kHedgeCell, reach, seed, [&](auto& list, Seed own, Vec2 at) {
    Parcel parcel = land.parcel(at);
    if (land.wooded(parcel)) {
      bool edge = land.edge().outside(at) < kMantle ||
                  (parcel.edge < kMantle && !land.wooded(land.parcel(parcel.next)));
      if (edge && own.child("there").unit() < 0.95 &&
          land.cover(at, parcel, land.height(at), land.slope(at, 20)) == FarCover::wood)
        list.push_back(far_shrub(land, at, own));
      return;
    }
    if (parcel.edge > 0.5 * kHedgeCell || parcel.border.child("hedge").unit() >= land.shape().hedges) return;
    if (land.edge().outside(at) < 12) return;
    Vec2 toward = glm::normalize(parcel.next - parcel.site);
    at += toward * static_cast<float>(parcel.edge);
    FarObject hedge = far_object(FarKind::hedge, land, at, own);
    hedge.turn = static_cast<float>(std::atan2(toward.x, toward.y));
    double height = kHedgeHeight * own.child("height").range(0.7, 1.3);
    hedge.size = Vec3(2.0 * kHedgeCell, height, height);
    list.push_back(hedge);
  });
}

/// Houses stand to both sides of a road, with their gables to it or along it, and trees behind them.
void add_villages(std::vector<FarObject>& all, const FarLand& land, const FarView& view, double reach) {
  for (const FarLand::Village& village : land.villages()) {
    if (glm::length(village.at) > reach) continue;
    auto count = 4 + static_cast<int>(village.seed.child("houses").bits() % 6);
    Vec2 aside(-village.along.y, village.along.x);
    for (int i = 0; i < 2 * count; ++i) {
      Seed own = village.seed.child("house", static_cast<std::uint64_t>(i));
      double along = (i / 2 - 0.5 * (count - 1)) * 23 + own.child("along").range(-4, 4);
      double away = (i % 2 ? 1 : -1) * own.child("away").range(11, 19);
      Vec2 at = village.at + village.along * static_cast<float>(along) + aside * static_cast<float>(away);
      if (land.edge().outside(at) < 30 || !view.holds(at)) continue;
      FarObject house = far_object(FarKind::house, land, at, own);
      bool gable = own.child("gable").unit() < 0.4;
      house.turn = static_cast<float>(std::atan2(-village.along.y, village.along.x) + (gable ? kPi / 2 : 0) +
                                      own.child("turn").range(-0.08, 0.08));
      all.push_back(house);
      for (std::uint64_t k = 0; k < 3; ++k) {
        Seed tree = own.child("tree", k);
        Vec2 place = at + aside * static_cast<float>((i % 2 ? 1 : -1) * tree.child("away").range(9, 26)) +
                     village.along * static_cast<float>(tree.child("along").range(-12, 12));
        all.push_back(far_tree(land, place, false, 11, tree));
      }
    }
  }
}

}  // namespace

std::vector<Surface> far_shapes(FarKind kind) {
  constexpr std::array<std::array<double, 3>, kHouseShapes> kHouses{
      {{8.5, 7, 3.2}, {11, 8, 3.4}, {12, 8.5, 5.4}, {14, 8, 4}}};  // metres: long, wide, to the eaves
  std::vector<Surface> shapes;
  Seed seed = Seed{1}.child("far shapes", static_cast<std::uint64_t>(kind));
  constexpr std::array kPlants{far_broadleaf, far_conifer, far_hedge};
  for (std::uint64_t i = 0; i < shapes_of(kind); ++i) {
    Seed own = seed.child(i);
    shapes.push_back(kind == FarKind::house ? far_house(kHouses[i][0], kHouses[i][1], kHouses[i][2], own)
                                            : kPlants[static_cast<std::size_t>(kind)](own));
  }
  return shapes;
}

std::vector<FarObject> far_objects(const FarLand& land, const FarView& view, Seed seed) {
  std::vector<FarObject> all;
  double reach = std::min(kCrown / (kFewestPixels * view.pixel), 2500.0);
  if (reach <= land.edge().radius) return all;
  add_villages(all, land, view, reach);
  add_trees(all, land, view, reach, seed.child("trees"));
  add_hedges(all, land, view, 0.45 * reach, seed.child("hedges"));
  std::ranges::stable_sort(all, {}, [](const FarObject& o) { return glm::length(Vec2(o.foot.x, o.foot.z)); });
  all.resize(std::min(all.size(), static_cast<std::size_t>(view.pixels / kPixelsEach)));
  return all;
}

DistantTerrain distant_terrain(const FarLandShape& shape, const GroundEdge& edge, const FarView& view,
                               Seed seed) {
  FarLand land(shape, edge, seed);
  DistantTerrain country{
      edge.radius, land.along(), far_mesh(land, view, seed), {}, far_objects(land, view, seed)};
  for (int kind = 0; kind < kFarKinds; ++kind) {
    bool used = std::ranges::find(country.objects, static_cast<FarKind>(kind), &FarObject::kind) !=
                country.objects.end();
    if (used) country.shapes[static_cast<std::size_t>(kind)] = far_shapes(static_cast<FarKind>(kind));
  }
  return country;
}

}  // namespace frond
