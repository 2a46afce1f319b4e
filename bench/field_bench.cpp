#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include "field/volume.h"
#include "organisms/coral/coral.h"

// A coral of 100,000 segments, a metre high, at a voxel of 1/500 of its height: to a level set and back to a
// mesh.

namespace frond {
namespace {

constexpr double kVoxel = 1.0 / 500;

const Skeleton& coral() {
  static const Skeleton skeleton = [] {
    CoralParams params;
    params.steps = 8;
    params.smoothing = 4;
    params.height = 1;
    params.internode = 0.03;
    params.thickness.radius = 0.02;
    return *grow_coral(params, Seed{7});
  }();
  return skeleton;
}

void Fuse(benchmark::State& state) {
  BranchVolume boughs = boughs_of(coral(), 1);
  VolumeOptions options{.voxel = kVoxel, .adaptivity = 0.01 * static_cast<double>(state.range(0))};
  std::size_t triangles = 0;
  for (auto _ : state) {
    Result<FusedMesh> mesh = fuse(boughs, options);
    if (!mesh) return state.SkipWithError(mesh.errors()[0].what.c_str());
    triangles = mesh->surface.triangle.size();
  }
  rusage use{};
  getrusage(RUSAGE_SELF, &use);
  state.counters["segments"] = static_cast<double>(boughs.cones.size());
  state.counters["triangles"] = static_cast<double>(triangles);
  state.counters["peak_MB"] = static_cast<double>(use.ru_maxrss) / 1024;
  state.counters["estimated_MB"] = estimate_volume(boughs, kVoxel).bytes / 1e6;
}
BENCHMARK(Fuse)->Arg(0)->Arg(10)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);

void LevelSet(benchmark::State& state) {
  BranchVolume boughs = boughs_of(coral(), static_cast<float>(state.range(0)));
  VolumeOptions options{.voxel = kVoxel};
  double voxels = 0;
  for (auto _ : state) {
    Volume volume = *volume_of(boughs, options);
    voxels = static_cast<double>(volume.active_voxels());
    state.counters["bytes"] = static_cast<double>(volume.bytes());
  }
  state.counters["voxels"] = voxels;
}
BENCHMARK(LevelSet)->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);

void Gather(benchmark::State& state) {
  BranchVolume boughs = boughs_of(coral(), 1);
  for (auto _ : state)
    state.counters["blocks"] = static_cast<double>(gather_blocks(boughs, 0.002f, 0.006f).size());
}
BENCHMARK(Gather)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);

}  // namespace
}  // namespace frond
