#include <fmt/format.h>

#include <cmath>
#include <map>
#include <tuple>

#include "core/text.h"
#include "geometry/byte_reader.h"
#include "geometry/mesh_formats.h"
#include "geometry/text_lines.h"

namespace frond {

namespace {

/// Gathers triangles, whose corners share places.
struct Gatherer {
  PolygonMesh mesh;
  std::map<std::tuple<double, double, double>, std::uint32_t> known;
  std::uint32_t part = 0;

  void add_corner(const DVec3& p) {
    auto [place, fresh] =
        known.try_emplace({p.x + 0.0, p.y + 0.0, p.z + 0.0}, static_cast<std::uint32_t>(mesh.place.size()));
    if (fresh) mesh.place.push_back(p);
    mesh.corner.push_back({place->second});
  }
  void add_face(std::size_t first, int line) {
    auto count = static_cast<std::uint32_t>(mesh.corner.size() - first);
    if (count >= 3) mesh.face.push_back({first, count, part, line});
  }
};

Result<PolygonMesh> read_text(std::string_view text, const std::string& name) {
  Gatherer made;
  TextLines lines(text);
  std::size_t first = 0;
  while (lines.next()) {
    std::string kind = lower_case(lines.word());
    if (kind == "solid") made.part = made.mesh.part_of({.object = std::string(lines.others()), .group = {}});
    if (kind == "outer") first = made.mesh.corner.size();
    if (kind == "endloop") made.add_face(first, lines.number()), first = made.mesh.corner.size();
    if (kind != "vertex") continue;
    DVec3 at(0);
    for (int i = 0; i < 3; ++i) {
      std::optional<double> number = number_of(lines.word());
      if (!number)
        return error_at(fmt::format("{}:{}", name, lines.number()),
                        "a vertex whose number {} is none; expected three finite numbers", i + 1);
      at[i] = *number;
    }
    made.add_corner(at);
  }
  return std::move(made.mesh);
}

Result<PolygonMesh> read_binary(std::string_view bytes, const std::string& name) {
  constexpr std::size_t kHead = 80, kFacet = 50;
  ByteReader reader(bytes);
  reader.skip(kHead);
  std::uint32_t count = reader.read<std::uint32_t>().value_or(0);
  if (reader.left() / kFacet < count)
    return error_at(name, "is an STL file that promises {} triangles and holds {}", count,
                    reader.left() / kFacet);
  Gatherer made;
  for (std::uint32_t i = 0; i < count; ++i) {
    std::size_t first = made.mesh.corner.size();
    reader.skip(3 * sizeof(float));  // its normal, which follows from the corners
    for (int k = 0; k < 3; ++k) {
      DVec3 at(0);
      for (int axis = 0; axis < 3; ++axis) at[axis] = static_cast<double>(reader.read<float>().value_or(0));
      if (!std::isfinite(glm::dot(at, at)))
        return error_at(name, "triangle {} has a corner at no finite place", i);
      made.add_corner(at);
    }
    reader.skip(sizeof(std::uint16_t));
    made.add_face(first, 0);
  }
  return std::move(made.mesh);
}

}  // namespace

bool is_binary_stl(std::string_view bytes) {
  if (bytes.size() < 84) return false;
  std::size_t count = ByteReader(bytes.substr(80)).read<std::uint32_t>().value_or(0);
  return bytes.size() == 84 + 50 * count;
}

Result<PolygonMesh> read_stl_mesh(std::string_view bytes, const std::string& name) {
  // A binary one may begin with the word of a text.
  bool text = bytes.size() < 84 || bytes.substr(0, 1024).find("facet") != bytes.npos;
  if (bytes.size() > 84 && is_binary_stl(bytes)) text = false;
  Result<PolygonMesh> mesh = text ? read_text(bytes, name) : read_binary(bytes, name);
  if (mesh && mesh->face.empty()) return Error{name, "is an STL file without a triangle"};
  return mesh;
}

}  // namespace frond
