#include "scene/inside.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/bounds.h"

namespace frond {

namespace {

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

}  // namespace

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

}  // namespace frond
