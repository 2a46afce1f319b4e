#include <benchmark/benchmark.h>

#include "land/sow.h"
#include "land/terrain.h"

namespace frond {
namespace {

TerrainShape hills(double size) {
  TerrainShape shape;
  shape.size = size;
  for (Vec2 at : {Vec2(-300, 20), Vec2(-100, -12), Vec2(-5, 6), Vec2(90, -10), Vec2(300, -30)})
    shape.path.points.emplace_back(at);
  shape.path.width = 2.5;
  return shape;
}

void build_terrain(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(Terrain(hills(160), Seed{1}));
}
BENCHMARK(build_terrain)->Unit(benchmark::kMillisecond);

void ask_height(benchmark::State& state) {
  Terrain land(hills(160), Seed{1});
  std::vector<Vec2> places;
  for (std::uint64_t i = 0; i < 4096; ++i)
    places.emplace_back(Seed{2}.child(2 * i).range(-80, 80), Seed{2}.child(2 * i + 1).range(-80, 80));
  double sum = 0;
  for (auto _ : state)
    for (Vec2 at : places) sum += land.height(at.x, at.y);
  benchmark::DoNotOptimize(sum);
  state.SetItemsProcessed(state.iterations() * 4096);
}
BENCHMARK(ask_height);

/// 10,000 trees of two kinds and 200,000 herbs of three, by all rules, over 600 x 600 m.
void sow_forest(benchmark::State& state) {
  Terrain hill(hills(600), Seed{1});
  Land land;
  land.size = 600;
  land.altitude = [&](Vec2 at) { return hill.height(at.x, at.y) + 8; };
  land.slope = [&](Vec2 at) {
    return std::atan(std::hypot(hill.height(at.x + 0.5, at.y) - hill.height(at.x - 0.5, at.y),
                                hill.height(at.x, at.y + 0.5) - hill.height(at.x, at.y - 0.5)));
  };
  land.path = [&](Vec2 at) { return hill.path_distance(at); };
  std::vector<SowOrder> orders(5);
  for (std::size_t o = 0; o < orders.size(); ++o) {
    SowRules& rules = orders[o].rules;
    orders[o].count = o < 2 ? 5'000 : o < 4 ? 70'000 : 60'000;
    orders[o].size_variation = 0.3;
    orders[o].models = 6;
    orders[o].seed = Seed{3}.child(o);
    rules.layer = o < 2 ? Layer::canopy : Layer::herbs;
    rules.radius = o < 2 ? 1.8 : 0.3;
    rules.stem = 0.1;
    if (o == 1) rules.altitude = {2, 1e4};
    if (o == 2) rules.shade = {0.5, 1};
    if (o == 3) rules.patch = 15, rules.cover = 0.5;
  }
  std::size_t plants = 0;
  for (auto _ : state) {
    plants = 0;
    for (const auto& stand : sow(orders, land)) plants += stand.size();
  }
  state.counters["plants"] = static_cast<double>(plants);
}
BENCHMARK(sow_forest)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace frond
