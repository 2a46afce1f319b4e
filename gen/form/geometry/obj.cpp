#include "geometry/obj.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "core/read_as.h"
#include "core/text.h"
#include "geometry/text_lines.h"

namespace frond {

namespace {

/// How many there are of something, and the furthest of them that was named before it was given.
struct Supply {
  std::string_view what;
  long long count = 0, wanted = 0;
  int line = 0;  ///< on which that was

  /// The index, from 0, of the one that a corner names: by its number from 1, or counted back from the last.
  /// Negative where there can be none.
  std::int32_t index_of(std::string_view digits, int at) {
    constexpr long long kMost = std::numeric_limits<std::int32_t>::max();
    long long index = read_as<long long>(digits).value_or(0);
    if (index == 0 || index < -count || index > kMost) return PolygonMesh::kNone;
    if (index > count && index > wanted) wanted = index, line = at;
    return static_cast<std::int32_t>(index > 0 ? index - 1 : count + index);
  }

  std::string missing() const {
    return fmt::format("a corner names a {} that is not there; expected one of the {} that the file has",
                       what, count);
  }
};

class ObjParser {
 public:
  ObjParser(std::string_view text, const std::string& name) : lines_(text), name_(name) {}

  Errors parse() {
    while (lines_.next())
      if (std::string wrong = line_fault(); !wrong.empty()) return fault(lines_.number(), wrong);
    for (const Supply* supply : {&places_, &normals_})
      if (supply->wanted > supply->count) return fault(supply->line, supply->missing());
    if (colors_.size() == mesh.place.size()) mesh.color = std::move(colors_);
    // Some programs write bytes.
    bool bytes = std::ranges::any_of(mesh.color, [](const Vec3& c) {
      return std::max({c.x, c.y, c.z}) > 1.5f;
    });
    for (Vec3& c : mesh.color) c = bytes ? c / 255.0f : c;
    for (PolygonMesh::Corner& corner : mesh.corner)
      if (corner.texture >= static_cast<std::int32_t>(mesh.texture.size()))
        corner.texture = PolygonMesh::kNone;
    if (curved_ > 0)
      mesh.notes.push_back(
          fmt::format("holds {} free-form curves or surfaces, which are not read; expected the "
                      "mesh that its program makes of them",
                      curved_));
    return {};
  }

  PolygonMesh mesh;
  std::vector<std::array<std::uint32_t, 2>> line;

 private:
  Errors fault(int number, std::string what) const {
    return {{fmt::format("{}:{}", name_, number), std::move(what)}};
  }

  std::string line_fault() {
    std::string kind = lower_case(lines_.word());
    if (kind == "v") return read_place();
    if (kind == "vt") return read_texture(), "";
    if (kind == "vn") return read_normal();
    if (kind == "f" || kind == "fo") return read_corners("face", 3);
    if (kind == "l") return read_corners("line", 2);
    if (kind == "o") object_ = lines_.others(), grouped_ = false;
    if (kind == "g") group_ = lines_.others(), grouped_ = false;
    if (kind == "usemtl") material_ = material_named(lines_.others()), grouped_ = false;
    if (kind == "mtllib") mesh.library.emplace_back(lines_.others());
    if (kind == "curv" || kind == "curv2" || kind == "surf") ++curved_;
    return {};
  }

  std::string read_place() {
    ++places_.count;
    std::array<double, 7> x{};
    int count = 0;
    for (std::string_view word = lines_.word(); !word.empty() && count < 7; word = lines_.word(), ++count) {
      std::optional<double> number = number_of(word);
      if (!number && count < 3) break;
      x[count] = number.value_or(0);
    }
    if (count < 3) return none_of("place", count);
    mesh.place.emplace_back(x[0], x[1], x[2]);
    if (count >= 6) {
      std::size_t red = count == 6 ? 3 : 4;  // behind a weight
      colors_.emplace_back(x[red], x[red + 1], x[red + 2]);
    }
    return {};
  }

  void read_texture() {
    std::optional<double> u = number_of(lines_.word()), v = number_of(lines_.word());
    mesh.texture.emplace_back(u.value_or(0), v.value_or(0));
  }

  std::string read_normal() {
    ++normals_.count;
    Vec3 normal(0);
    for (int i = 0; i < 3; ++i) {
      std::optional<double> number = number_of(lines_.word());
      if (!number) return none_of("normal", i);
      normal[i] = static_cast<float>(*number);
    }
    mesh.normal.push_back(normal);
    return {};
  }

  static std::string none_of(std::string_view what, int before) {
    return fmt::format("a {} whose number {} is none; expected three finite numbers", what, before + 1);
  }

  /// Reads corners written as `place`, `place/picture`, `place//normal` or `place/picture/normal`. Returns
  /// what is wrong with them, or nothing.
  std::string read_corners(std::string_view what, std::uint32_t least) {
    corners_.clear();
    for (std::string_view word = lines_.word(); !word.empty(); word = lines_.word()) {
      PolygonMesh::Corner corner;
      std::size_t slash = std::min(word.find('/'), word.size());
      std::size_t second = word.find('/', std::min(slash + 1, word.size()));
      std::int32_t place = places_.index_of(word.substr(0, slash), lines_.number());
      if (place < 0) return places_.missing();
      corner.place = static_cast<std::uint32_t>(place);
      if (slash < word.size()) {
        Supply given{"picture", static_cast<long long>(mesh.texture.size())};
        corner.texture = given.index_of(word.substr(slash + 1, std::min(second, word.size()) - slash - 1), 0);
      }
      if (std::string_view normal = word.substr(std::min(second, word.size() - 1) + 1);
          second != word.npos && !normal.empty()) {
        corner.normal = normals_.index_of(normal, lines_.number());
        if (corner.normal < 0) return normals_.missing();
      }
      corners_.push_back(corner);
    }
    auto count = static_cast<std::uint32_t>(corners_.size());
    if (count < least) return fmt::format("a {} of {} corners; expected {} or more", what, count, least);
    if (least == 2) {
      for (std::uint32_t i = 0; i + 1 < count; ++i)
        line.push_back({corners_[i].place, corners_[i + 1].place});
      return {};
    }
    if (!grouped_) part_ = mesh.part_of({object_, group_, material_}), grouped_ = true;
    mesh.face.push_back({mesh.corner.size(), count, part_, lines_.number()});
    mesh.corner.insert(mesh.corner.end(), corners_.begin(), corners_.end());
    return {};
  }

  /// The index of the material of that name, which is added if it is new; none for an empty name.
  std::int32_t material_named(std::string_view name) {
    if (name.empty()) return PolygonMesh::kNone;
    auto found = std::ranges::find(mesh.material, name, &MeshMaterial::name);
    if (found == mesh.material.end()) {
      mesh.material.emplace_back().name = name;
      found = std::prev(mesh.material.end());
    }
    return static_cast<std::int32_t>(found - mesh.material.begin());
  }

  TextLines lines_;
  const std::string& name_;
  Supply places_{"place"}, normals_{"normal"};
  std::vector<Vec3> colors_;
  std::vector<PolygonMesh::Corner> corners_;
  std::string object_, group_;
  std::int32_t material_ = PolygonMesh::kNone;
  std::uint32_t part_ = 0;
  bool grouped_ = false;  // whether `part_` is that of the names above
  int curved_ = 0;
};

}  // namespace

Result<PolygonMesh> read_obj_mesh(std::string_view text, const std::string& name) {
  ObjParser parser(text, name);
  if (Errors errors = parser.parse(); !errors.empty()) return errors;
  return std::move(parser.mesh);
}

Result<LineSet> read_obj_lines(std::string_view text, const std::string& name) {
  ObjParser parser(text, name);
  if (Errors errors = parser.parse(); !errors.empty()) return errors;
  if (parser.line.empty()) return Error{name, "holds no line (`l` element)"};
  return LineSet{std::move(parser.mesh.place), std::move(parser.line)};
}

}  // namespace frond
