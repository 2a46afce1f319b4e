#include <benchmark/benchmark.h>

#include "core/files.h"
#include "emit/frame.h"
#include "scene/scene.h"

// A reef of a million nodes, stage by stage. Reported as nodes a second.

namespace frond {
namespace {

const Preset& million() {
  static const Preset preset = [] {
    std::string path = FROND_ROOT "/bench/million.json";
    return *read_preset(*read_file(path), path, {});
  }();
  return preset;
}

const Scene& reef() {
  static const Scene scene = *build_scene(million());
  return scene;
}

void per_node(benchmark::State& state) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(reef().nodes()));
}

void Grow(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(build_scene(million()));
  per_node(state);
}
BENCHMARK(Grow)->Unit(benchmark::kMillisecond)->UseRealTime();

void Pose(benchmark::State& state) {
  frond::Pose pose;
  for (auto _ : state)
    for (const Specimen& b : reef().specimens) pose_skeleton(b.model.skeleton, b.motion, 0.3, pose);
  per_node(state);
}
BENCHMARK(Pose)->Unit(benchmark::kMillisecond)->UseRealTime();

void Emit(benchmark::State& state) {
  std::string layout = *read_file(FROND_ROOT "/templates/frame.pov");
  FrameParts parts = prepare_frames(reef());
  for (auto _ : state) {
    std::string text;
    benchmark::DoNotOptimize(
        write_frame(reef(), parts, layout, 1, [&](std::string_view piece) { text += piece; }));
  }
  per_node(state);
}
BENCHMARK(Emit)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace frond
