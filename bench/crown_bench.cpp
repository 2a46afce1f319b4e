#include <benchmark/benchmark.h>

#include <cmath>

#include "crown/colonize.h"
#include "crown/weber_penn.h"
#include "images/bark.h"
#include "images/leaf.h"

namespace frond {
namespace {

/// Space colonization of a ball; the argument is the number of points.
void colonize_ball(benchmark::State& state) {
  auto points = static_cast<int>(state.range(0));
  double wide = std::cbrt(points / 1000.0);
  auto half = static_cast<float>(wide);
  Envelope ball(EllipsoidCrown{{0, 2 * half, 0}, Vec3(half)});
  Colonization how;
  how.attractors = points;
  how.influence = 0.7;
  how.kill = 0.12;
  how.step = 0.06;
  std::size_t nodes = 0;
  for (auto _ : state) nodes = colonize(ball, how, Seed{1})->size();
  state.counters["nodes"] = static_cast<double>(nodes);
}
BENCHMARK(colonize_ball)->Arg(10'000)->Arg(50'000)->Unit(benchmark::kMillisecond);

void weber_penn(benchmark::State& state) {
  WeberPenn tree;
  tree.levels = 3;
  tree.level[0] = {0, 0, 0, 0, 1, 1, 1, 0, 1, 0, 0, 0, 9, 0, 0, radians(30.0)};
  StemLevel branch{radians(60.0), 0, radians(140.0), 0, 60, 1, 0.35, 0.05, 1, 0, 0, 0, 6, 0, 0,
                   radians(60.0)};
  tree.level[1] = tree.level[2] = tree.level[3] = branch;
  tree.leaves = 20;
  std::size_t nodes = 0, leaves = 0;
  for (auto _ : state) {
    Result<Crown> crown = grow_weber_penn(tree, Seed{1});
    nodes = crown->skeleton.size();
    leaves = crown->leaves.size();
  }
  state.counters["nodes"] = static_cast<double>(nodes);
  state.counters["leaves"] = static_cast<double>(leaves);
}
BENCHMARK(weber_penn)->Unit(benchmark::kMillisecond);

void bark_picture(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(bark_maps({}, 1024, 1024, Seed{1}));
}
BENCHMARK(bark_picture)->Unit(benchmark::kMillisecond);

void sprig_picture(benchmark::State& state) {
  LeafImage leaf;
  leaf.sprig = true;
  for (auto _ : state) benchmark::DoNotOptimize(leaf_picture(leaf, 512, Seed{1}));
}
BENCHMARK(sprig_picture)->Unit(benchmark::kMillisecond);

void leaf_veins(benchmark::State& state) {
  LeafOutline outline = leaf_outline("linden");
  std::size_t points = 0;
  for (auto _ : state) points = grow_veins(outline, 0.022, Seed{1}).size();
  state.counters["points"] = static_cast<double>(points);
}
BENCHMARK(leaf_veins)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace frond
