#include "scene/nursery.h"

namespace frond {

namespace {

std::size_t bytes_of(const Surface& s) {
  return s.position.size() * 2 * sizeof(Vec3) + s.triangle.size() * sizeof s.triangle[0] +
         s.uv.size() * sizeof(Vec2);
}

/// About, without what is shared.
std::size_t bytes_of(const Model& m) {
  constexpr std::size_t kNode = 34, kOrgan = 72, kPlacement = 44;
  std::size_t bytes = m.skeleton.size() * kNode + m.organs.size() * kOrgan + m.solids.size() * kPlacement;
  bytes += bytes_of(m.blades.surface) + bytes_of(m.hull);
  for (const Prototype& prototype : m.prototypes)
    for (const OrganPart& part : prototype.parts) bytes += bytes_of(part.surface);
  for (const Solid& solid : m.solids.shapes) bytes += bytes_of(solid.surface);
  return bytes;
}

}  // namespace

void Nursery::keep(const std::string& key, std::vector<Specimen> grown) {
  std::size_t bytes = 0;
  for (const Specimen& s : grown) bytes += bytes_of(s.model);
  put(key, std::make_shared<const std::vector<Specimen>>(std::move(grown)), bytes);
}

}  // namespace frond
