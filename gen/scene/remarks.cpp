#include "scene/remarks.h"

#include <fmt/format.h>

#include <limits>

namespace frond {

namespace {

struct Span {
  Vec3 low{std::numeric_limits<float>::infinity()}, high = -low;

  void add(Vec3 at, float around = 0) {
    low = glm::min(low, at - around);
    high = glm::max(high, at + around);
  }
};

Span span_of(const Specimen& specimen) {
  const Model& b = specimen.model;
  Span span;
  for (std::size_t i = 0; i < b.skeleton.size(); ++i) span.add(b.skeleton.position[i], b.skeleton.radius[i]);
  for (const Vec3& p : b.organs.position) span.add(p);
  for (const Vec3& p : b.blades.surface.position) span.add(p);
  std::vector<Span> shapes(b.solids.shapes.size());
  for (std::size_t s = 0; s < shapes.size(); ++s)
    for (const Vec3& p : b.solids.shapes[s].surface.position) shapes[s].add(p);
  for (std::size_t i = 0; i < b.solids.size(); ++i) {
    const Span& shape = shapes[b.solids.shape[i]];
    if (shape.low.x > shape.high.x) continue;  // it has no mesh
    for (int corner = 0; corner < 8; ++corner) {
      Vec3 at(corner & 1 ? shape.low.x : shape.high.x, corner & 2 ? shape.low.y : shape.high.y,
              corner & 4 ? shape.low.z : shape.high.z);
      span.add(b.solids.position[i] + b.solids.turn[i] * (at * b.solids.scale[i]));
    }
  }
  return span;
}

std::string name_of(const std::string& name, std::size_t entry) {
  return name.empty() ? fmt::format("organism {}", entry) : name;
}

std::vector<Occupied> boxes_of(const Scene& scene) {
  std::vector<Occupied> boxes;
  for (const Specimen& s : scene.specimens) {
    Span span = span_of(s);
    boxes.push_back({name_of(s.name, s.entry), span.low, span.high});
  }
  for (const SownStand& stand : scene.stands)
    for (std::size_t i = 0; i < stand.copies.size(); ++i) {
      // A crown about its foot; how high it is only its model knows.
      auto reach = static_cast<float>(stand.organism.sown->where.radius) * stand.copies.scale[i];
      Vec3 foot = stand.copies.foot[i];
      boxes.push_back({name_of(stand.organism.name, stand.entry), foot - Vec3(reach, 0, reach),
                       foot + Vec3(reach, 0, reach)});
    }
  return boxes;
}

}  // namespace

void note_fit(Scene& scene) {
  for (std::string& note : scene.ground->remarks([&] { return boxes_of(scene); }, scene.stage.camera,
                                                 scene.film.time(scene.film.frames)))
    scene.notes.push_back(std::move(note));
}

}  // namespace frond
