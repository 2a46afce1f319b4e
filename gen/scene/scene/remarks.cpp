#include "scene/remarks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/bounds.h"
#include "scene/camera.h"

namespace frond {

namespace {

std::string name_of(const std::string& name, std::size_t entry) {
  return name.empty() ? fmt::format("organism {}", entry) : name;
}

std::vector<Occupied> boxes_of(const Scene& scene) {
  std::vector<Occupied> boxes;
  for (const Specimen& s : scene.specimens) {
    Bounds box = bounds_of(s.model);
    boxes.push_back({name_of(s.name, s.entry), box.low, box.high});
  }
  for (const CopySet& set : scene.copy_sets)
    for (std::size_t i = 0; i < set.copies.size(); ++i) {
      // A crown about its foot; how high it is only its model knows.
      auto reach = static_cast<float>(set.organism.sown->where.radius) * set.copies.scale[i];
      Vec3 foot = set.copies.foot[i];
      boxes.push_back({name_of(set.organism.name, set.entry), foot - Vec3(reach, 0, reach),
                       foot + Vec3(reach, 0, reach)});
    }
  return boxes;
}

/// Whether anything that grows or stands is in the picture at a time.
bool seen(const Scene& scene, double time) {
  Lens lens = lens_at(scene.setup.camera, time, scene.film.aspect());
  auto in_picture = [&](Vec3 p) {
    Vec3 at = lens.seen(p);
    return at.z > 0 && std::abs(at.x) <= 1 && std::abs(at.y) <= 1;
  };
  auto any = [&](const std::vector<Vec3>& places) { return std::ranges::any_of(places, in_picture); };
  for (const Specimen& s : scene.specimens) {
    const Model& m = s.model;
    if (any(m.skeleton.position) || any(m.organs.position) || any(m.blades.surface.position)) return true;
    for (std::size_t i = 0; i < m.solids.size(); ++i)
      for (const Vec3& p : m.solids.shapes[m.solids.shape[i]].surface.position)
        if (in_picture(m.solids.placed(i, p))) return true;
  }
  for (const CopySet& set : scene.copy_sets)
    for (std::size_t i = 0; i < set.copies.size(); ++i) {
      auto tall = static_cast<float>(set.tallest()) * set.copies.scale[i];
      for (float part : {0.0f, 0.25f, 0.5f, 0.75f})
        if (in_picture(set.copies.foot[i] + Vec3(0, part * tall, 0))) return true;
    }
  return scene.specimens.empty() && scene.copy_sets.empty();
}

}  // namespace

void note_fit(Scene& scene) {
  const Film& film = scene.film;
  if (!seen(scene, film.time(1)) && !seen(scene, film.time((1 + film.frames) / 2)) &&
      !seen(scene, film.time(film.frames)))
    scene.notes.push_back(
        "/scene/camera: nothing that grows is in the picture; expected another look_at, or a \"fit\"");
  for (std::string& note : scene.ground->remarks([&] { return boxes_of(scene); }, scene.setup.camera,
                                                 scene.film.time(scene.film.frames)))
    scene.notes.push_back(std::move(note));
}

}  // namespace frond
