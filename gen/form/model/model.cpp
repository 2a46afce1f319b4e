#include "model/model.h"

#include <fmt/format.h>

#include "core/keep.h"

namespace frond {

namespace {

bool finite(Vec3 v) { return std::isfinite(glm::dot(v, v)); }

bool holds(const Skeleton& skeleton, std::int32_t node) {
  return node >= Skeleton::kRoot && node < static_cast<std::int32_t>(skeleton.size());
}

std::string check_organs(const Model& model) {
  const Organs& o = model.organs;
  std::size_t n = o.size();
  if (o.prototype.size() != n || o.turn.size() != n || o.scale.size() != n || o.node.size() != n ||
      o.birth.size() != n || o.color.size() != n || o.id.size() != n)
    return "the arrays of the organs differ in length";
  if (!o.loose.empty() && o.loose.size() != n) return "not every organ knows how loose it is";
  if (!o.supple.empty() && o.supple.size() != n) return "not every organ knows how supple it is";
  for (std::size_t i = 0; i < n; ++i) {
    if (o.prototype[i] >= model.prototypes.size()) return fmt::format("organ {} has no prototype", i);
    if (!finite(o.position[i])) return fmt::format("organ {} is not at a finite place", i);
    if (!(std::abs(glm::length(o.turn[i]) - 1) <= 1e-4f))
      return fmt::format("the turn of organ {} is not of length 1", i);
    if (!(o.scale[i].x > 0 && o.scale[i].y > 0 && o.scale[i].z > 0) || !finite(o.scale[i]))
      return fmt::format("organ {} has no size", i);
    if (!holds(model.skeleton, o.node[i])) return fmt::format("organ {} grows at node {}", i, o.node[i]);
    if (!(o.birth[i] >= 0 && o.birth[i] <= 1)) return fmt::format("organ {} is born at {}", i, o.birth[i]);
  }
  return {};
}

std::string check_blades(const Model& model) {
  const Blades& b = model.blades;
  std::size_t n = b.size();
  if (b.birth.size() != n || b.color.size() != n || b.id.size() != n || b.foot.size() != n ||
      b.first.size() != n + 1)
    return "the arrays of the blades differ in length";
  if (b.first.back() != b.surface.position.size()) return "the blades do not cover their points";
  for (std::size_t i = 0; i < n; ++i) {
    if (b.first[i + 1] < b.first[i] + 3) return fmt::format("blade {} has fewer than three points", i);
    if (!holds(model.skeleton, b.node[i])) return fmt::format("blade {} grows at node {}", i, b.node[i]);
    if (!(b.birth[i] >= 0 && b.birth[i] <= 1)) return fmt::format("blade {} is born at {}", i, b.birth[i]);
  }
  return b.surface.find_fault();
}

}  // namespace

void Organs::reserve(std::size_t count) {
  reserve_all(count, prototype, position, turn, scale, node, birth, color, id);
}

std::string Model::find_fault() const {
  if (std::string fault = skeleton.find_fault(); !fault.empty()) return fault;
  if (!color.empty() && color.size() != skeleton.size()) return "not every node has a colour";
  if (!light.empty() && light.size() != skeleton.size()) return "not every node has its light";
  if (!axes.empty() && axes.size() != skeleton.size()) return "not every node belongs to an axis";
  if (!girth.empty() && girth.size() != skeleton.size()) return "not every node has a girth";
  for (const Prototype& prototype : prototypes) {
    if (prototype.colors.empty()) return "prototype " + prototype.name + " has no colour";
    for (const OrganPart& part : prototype.parts)
      if (std::string fault = part.surface.find_fault(); !fault.empty()) return prototype.name + ": " + fault;
  }
  if (std::string fault = check_organs(*this); !fault.empty()) return fault;
  if (std::string fault = check_blades(*this); !fault.empty()) return fault;
  if (std::string fault = solids.find_fault(); !fault.empty()) return fault;
  return hull.find_fault();
}

float reach_of(const Prototype& organ) {
  float most = 0;
  for (const OrganPart& part : organ.parts) most = std::max(most, reach_of(part.surface.position));
  return most;
}

Bounds bounds_of(const Model& model) {
  Bounds box = bounds_of(model.solids);
  for (std::size_t i = 0; i < model.skeleton.size(); ++i)
    box.extend(model.skeleton.position[i], model.skeleton.radius[i]);
  box.extend(bounds_of(model.organs.position));
  box.extend(bounds_of(model.blades.surface.position));
  return box;
}

float length_of(const Model& model) {
  if (model.skeleton.size() > 1) return model.skeleton.longest();
  if (model.solids.size() == 0) return 0;
  const Vec3 size = bounds_of(model.solids).size();
  return std::max({size.y, size.x / 2, size.z / 2});
}

}  // namespace frond
