#include <benchmark/benchmark.h>

#include "accretion/accretion.h"
#include "core/files.h"
#include "organisms/foliose/foliose.h"
#include "organisms/massive/massive.h"
#include "scene/scene.h"

// Corals that are bodies, as large as those of the studies that their ways of growing were first tried in,
// and a reef of them. The processor time is that of all threads.

namespace frond {
namespace {

void report(benchmark::State& state, const Surface& surface) {
  state.counters["vertices"] = static_cast<double>(surface.position.size());
}

void Brain(benchmark::State& state) {
  MassiveParams params;
  params.across = 0.63, params.height = 0.33, params.lumps = 0.12, params.valley = 0.012,
  params.edge = 0.0028;
  for (auto _ : state) report(state, grow_massive(params, Surroundings(), Seed{4})->solids.shapes[0].surface);
}
BENCHMARK(Brain)->Unit(benchmark::kSecond)->MeasureProcessCPUTime();

void Fingers(benchmark::State& state) {
  Accretion law{.across = 0.17,
                .up = 0.2,
                .layers = 80,
                .edge = 0.0041,
                .light = 0.45,
                .hunger = 2.4,
                .upward = 0.35,
                .lumps = 0.8,
                .lump_size = 0.045};
  for (auto _ : state) report(state, accrete(law, {}, Seed{4}).surface);
}
BENCHMARK(Fingers)->Unit(benchmark::kSecond)->MeasureProcessCPUTime();

void Lettuce(benchmark::State& state) {
  FolioseParams params;
  params.sheets = 12, params.excess = 2.6, params.ruffle = 0.035, params.edge = 0.0036;
  for (auto _ : state) report(state, grow_foliose(params, Surroundings(), Seed{3})->solids.shapes[0].surface);
}
BENCHMARK(Lettuce)->Unit(benchmark::kSecond)->MeasureProcessCPUTime();

void Reef(benchmark::State& state) {
  std::string path = FROND_ROOT "/presets/reef.json";
  Preset preset = *read_preset(*read_file(path), path, {});
  for (auto _ : state) benchmark::DoNotOptimize(build_scene(preset));
}
BENCHMARK(Reef)->Unit(benchmark::kSecond)->MeasureProcessCPUTime();

}  // namespace
}  // namespace frond
