#include <benchmark/benchmark.h>

#include <unordered_map>

#include "core/parallel.h"
#include "rocks/blob_surface.h"
#include "rocks/cube_loops.h"

// A rock of six blobs at depth 8: the adaptive octree beside the plain method, which samples the field at
// each point of a full grid, marches each cube and shares vertices by a table.

namespace frond {
namespace {

Blobs rock() { return {random_blobs({}, Seed{3}), Falloff::gaussian, 1}; }

void report(benchmark::State& state, const Surface& surface) {
  state.counters["triangles"] = static_cast<double>(surface.triangle.size());
}

void Octree(benchmark::State& state, double tolerance) {
  Blobs shape = rock();
  limit_threads(static_cast<int>(state.range(1)));
  Surface surface;
  for (auto _ : state) surface = blob_surface(shape, {static_cast<int>(state.range(0)), tolerance});
  limit_threads(0);
  report(state, surface);
}
BENCHMARK_CAPTURE(Octree, adaptive, 0.0003)
    ->Args({6, 1})
    ->Args({8, 1})
    ->Args({8, 2})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(Octree, even, 0.0)
    ->Args({6, 1})
    ->Args({8, 1})
    ->Args({8, 2})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

struct FullGrid {
  const Blobs& shape;
  std::size_t side;
  DVec3 low;
  double width;
  std::vector<double> value;
  std::unordered_map<std::uint64_t, std::uint32_t> vertices;
  Surface surface;

  std::size_t index(std::size_t x, std::size_t y, std::size_t z) const {
    return x + (side + 1) * (y + (side + 1) * z);
  }
  DVec3 place(std::size_t i) const {
    std::size_t n = side + 1;
    return low + width * DVec3(static_cast<double>(i % n), static_cast<double>(i / n % n),
                               static_cast<double>(i / n / n));
  }
  std::uint32_t vertex(std::size_t a, std::size_t b) {
    auto [at, fresh] =
        vertices.try_emplace(std::uint64_t{a} << 32 | b, static_cast<std::uint32_t>(surface.position.size()));
    if (fresh) {
      DVec3 p = glm::mix(place(a), place(b), value[a] / (value[a] - value[b]));
      surface.position.emplace_back(p);
      surface.normal.emplace_back(-glm::normalize(field_gradient(shape, p)));
    }
    return at->second;
  }
  void march(std::size_t x, std::size_t y, std::size_t z) {
    std::size_t corner[8];
    unsigned inside = 0;
    for (unsigned i = 0; i < 8; ++i) {
      corner[i] = index(x + (i & 1), y + (i >> 1 & 1), z + (i >> 2));
      inside |= static_cast<unsigned>(value[corner[i]] > 0) << i;
    }
    for (const auto& loop : CubeLoops::table()[inside]) {
      std::vector<std::uint32_t> ring;
      for (CubeLoops::Step step : loop) {
        auto [a, b] = CubeLoops::edges()[step.edge];
        ring.push_back(vertex(corner[a], corner[b]));
      }
      for (std::size_t i = 2; i < ring.size(); ++i)
        surface.triangle.push_back({ring[0], ring[i - 1], ring[i]});
    }
  }
  void run() {
    value.resize((side + 1) * (side + 1) * (side + 1));
    for (std::size_t i = 0; i < value.size(); ++i) value[i] = field_value(shape, place(i));
    for (std::size_t z = 0; z < side; ++z)
      for (std::size_t y = 0; y < side; ++y)
        for (std::size_t x = 0; x < side; ++x) march(x, y, z);
  }
};

void FullGridOfCubes(benchmark::State& state) {
  Blobs shape = rock();
  Box root = cut_cells(shape, {3, 0.1}).root;
  Surface surface;
  for (auto _ : state) {
    std::size_t side = std::size_t{1} << state.range(0);
    FullGrid grid{shape, side, root.low, root.size().x / static_cast<double>(side), {}, {}, {}};
    grid.run();
    surface = std::move(grid.surface);
  }
  report(state, surface);
}
BENCHMARK(FullGridOfCubes)->Arg(6)->Arg(8)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace frond
