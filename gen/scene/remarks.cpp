#include "scene/remarks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace frond {

namespace {

struct Span {
  Vec3 low{std::numeric_limits<float>::infinity()}, high = -low;

  void add(Vec3 at, float around = 0) {
    low = glm::min(low, at - around);
    high = glm::max(high, at + around);
  }
  bool holds(Vec3 at) const { return glm::all(glm::lessThan(low, at)) && glm::all(glm::lessThan(at, high)); }
};

Span span_of(const Branches& b) {
  Span span;
  for (std::size_t i = 0; i < b.rest.size(); ++i) span.add(b.rest.position[i], b.rest.radius[i]);
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

/// Where the main light hangs at a time; as Studio_Setting of povinc/frond_studio.inc has it.
Vec3 lamp_at(const Stage& stage, double time) {
  Vec3 look = stage.camera.look_at.at(time);
  float far = std::max(1.0f, glm::distance(stage.camera.location.at(time), look));
  return look + glm::normalize(stage.studio.key) * (2.6f * far);
}

}  // namespace

void note_studio(Scene& scene) {
  if (scene.stage.setting != Setting::studio) return;
  double wall = scene.stage.studio.distance, farthest = 0;
  std::string which;
  auto reaches = [&](double back, const std::string& name) {
    if (back > farthest) farthest = back, which = name;
  };
  Vec3 lamps[] = {lamp_at(scene.stage, 0), lamp_at(scene.stage, scene.film.time(scene.film.frames))};
  std::string lit;
  for (const Branches& b : scene.branches) {
    Span span = span_of(b);
    reaches(-span.low.z, name_of(b.name, b.entry));
    if (lit.empty() && (span.holds(lamps[0]) || span.holds(lamps[1]))) lit = name_of(b.name, b.entry);
  }
  for (const SownStand& stand : scene.stands)
    for (std::size_t i = 0; i < stand.copies.size(); ++i)
      reaches(stand.organism.sown->where.radius * stand.copies.scale[i] - stand.copies.foot[i].z,
              name_of(stand.organism.name, stand.entry));
  if (farthest > wall)
    scene.notes.push_back(
        fmt::format("{}: reaches {:.2g} m through the studio's wall; studio.distance {:.3g} or more?", which,
                    farthest - wall, std::ceil(farthest * 11) / 10));
  if (!lit.empty())
    scene.notes.push_back(fmt::format(
        "{}: the studio's main light hangs within it; the camera farther from what it looks at?", lit));
}

}  // namespace frond
