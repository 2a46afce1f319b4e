#include "geometry/obj.h"

#include <tiny_obj_loader.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "geometry/obj_text.h"

namespace frond {

namespace {

/// The corner of a face as one vertex: a place and a normal that were given apart.
class Vertices {
 public:
  Vertices(const tinyobj::attrib_t& given, Surface& surface) : given_(given), surface_(surface) {}

  /// Index of the vertex, or -1 where the corner names a place that is not there.
  std::int64_t of(const tinyobj::index_t& corner) {
    auto count = static_cast<int>(given_.vertices.size() / 3),
         normals = static_cast<int>(given_.normals.size() / 3);
    if (corner.vertex_index < 0 || corner.vertex_index >= count) return -1;
    int normal = corner.normal_index < normals ? corner.normal_index : -1;
    complete_ = complete_ && normal >= 0;
    auto [place, fresh] = known_.try_emplace({corner.vertex_index, normal}, surface_.position.size());
    if (fresh) {
      surface_.position.push_back(vector(given_.vertices, corner.vertex_index));
      Vec3 up = normal < 0 ? Vec3(0) : vector(given_.normals, normal);
      float length = glm::length(up);
      complete_ = complete_ && length > 0;
      surface_.normal.push_back(length > 0 ? up / length : Vec3(0, 1, 0));
    }
    return static_cast<std::int64_t>(place->second);
  }

  /// Whether every corner had a normal.
  bool complete() const { return complete_; }

 private:
  static Vec3 vector(const std::vector<tinyobj::real_t>& numbers, int index) {
    auto at = static_cast<std::size_t>(index) * 3;
    return {numbers[at], numbers[at + 1], numbers[at + 2]};
  }

  const tinyobj::attrib_t& given_;
  Surface& surface_;
  std::map<std::pair<int, int>, std::size_t> known_;
  bool complete_ = true;
};

/// The same lines, each without its comment.
std::string without_comments(std::string_view text) {
  std::string bare;
  bare.reserve(text.size());
  while (!text.empty()) {
    std::string_view line = text.substr(0, text.find('\n'));
    bare += line.substr(0, line.find('#'));
    if (line.size() < text.size()) bare += '\n';
    text.remove_prefix(std::min(line.size() + 1, text.size()));
  }
  return bare;
}

Errors parse(tinyobj::ObjReader& reader, std::string_view text, const std::string& name) {
  // The library reads no comment behind a face, passes over much of what is wrong, and what it says shows the
  // text.
  std::string bare = without_comments(text);
  if (Errors errors = check_obj(bare, name); !errors.empty()) return errors;
  tinyobj::ObjReaderConfig config;
  config.triangulate = true;
  if (reader.ParseFromString(bare, "", config)) return {};
  return {{name, "is no OBJ file that can be read"}};
}

}  // namespace

Result<Surface> read_obj(std::string_view text, const std::string& name) {
  tinyobj::ObjReader reader;
  if (Errors errors = parse(reader, text, name); !errors.empty()) return errors;
  Surface surface;
  Vertices vertices(reader.GetAttrib(), surface);
  for (const tinyobj::shape_t& shape : reader.GetShapes()) {
    const auto& corners = shape.mesh.indices;
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
      std::int64_t a = vertices.of(corners[i]), b = vertices.of(corners[i + 1]),
                   c = vertices.of(corners[i + 2]);
      if (a < 0 || b < 0 || c < 0) continue;
      auto at = [&](std::int64_t v) { return surface.position[static_cast<std::size_t>(v)]; };
      Vec3 area = glm::cross(at(b) - at(a), at(c) - at(a));
      if (!(glm::dot(area, area) > 0) || !std::isfinite(glm::dot(area, area))) continue;
      surface.triangle.push_back(
          {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b), static_cast<std::uint32_t>(c)});
    }
  }
  if (surface.triangle.empty()) return Error{name, "holds no face that could be drawn"};
  if (!vertices.complete()) set_normals(surface);
  return surface;
}

Result<LineSet> read_obj_lines(std::string_view text, const std::string& name) {
  tinyobj::ObjReader reader;
  if (Errors errors = parse(reader, text, name); !errors.empty()) return errors;
  LineSet set;
  const auto& given = reader.GetAttrib().vertices;
  for (std::size_t i = 0; i + 2 < given.size(); i += 3)
    set.place.emplace_back(given[i], given[i + 1], given[i + 2]);
  auto count = static_cast<int>(set.place.size());
  for (const tinyobj::shape_t& shape : reader.GetShapes()) {
    std::size_t first = 0;
    for (int corners : shape.lines.num_line_vertices) {
      auto last = first + static_cast<std::size_t>(corners);
      for (std::size_t i = first; i + 1 < last && i + 1 < shape.lines.indices.size(); ++i) {
        int a = shape.lines.indices[i].vertex_index, b = shape.lines.indices[i + 1].vertex_index;
        if (a < 0 || b < 0 || a >= count || b >= count) continue;
        set.line.push_back({static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)});
      }
      first = last;
    }
  }
  if (set.line.empty()) return Error{name, "holds no line (`l` element)"};
  return set;
}

Surface to_unit(Surface surface) {
  Vec3 low(INFINITY), high(-INFINITY);
  for (const Vec3& p : surface.position) low = glm::min(low, p), high = glm::max(high, p);
  Vec3 size = high - low;
  float longest = std::max({size.x, size.y, size.z, 1e-20f});
  Vec3 foot((low.x + high.x) / 2, low.y, (low.z + high.z) / 2);
  for (Vec3& p : surface.position) p = (p - foot) / longest;
  return surface;
}

Errors load_unit_mesh(const NamedFile& file, Surface& mesh) {
  Result<Surface> read = read_obj(file.text, file.path.string());
  if (!read) return read.errors();
  mesh = to_unit(std::move(*read));
  return {};
}

}  // namespace frond
