#include "scene/lawn.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace frond {

namespace {

constexpr double kRadius = 150;  // metres, at least
constexpr double kBeyond = 50;   // metres from what stands farthest out to the edge, at least
constexpr int kTurfShapes = 4;

/// The size of the squares that a piece of ground is covered with: halved up to `kHalvings` times where an
/// edge runs through.
constexpr int kHalvings = 2;

/// Lays squares of `side` metres, in sizes down to side / 2^kHalvings, wherever `edge` (metres to the edge,
/// below 0 inside) says so. Shapes are numbered: kTurfShapes of each size, the largest first.
struct Paving {
  const Heights& heights;
  Seed seed;
  std::function<double(Vec2)> edge;
  std::vector<TurfInstance>& into;

  void lay(Vec2 at, double side, int halved, Seed own) {
    double away = edge(at), reach = 0.71 * side;
    if (away > reach) return;
    if (away > -reach && halved < kHalvings) {
      float quarter = static_cast<float>(side / 4);
      for (std::uint64_t k = 0; k < 4; ++k)
        lay(at + Vec2(k % 2 ? quarter : -quarter, k / 2 ? quarter : -quarter), side / 2, halved + 1,
            own.child(2 + k));
      return;
    }
    if (away > 0) return;
    double step = side / 2;
    Vec2 slope(static_cast<float>((heights(at.x + step, at.y) - heights(at.x - step, at.y)) / side),
               static_cast<float>((heights(at.x, at.y + step) - heights(at.x, at.y - step)) / side));
    int shape = kTurfShapes * halved + static_cast<int>(own.child(0).bits() % kTurfShapes);
    double turn = kPi / 2 * static_cast<double>(own.child(1).bits() % 4);
    into.push_back({shape, Vec3(at.x, static_cast<float>(heights(at.x, at.y)), at.y), turn, slope});
  }
};

/// Covers the middle of a meadow with patches of grass.
void sow(Scene& scene, const Heights& heights, Seed seed) {
  const Meadow& meadow = scene.stage.meadow;
  if (meadow.blade <= 0 || meadow.blades <= 0) return;
  double thin = scene.film.quality == Quality::draft ? 0.6 : 1.0, side = 5 * meadow.blade;
  const Plot& plot = scene.plot;
  int sizes = plot.has_pond() || plot.has_path() ? kHalvings + 1 : 1;
  for (int i = 0; i < kTurfShapes * sizes; ++i) {
    TurfShape shape{1.12 * side / (1 << i / kTurfShapes), meadow.blade, meadow.blades * thin,
                    meadow.flowers / thin};
    scene.turf.push_back(turf_surface(shape, seed.child("shape").child(static_cast<std::uint64_t>(i))));
  }
  auto edge = [&](Vec2 at) {
    double path = plot.has_path() ? plot.path_distance(at) : 1e6;
    return std::max(-path, 0.02 - plot.pond_distance(at));
  };
  Paving paving{heights, seed, edge, scene.turf_instances};
  int reach = static_cast<int>(std::ceil(meadow.extent / side));
  for (int row = -reach; row <= reach; ++row) {
    for (int column = -reach; column <= reach; ++column) {
      double x = column * side, z = row * side;
      if (x * x + z * z > meadow.extent * meadow.extent) continue;
      Seed own = seed.child("patch").child(
          static_cast<std::uint64_t>((row + reach) * (2 * reach + 1) + column + reach));
      paving.lay(Vec2(x, z), side, 0, own);
    }
  }
}

/// Covers the path of a garden with gravel.
void gravel(Scene& scene, const Heights& heights, Seed seed) {
  const Plot& plot = scene.plot;
  if (!plot.has_path()) return;
  const Garden& garden = scene.stage.garden;
  double side = 10 * garden.gravel;
  for (int i = 0; i < kTurfShapes * (kHalvings + 1); ++i)
    scene.gravel.push_back(gravel_surface(1.06 * side / (1 << i / kTurfShapes), garden.gravel,
                                          seed.child("shape").child(static_cast<std::uint64_t>(i))));
  Vec2 low = plot.way()[0], high = low;
  for (Vec2 at : plot.way()) low = glm::min(low, at), high = glm::max(high, at);
  double margin = garden.path.width;
  // A path that leads across the pond, over a bridge, ends at the shores.
  auto edge = [&](Vec2 at) { return std::max(plot.path_distance(at), 0.1 - plot.pond_distance(at)); };
  Paving paving{heights, seed, edge, scene.gravel_instances};
  auto columns = static_cast<int>(std::ceil((high.x - low.x + 2 * margin) / side)),
       rows = static_cast<int>(std::ceil((high.y - low.y + 2 * margin) / side));
  for (int i = 0; i <= rows * columns; ++i) {
    Vec2 at(low.x - margin + (i % columns) * side, low.y - margin + (i / columns) * side);
    paving.lay(at, side, 0, seed.child("patch", static_cast<std::uint64_t>(i)));
  }
}

}  // namespace

void lay_lawn(Scene& scene, const Ground& ground, double reach, Seed seed) {
  double radius = std::max(kRadius, reach + kBeyond), finer = std::sqrt(radius / kRadius);
  auto rings = [&](int usual) { return static_cast<int>(std::lround(usual * finer)); };
  if (scene.stage.setting == Setting::meadow) {
    scene.floor = ground_surface(ground, Vec2(0), radius, rings(110));
    return;
  }
  const Garden& garden = scene.stage.garden;
  scene.plot = Plot(garden.pond, garden.path, seed.child("plot"));
  auto height = [&](Vec2 at) {
    double lawn = ground_height(ground, at.x, at.y) * (1 - smooth_step(0.6, 1.0, glm::length(at) / radius));
    return scene.plot.height(at, lawn);
  };
  scene.floor = ground_surface(height, Vec2(0), radius, rings(150));
  Solids lilies = water_lilies(scene.plot, garden.lilies, seed.child("lilies"));
  if (lilies.size() == 0) return;
  Branches& pads = scene.branches.emplace_back();
  pads.name = "water lilies";
  pads.entry = SIZE_MAX;  // of no organism
  pads.solids = std::move(lilies);
}

void cover_lawn(Scene& scene, const Heights& heights, Seed seed) {
  sow(scene, heights, seed.child("turf"));
  gravel(scene, heights, seed.child("gravel"));
}

}  // namespace frond
