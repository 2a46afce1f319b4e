#include "geometry/crease.h"

#include <cmath>

namespace frond {

namespace {

Vec3 unit_or(Vec3 v, Vec3 otherwise) {
  float length = glm::length(v);
  return length > 0 ? v / length : otherwise;
}

}  // namespace

Surface creased(const Surface& from, double angle, std::vector<std::uint32_t>* source) {
  std::vector<Vec3> area(from.triangle.size());
  std::vector<std::uint32_t> first(from.position.size() + 1, 0), around(from.triangle.size() * 3);
  for (std::size_t f = 0; f < from.triangle.size(); ++f) {
    area[f] = area_of(from, from.triangle[f]);
    for (std::uint32_t v : from.triangle[f]) ++first[v + 1];
  }
  for (std::size_t v = 0; v < from.position.size(); ++v) first[v + 1] += first[v];
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  for (std::size_t f = 0; f < from.triangle.size(); ++f)
    for (std::uint32_t v : from.triangle[f]) around[next[v]++] = static_cast<std::uint32_t>(f);

  // Each corner gets the mean normal of the faces round its vertex that lean no farther from its own face.
  Surface to;
  to.triangle.resize(from.triangle.size());
  float least = static_cast<float>(std::cos(angle));
  std::vector<std::vector<std::uint32_t>> made(from.position.size());
  for (std::size_t f = 0; f < from.triangle.size(); ++f) {
    Vec3 own = unit_or(area[f], Vec3(0, 1, 0));
    for (std::size_t k = 0; k < 3; ++k) {
      std::uint32_t v = from.triangle[f][k];
      Vec3 sum(0);
      for (std::uint32_t i = first[v]; i < first[v + 1]; ++i)
        if (glm::dot(unit_or(area[around[i]], own), own) >= least) sum += area[around[i]];
      Vec3 normal = unit_or(sum, own);
      std::uint32_t found = static_cast<std::uint32_t>(to.position.size());
      for (std::uint32_t other : made[v])
        if (glm::dot(to.normal[other], normal) > 0.99999f) found = other;
      if (found == to.position.size()) {
        made[v].push_back(found);
        to.position.push_back(from.position[v]);
        to.normal.push_back(normal);
        if (source) source->push_back(v);
        if (!from.uv.empty()) to.uv.push_back(from.uv[v]);
      }
      to.triangle[f][k] = found;
    }
  }
  to.paint = from.paint;
  return to;
}

}  // namespace frond
