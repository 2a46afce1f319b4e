#include <benchmark/benchmark.h>

#include "core/parallel.h"
#include "creeping/crawl.h"
#include "creeping/swing_paths.h"
#include "creeping/tread.h"
#include "rocks/stone.h"

// Strands on a rock of 82,000 triangles, about one metre wide. Reported as nodes, steps or questions a second
// of the processor, so that other work on the machine counts little.

namespace frond {
namespace {

const Surface& rock() {
  static const Surface surface = stone_surface({Seed{11}, 0.6, 0.2}, 6);
  return surface;
}

const TriangleSurface& host() {
  static const TriangleSurface built = std::move(*TriangleSurface::build(rock()));
  return built;
}

void BuildHost(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(TriangleSurface::build(rock()));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(rock().triangle.size()));
}
BENCHMARK(BuildHost)->Unit(benchmark::kMillisecond);

void Closest(benchmark::State& state) {
  std::vector<DVec3> places;
  for (const Start& s : starts_around(host(), 20000, Vec3(0), 10, Seed{1})) places.push_back(s.place * 1.02);
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(host().closest(places[i++ % places.size()]));
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(Closest);

/// One strand straight on, without anything else.
void Stride(benchmark::State& state) {
  Tread tread = *tread_at(host(), DVec3(0.6, 0.1, 0.2), DVec3(0.3, 0.1, 1), 0.0003);
  for (auto _ : state) tread = stride(host(), tread, 0.004, 0.0003).tread;
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(Stride);

/// Strands that branch, keep apart, hang: as many nodes as are asked for, at the density of ivy on a wall.
void Grow(benchmark::State& state) {
  limit_threads(static_cast<int>(state.range(1)));
  double scale = std::sqrt(2e4 / static_cast<double>(state.range(0)));
  Crawl crawl;
  for (double* metres :
       {&crawl.speed, &crawl.branch_every, &crawl.radius, &crawl.spacing, &crawl.hang_most, &crawl.stiffness})
    *metres *= 0.4 * scale;
  crawl.max_age = 4000;
  crawl.branch_depth = 8;
  crawl.most_nodes = static_cast<std::size_t>(state.range(0));
  auto starts = starts_around(host(), static_cast<int>(12 / scale), Vec3(0), 10, Seed{3});
  std::size_t nodes = 0;
  for (auto _ : state) nodes = grow_strands(host(), starts, crawl, Seed{1}).size();
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(nodes));
  state.counters["nodes"] = static_cast<double>(nodes);
  limit_threads(0);
}
BENCHMARK(Grow)
    ->Args({10'000, 1})
    ->Args({100'000, 1})
    ->Args({200'000, 1})
    ->Args({1'000'000, 1})
    ->Args({200'000, 2})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime();

void Swing(benchmark::State& state) {
  Crawl crawl;
  crawl.let_go = 1;
  Strands s = grow_strands(host(), starts_around(host(), 12, Vec3(0), 10, Seed{3}), crawl, Seed{1});
  std::vector<Vec3> position;
  std::vector<Quat> turn;
  double time = 0;
  for (auto _ : state) swing_strands(s, Breeze{}, time += 0.04, position, turn);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(s.size()));
}
BENCHMARK(Swing);

void SwingByPaths(benchmark::State& state) {
  Crawl crawl;
  crawl.let_go = 1;
  Strands s = grow_strands(host(), starts_around(host(), 12, Vec3(0), 10, Seed{3}), crawl, Seed{1});
  SwingPaths paths = swing_paths(s, {.speed = 2, .film_length = 5}, crawl.stiffness);
  std::vector<Vec3> position;
  std::vector<Quat> turn;
  double time = 0;
  for (auto _ : state) swing_strands(s, paths, time += 0.04, position, turn);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(s.size()));
}
BENCHMARK(SwingByPaths);

}  // namespace
}  // namespace frond
