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

constexpr int kMostAsked = 40;   // moments of a film
constexpr double kInside = 0.5;  // of a turn round the place, from which on it counts as inside

struct Glance {
  double time;
  Vec3 at;  ///< where the camera is
};

/// Glances from the first frame to the last; one where the camera stands still.
std::vector<Glance> glances_of(const Camera& camera, const Film& film) {
  int count = camera.location.constant() ? 1 : std::min(film.frames, kMostAsked);
  std::vector<Glance> glances;
  for (int i = 0; i < count; ++i) {
    int frame = count > 1 ? 1 + (film.frames - 1) * i / (count - 1) : film.frames;
    glances.push_back({film.time(frame), camera.location.at(film.time(frame))});
  }
  return glances;
}

bool holds(const Bounds& box, Vec3 at) {
  return glm::all(glm::lessThan(box.low, at)) && glm::all(glm::lessThan(at, box.high));
}

/// Whether a place lies in the wood of a branch.
bool in_branch(const Skeleton& s, Vec3 at) {
  for (std::size_t i = 0; i < s.size(); ++i) {
    std::int32_t p = s.parent[i];
    if (p == Skeleton::kRoot) continue;
    Vec3 from = s.position[static_cast<std::size_t>(p)], offset = s.position[i] - from;
    float along = glm::dot(at - from, offset) / std::max(glm::dot(offset, offset), 1e-12f);
    float radius =
        glm::mix(s.radius[static_cast<std::size_t>(p)], s.radius[i], glm::clamp(along, 0.0f, 1.0f));
    if (along >= 0 && along <= 1 && glm::distance(at, from + offset * along) < radius) return true;
  }
  return false;
}

/// How often a closed surface goes round a place: about 1 inside of it, 0 outside, in between near the gaps
/// of one that is not quite closed (Jacobson, Kavan and Sorkine-Hornung 2013).
double winding_number(const Surface& surface, Vec3 place) {
  double turns = 0;
  const DVec3 eye(place);
  for (auto [i, j, k] : surface.triangle) {
    DVec3 a = DVec3(surface.position[i]) - eye, b = DVec3(surface.position[j]) - eye,
          c = DVec3(surface.position[k]) - eye;
    double x = glm::length(a), y = glm::length(b), z = glm::length(c);
    // The solid angle of a triangle (van Oosterom and Strackee 1983).
    turns += std::atan2(glm::dot(a, glm::cross(b, c)),
                        x * y * z + glm::dot(a, b) * z + glm::dot(b, c) * x + glm::dot(c, a) * y);
  }
  return std::abs(turns) / (2 * kPi);
}

/// The first glance at which the camera is inside of a specimen; nullptr: never.
const Glance* glance_inside(const Specimen& specimen, const std::vector<Glance>& glances) {
  const Model& m = specimen.model;
  const Bounds box = rough_bounds_of(m.solids);
  bool grows = specimen.motion.growth.duration > 0 || specimen.life.develop;
  Surface skin;
  for (const Glance& glance : glances) {
    if (grows && &glance != &glances.back()) continue;
    if (in_branch(m.skeleton, glance.at)) return &glance;
    if (box.empty() || !holds(box, glance.at)) continue;
    if (skin.triangle.empty()) skin = skin_of(m);
    if (winding_number(skin, glance.at) > kInside) return &glance;
  }
  return nullptr;
}

const Glance* glance_inside(const ScatteredInstances& stones, const std::vector<Glance>& glances) {
  const Bounds box = bounds_of(stones.shape->position);
  for (const Glance& glance : glances)
    for (const ScatteredInstances::At& stone : stones.at) {
      Vec3 at = glm::conjugate(stone.turn) * (glance.at - stone.place) / stone.size;
      if (holds(box, at) && winding_number(*stones.shape, at) > kInside) return &glance;
    }
  return nullptr;
}

/// Says that the camera lies inside of a body, a branch or a stone, which one, and when first; empty where
/// it does not. What grows in the film is asked for at its end only.
std::string inside_something(const Scene& scene) {
  const std::vector<Glance> glances = glances_of(scene.setup.camera, scene.film);
  auto said = [&](const std::string& what, const Glance& glance) {
    std::string when = glances.size() > 1 ? fmt::format(", first at {:.3g} s", glance.time) : "";
    return fmt::format("lies inside of {}{}: nothing else is seen from there", what, when);
  };
  for (const Specimen& s : scene.specimens)
    if (const Glance* glance = glance_inside(s, glances))
      return said(s.name.empty() ? fmt::format("/organisms/{}", s.entry) : fmt::format("\"{}\"", s.name),
                  *glance);
  for (const ScatteredInstances& stones : scene.ground->strewn())
    if (const Glance* glance = glance_inside(stones, glances)) return said("a stone on the ground", *glance);
  return "";
}

/// What to say of a camera that goes under the ground while the film lasts; empty where it does not.
std::string under_ground(const Camera& camera, const Film& film, const Heights& heights) {
  constexpr int kMostFrames = 1000;
  constexpr double kLeast = 0.01;  // metres
  int step = 1 + (film.frames - 1) / kMostFrames;
  double deepest = kLeast, first = -1;
  for (int frame = 1; frame <= film.frames; frame += step) {
    Vec3 at = camera.location.at(film.time(frame));
    double depth = heights(at.x, at.z) - at.y;
    if (depth > kLeast && first < 0) first = film.time(frame);
    deepest = std::max(deepest, depth);
  }
  if (first < 0) return "";
  return fmt::format("lies up to {:.2g} m under the ground, first at {:.3g} s: nothing is seen from there",
                     deepest, first);
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

void note_growth(Scene& scene, const Preset& preset) {
  for (const Specimen& s : scene.specimens)
    for (const std::string& note : s.model.notes) {
      std::string line = s.name.empty() ? note : s.name + ": " + note;
      if (note.starts_with('/')) {  // a pointer below its entry, and what is said of that
        std::size_t end = note.find(": ");
        line = fault_at(preset, fmt::format("/organisms/{}{}", s.entry, note.substr(0, end)),
                        note.substr(end + 2))
                   .text();
      }
      // One of many like it is enough.
      if (std::ranges::find(scene.notes, line) == scene.notes.end()) scene.notes.push_back(line);
    }
  for (const CopySet& set : scene.copy_sets) {
    const Appearance looks = set.organism.grower->appearance();
    if (scene.film.frames > 1 && looks.motion.growth.duration > 0 && looks.season &&
        !set.organism.grower->perennial()) {
      const std::string line =
          set.organism.name +
          ": its growth does nothing, since what is sown and has a season stands as it is";
      if (std::ranges::find(scene.notes, line) == scene.notes.end()) scene.notes.push_back(line);
    }
  }
}

void note_camera(Scene& scene, const Preset& preset) {
  for (const std::string& said :
       {under_ground(scene.setup.camera, preset.film, scene.ground->heights()), inside_something(scene)})
    if (!said.empty()) scene.notes.push_back(fault_at(preset, "/scene/camera/location", said).text());
}

}  // namespace frond
