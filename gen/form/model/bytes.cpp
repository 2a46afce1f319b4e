#include "model/bytes.h"

namespace frond {

namespace {

template <class... Lists>
std::size_t sum_of(const Lists&... lists) {
  return (bytes_of(lists) + ...);
}

std::size_t bytes_of_solid(const Solid& solid) {
  std::size_t bytes = sum_of(solid.surface, solid.material.bands, solid.material.picture, solid.material.dead,
                             solid.turned, solid.past, solid.light);
  for (const std::vector<Vec3>& step : solid.past) bytes += sum_of(step);
  if (solid.native) bytes += sum_of(solid.native->blobs.blobs);
  return bytes;
}

}  // namespace

std::size_t bytes_of(const Surface& s) { return sum_of(s.position, s.normal, s.triangle, s.uv); }

std::size_t bytes_of(const Skeleton& s) {
  return sum_of(s.position, s.radius, s.parent, s.distance, s.to_tip, s.birth, s.order);
}

std::size_t bytes_of(const Organs& o) {
  return sum_of(o.prototype, o.position, o.turn, o.scale, o.node, o.birth, o.color, o.id, o.loose, o.supple);
}

std::size_t bytes_of(const Blades& b) {
  return sum_of(b.first, b.node, b.birth, b.color, b.id, b.foot, b.surface);
}

std::size_t bytes_of(const Solids& solids) {
  std::size_t bytes = sum_of(solids.shape, solids.position, solids.turn, solids.scale) +
                      solids.shapes.capacity() * sizeof(Solid);
  for (const Solid& solid : solids.shapes) bytes += bytes_of_solid(solid);
  return bytes;
}

std::size_t bytes_of(const std::vector<Prototype>& prototypes) {
  std::size_t bytes = prototypes.capacity() * sizeof(Prototype);
  for (const Prototype& prototype : prototypes) {
    bytes += sum_of(prototype.name, prototype.colors) + prototype.parts.capacity() * sizeof(OrganPart);
    for (const OrganPart& part : prototype.parts) {
      bytes +=
          bytes_of(part.surface) + bytes_of(part.relief) + part.pictures.capacity() * sizeof(std::string);
      for (const std::string& picture : part.pictures) bytes += bytes_of(picture);
    }
  }
  return bytes;
}

std::size_t bytes_of(const Model& m) {
  std::size_t bytes = sum_of(m.skeleton, m.color, m.girth, m.light, m.axes, m.prototypes, m.organs, m.blades,
                             m.solids, m.hull) +
                      m.notes.capacity() * sizeof(std::string);
  for (const std::string& note : m.notes) bytes += bytes_of(note);
  return bytes;
}

}  // namespace frond
