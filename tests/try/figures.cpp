#include <fmt/format.h>

#include "core/files.h"
#include "scene/scene.h"

// What a preset's first organism has grown to, as JSON, for the test of the page:
//   try_figures PRESET [/json/pointer=value]...

using namespace frond;

int main(int count, char** words) {
  Result<std::string> text = read_file(words[1]);
  Result<Preset> preset = text ? read_preset(*text, words[1], {words + 2, words + count}) : text.errors();
  Result<Scene> scene = preset ? build_scene(*preset) : preset.errors();
  if (!scene) {
    for (const Error& error : scene.errors()) fmt::print(stderr, "{}: {}\n", error.where, error.what);
    return 1;
  }
  const Model& model = scene->specimens[0].model;
  const Skeleton& s = model.skeleton;
  DVec3 sum(0);
  double radii = 0, height = 0, segments = 0;
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (s.parent[i] == Skeleton::kRoot) continue;
    ++segments, sum += DVec3(s.position[i]), radii += s.radius[i];
    height = std::max<double>(height, s.position[i].y);
  }
  double triangles = 0, vertices = 0;
  DVec3 places(0);
  for (std::size_t i = 0; i < model.solids.size(); ++i) {
    const Surface& surface = model.solids.shapes[model.solids.shape[i]].surface;
    triangles += static_cast<double>(surface.triangle.size());
    vertices += static_cast<double>(surface.position.size());
    for (Vec3 at : surface.position) places += DVec3(model.solids.placed(i, at));
  }
  fmt::print(R"({{"segments": {}, "height": {}, "sum": [{}, {}, {}], "radii": {}, "organs": {}, )", segments,
             height, sum.x, sum.y, sum.z, radii, model.organs.size());
  fmt::print(R"("triangles": {}, "vertices": {}, "places": [{}, {}, {}]}})", triangles, vertices, places.x,
             places.y, places.z);
}
