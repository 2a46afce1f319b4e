#include "geometry/obj.h"

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>

#include "core/bounds.h"
#include "geometry/crease.h"

namespace frond {

namespace {

/// Takes the next word off a line; empty at its end.
std::string_view next_word(std::string_view& line) {
  line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
  std::string_view word = line.substr(0, line.find_first_of(" \t"));
  line.remove_prefix(word.size());
  return word;
}

bool is_number(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double x = 0;
  auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), x);
  return error == std::errc{} && end == word.data() + word.size() && std::isfinite(x) &&
         std::abs(x) <= std::numeric_limits<float>::max();
}

/// How many there are of something, and the furthest of them that was named before it was given.
struct Supply {
  std::string_view what;
  long long count = 0, wanted = 0;
  int line = 0;  ///< on which that was

  /// Whether a corner may name that one: by its number from 1, or counted back from the last.
  bool take(std::string_view digits, int at) {
    long long index = 0;
    auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), index);
    if (error != std::errc{} || end != digits.data() + digits.size() || index == 0 || index < -count)
      return false;
    if (index > count && index > wanted) wanted = index, line = at;
    return true;
  }
};

class Checker {
 public:
  explicit Checker(const std::string& name) : name_(name) {}

  Errors check(std::string_view text) {
    while (!text.empty()) {
      ++line_;
      std::string_view line = text.substr(0, text.find('\n'));
      text.remove_prefix(std::min(line.size() + 1, text.size()));
      if (line.ends_with('\r')) line.remove_suffix(1);
      std::string wrong = line_fault(line);
      if (!wrong.empty()) return fault(line_, wrong);
    }
    for (const Supply* supply : {&places_, &normals_})
      if (supply->wanted > supply->count) return fault(supply->line, missing(*supply));
    return {};
  }

 private:
  Errors fault(int line, std::string what) const {
    return {{fmt::format("{}:{}", name_, line), std::move(what)}};
  }

  static std::string missing(const Supply& supply) {
    return fmt::format("a corner names a {} that is not there; expected one of the {} that the file has",
                       supply.what, supply.count);
  }

  std::string line_fault(std::string_view line) {
    std::string_view kind = next_word(line);
    if (kind == "v") return ++places_.count, numbers_fault(line, "place");
    if (kind == "vn") return ++normals_.count, numbers_fault(line, "normal");
    if (kind == "f") return corners_fault(line, "face", 3);
    if (kind == "l") return corners_fault(line, "line", 2);
    return {};
  }

  static std::string numbers_fault(std::string_view line, std::string_view what) {
    for (int i = 0; i < 3; ++i)
      if (!is_number(next_word(line)))
        return fmt::format("a {} whose number {} is none; expected three finite numbers", what, i + 1);
    return {};
  }

  /// Of corners as `place`, `place/picture`, `place//normal` or `place/picture/normal`.
  std::string corners_fault(std::string_view line, std::string_view what, int least) {
    int count = 0;
    for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
      ++count;
      std::size_t slash = std::min(word.find('/'), word.size());
      std::size_t second = word.find('/', std::min(slash + 1, word.size()));
      if (!places_.take(word.substr(0, slash), line_)) return missing(places_);
      std::string_view normal = word.substr(std::min(second, word.size() - 1) + 1);
      if (second != word.npos && !normal.empty() && !normals_.take(normal, line_)) return missing(normals_);
    }
    if (count >= least) return {};
    return fmt::format("a {} of {} corners; expected {} or more", what, count, least);
  }

  const std::string& name_;
  int line_ = 0;
  Supply places_{"place"}, normals_{"normal"};
};

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

/// What is painted at a corner of a face.
Vec3 paint_of(const tinyobj::attrib_t& given, const tinyobj::index_t& corner) {
  Vec3 paint = kUnpainted;
  auto texture = static_cast<std::size_t>(std::max(corner.texcoord_index, 0)) * 2,
       color = static_cast<std::size_t>(std::max(corner.vertex_index, 0)) * 3;
  if (corner.texcoord_index >= 0 && texture + 1 < given.texcoords.size())
    paint.x = given.texcoords[texture], paint.y = given.texcoords[texture + 1];
  if (color + 2 < given.colors.size())
    paint.z = std::clamp(
        0.2126f * given.colors[color] + 0.7152f * given.colors[color + 1] + 0.0722f * given.colors[color + 2],
        0.0f, 1.0f);
  return paint;
}

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
  if (Errors errors = Checker(name).check(bare); !errors.empty()) return errors;
  tinyobj::ObjReaderConfig config;
  config.triangulate = true;
  config.vertex_color = false;  // none where not all have one
  if (reader.ParseFromString(bare, "", config)) return {};
  return {{name, "is no OBJ file that can be read"}};
}

/// Turns a closed body whose faces all look inward inside out.
void turn_outward(Surface& s) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  double volume = 0;
  for (auto [a, b, c] : s.triangle) {
    volume += glm::dot(DVec3(s.position[a]), glm::cross(DVec3(s.position[b]), DVec3(s.position[c])));
    for (auto edge : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
      if (!edges.insert(edge).second) return;
  }
  if (volume >= 0) return;
  for (auto [from, to] : edges)
    if (!edges.contains({to, from})) return;
  for (auto& triangle : s.triangle) std::swap(triangle[1], triangle[2]);
  for (auto& paint : s.paint) std::swap(paint[1], paint[2]);
}

}  // namespace

Result<Surface> read_obj(std::string_view text, const std::string& name) {
  tinyobj::ObjReader reader;
  if (Errors errors = parse(reader, text, name); !errors.empty()) return errors;
  Surface surface;
  const tinyobj::attrib_t& given = reader.GetAttrib();
  Vertices vertices(given, surface);
  bool painted = !given.texcoords.empty() || !given.colors.empty();
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
      if (painted)
        surface.paint.push_back(
            {paint_of(given, corners[i]), paint_of(given, corners[i + 1]), paint_of(given, corners[i + 2])});
    }
  }
  if (surface.triangle.empty()) return Error{name, "holds no face that could be drawn"};
  if (vertices.complete()) return surface;
  turn_outward(surface);
  constexpr double kSharp =
      40;  // degrees between faces: what is built keeps its edges, what has grown is round
  return creased(surface, radians(kSharp));
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
  Bounds box = bounds_of(surface.position);
  float longest = std::max(box.longest(), 1e-20f);
  Vec3 foot = box.foot();
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
