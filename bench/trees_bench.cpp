#include <benchmark/benchmark.h>

#include <cmath>

#include "grove/grove.h"

// Growth by light: groves of ten thousand to a million living internodes. Also the light field by itself.

namespace frond {
namespace {

std::vector<Seedling> grove(int side, float gap) {
  std::vector<Seedling> list;
  for (int i = 0; i < side * side; ++i) {
    Seedling s;
    s.foot = Vec3(static_cast<float>(i % side) * gap, 0, static_cast<float>(i / side) * gap);
    s.seed = Seed{1}.child(static_cast<std::uint64_t>(i));
    list.push_back(s);
  }
  return list;
}

void report(benchmark::State& state, const std::vector<GrownTree>& trees) {
  double living = 0, grown = 0, bytes = 0;
  for (const GrownTree& t : trees) {
    for (std::size_t i = 1; i < t.size(); ++i) living += t.died[i] == GrownTree::kNever;
    grown += static_cast<double>(t.grown);
    bytes += static_cast<double>(t.bytes);
  }
  state.counters["living"] = living;
  state.counters["grown"] = grown;
  state.counters["bytes/living"] = bytes / living;
  state.counters["s/living"] = benchmark::Counter(living * static_cast<double>(state.iterations()),
                                                  benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// trees a side, years, metres between them
void Grow(benchmark::State& state) {
  std::vector<Seedling> list = grove(static_cast<int>(state.range(0)), static_cast<float>(state.range(2)));
  GroveOptions options;
  options.years = static_cast<int>(state.range(1));
  std::vector<GrownTree> trees;
  for (auto _ : state) trees = grow_grove(list, options);
  report(state, trees);
}
BENCHMARK(Grow)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Args({1, 20, 0})
    ->Args({1, 26, 0})
    ->Args({1, 30, 0})
    ->Args({1, 38, 0})
    ->Args({2, 25, 6})
    ->Args({5, 25, 6})
    ->Args({7, 27, 6})
    ->Args({10, 28, 6});

void ExportScene(benchmark::State& state) {
  LightLaw law;
  law.voxel = 0.2;
  law.fading = static_cast<Fading>(state.range(0));
  law.depth = 6;
  std::vector<Shade> shades;
  for (int i = 0; i < 200'000; ++i) {
    Seed s = Seed{3}.child(static_cast<std::uint64_t>(i));
    double angle = s.child(0).range(0, 2 * kPi), r = 8 * std::sqrt(s.child(1).unit());
    shades.push_back(
        {Vec3(static_cast<float>(r * std::cos(angle)), static_cast<float>(s.child(2).range(4, 14)),
              static_cast<float>(r * std::sin(angle))),
         0.01f});
  }
  LightField field(law);
  for (auto _ : state) field.cast(shades, 0);
  state.counters["tiles"] = static_cast<double>(field.tiles());
}
BENCHMARK(ExportScene)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->Arg(static_cast<int>(Fading::diffuse))
    ->Arg(static_cast<int>(Fading::geometric));

}  // namespace
}  // namespace frond
