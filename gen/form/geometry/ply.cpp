#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "geometry/byte_reader.h"
#include "geometry/mesh_formats.h"
#include "geometry/text_lines.h"

namespace frond {

namespace {

template <class T>
bool read_number(ByteReader& from, double& out) {
  std::optional<T> value = from.read<T>();
  if (value) out = static_cast<double>(*value);
  return value.has_value();
}

/// A type of numbers, by both of its names.
struct Scalar {
  std::string_view name, other;
  bool (*read)(ByteReader&, double& out);
};
constexpr Scalar kScalars[] = {
    {"char", "int8", read_number<std::int8_t>},    {"uchar", "uint8", read_number<std::uint8_t>},
    {"short", "int16", read_number<std::int16_t>}, {"ushort", "uint16", read_number<std::uint16_t>},
    {"int", "int32", read_number<std::int32_t>},   {"uint", "uint32", read_number<std::uint32_t>},
    {"float", "float32", read_number<float>},      {"double", "float64", read_number<double>}};

const Scalar* scalar_named(std::string_view name) {
  auto found =
      std::ranges::find_if(kScalars, [&](const Scalar& s) { return s.name == name || s.other == name; });
  return found == std::end(kScalars) ? nullptr : &*found;
}

struct Property {
  std::string name;
  const Scalar* type = nullptr;
  const Scalar* count = nullptr;  // of a list
};

struct Element {
  std::string name;
  long long count = 0;
  std::vector<Property> properties;
};

/// What a vertex says of itself, by the names that programs give it.
enum Slot { kX, kY, kZ, kNormalX, kNormalY, kNormalZ, kRed, kGreen, kBlue, kU, kV, kSlots };
constexpr std::pair<std::string_view, Slot> kSlotNames[] = {{"x", kX},
                                                            {"y", kY},
                                                            {"z", kZ},
                                                            {"nx", kNormalX},
                                                            {"ny", kNormalY},
                                                            {"nz", kNormalZ},
                                                            {"red", kRed},
                                                            {"green", kGreen},
                                                            {"blue", kBlue},
                                                            {"diffuse_red", kRed},
                                                            {"diffuse_green", kGreen},
                                                            {"diffuse_blue", kBlue},
                                                            {"r", kRed},
                                                            {"g", kGreen},
                                                            {"b", kBlue},
                                                            {"u", kU},
                                                            {"v", kV},
                                                            {"s", kU},
                                                            {"t", kV},
                                                            {"texture_u", kU},
                                                            {"texture_v", kV}};

int slot_of(const std::string& name) {
  auto found = std::ranges::find(kSlotNames, name, &std::pair<std::string_view, Slot>::first);
  return found == std::end(kSlotNames) ? -1 : found->second;
}

class PlyParser {
 public:
  PlyParser(std::string_view bytes, const std::string& name) : rest_(bytes), name_(name) {}

  Result<PolygonMesh> result() {
    if (std::string wrong = read_header(); !wrong.empty())
      return Error{fmt::format("{}:{}", name_, line_), std::move(wrong)};
    body_.emplace(rest_, big_endian_);
    for (const Element& element : elements_)
      if (std::string wrong = read_element(element); !wrong.empty()) return Error{name_, std::move(wrong)};
    if (mesh_.face.empty())
      return error_at(name_,
                      "is a PLY file of {} points without a face; expected a mesh, which the program that "
                      "made it can make of the points",
                      mesh_.place.size());
    for (const PolygonMesh::Corner& corner : mesh_.corner)
      if (corner.place >= mesh_.place.size())
        return error_at(name_, "a face names vertex {}; expected one of the {} that the file has, from 0",
                        corner.place, mesh_.place.size());
    settle_attributes();
    return std::move(mesh_);
  }

 private:
  std::string_view header_line() {
    ++line_;
    return consume_line(rest_);
  }

  std::string read_header() {
    header_line();  // ply
    bool formatted = false;
    while (true) {
      if (rest_.empty()) return "its header has no end; expected `end_header`";
      TextLines line(header_line());
      if (!line.next()) continue;
      std::string_view kind = line.word();
      if (kind == "end_header") break;
      if (kind == "format") {
        std::string_view format = line.word();
        ascii_ = format == "ascii", big_endian_ = format == "binary_big_endian";
        if (!ascii_ && !big_endian_ && format != "binary_little_endian")
          return fmt::format("an unknown format; expected ascii, binary_little_endian or binary_big_endian");
        formatted = true;
      } else if (kind == "element") {
        Element element;
        element.name = line.word();
        std::string_view digits = line.word();
        element.count = consume_as<long long>(digits).value_or(-1);
        if (element.count < 0) return "an element without a number of them";
        elements_.push_back(std::move(element));
      } else if (kind == "property") {
        if (elements_.empty()) return "a property before any element";
        Property property;
        std::string_view type = line.word();
        if (type == "list") {
          property.count = scalar_named(line.word());
          if (!property.count) return "a list whose length has no type that is known";
          type = line.word();
        }
        property.type = scalar_named(type);
        if (!property.type) return "a property of no type that is known; expected one as float, uchar or int";
        property.name = line.word();
        elements_.back().properties.push_back(std::move(property));
      }
    }
    return formatted ? "" : "its header names no format";
  }

  bool read_scalar(const Scalar& type, double& out) {
    if (!ascii_) return type.read(*body_, out);
    rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\r\n"), rest_.size()));
    std::string_view word = rest_.substr(0, rest_.find_first_of(" \t\r\n"));
    rest_.remove_prefix(word.size());
    std::optional<double> number = number_of(word);
    if (number) out = *number;
    return number.has_value();
  }

  /// Keeps of normals, texture coordinates and colours what all vertices have, and what are numbers.
  void settle_attributes() {
    std::size_t count = mesh_.place.size();
    if (mesh_.color.size() != count) mesh_.color.clear();
    if (mesh_.texture.size() != count) mesh_.texture.clear();
    if (mesh_.normal.size() != count) mesh_.normal.clear();
    for (Vec3& color : mesh_.color)
      if (!std::isfinite(glm::dot(color, Vec3(0)))) color = Vec3(0);
    for (PolygonMesh::Corner& corner : mesh_.corner) {
      if (mesh_.texture.empty() || !std::isfinite(glm::dot(mesh_.texture[corner.place], Vec2(0))))
        corner.texture = PolygonMesh::kNone;
      if (mesh_.normal.empty()) corner.normal = PolygonMesh::kNone;
    }
  }

  std::string read_element(const Element& element) {
    if (element.properties.empty()) return {};  // however many
    std::array<bool, kSlots> has{};
    bool vertices = element.name == "vertex", bytes = false;
    for (const Property& p : element.properties)
      if (int slot = slot_of(p.name); vertices && slot >= 0 && !p.count) {
        has[slot] = true;
        if (slot == kRed) bytes = p.type->name == "uchar";
      }
    if (vertices && !(has[kX] && has[kY] && has[kZ])) return "its vertices have no x, y and z";
    for (long long i = 0; i < element.count; ++i) {
      std::array<double, kSlots> slots{};
      for (const Property& p : element.properties) {
        double value = 0;
        if (!read_scalar(p.count ? *p.count : *p.type, value)) return cut_short(element, i);
        if (p.count) {
          if (!read_list(p, value)) return cut_short(element, i);
          if (element.name == "face" && (p.name == "vertex_indices" || p.name == "vertex_index"))
            add_face(list_);
          if (p.name == "vertex_indices" && element.name == "tristrips") add_strips();
        } else if (int slot = slot_of(p.name); vertices && slot >= 0) {
          slots[slot] = value;
        }
      }
      if (vertices && !add_vertex(slots, has, bytes ? 255.0 : 1.0))
        return fmt::format("vertex {} is at no finite place; expected three finite numbers", i);
    }
    return {};
  }

  std::string cut_short(const Element& element, long long read) const {
    return fmt::format("its header promises {} of \"{}\", but the numbers of {} alone can be read",
                       element.count, element.name, read);
  }

  bool read_list(const Property& p, double length) {
    list_.clear();
    if (!(length >= 0) || length > static_cast<double>(ascii_ ? rest_.size() : body_->left())) return false;
    for (long long k = 0; k < static_cast<long long>(length); ++k) {
      double value = 0;
      if (!read_scalar(*p.type, value)) return false;
      list_.push_back(value);
    }
    return true;
  }

  bool add_vertex(const std::array<double, kSlots>& at, const std::array<bool, kSlots>& has, double white) {
    DVec3 place(at[kX], at[kY], at[kZ]);
    if (!(std::abs(place.x) < 1e38 && std::abs(place.y) < 1e38 && std::abs(place.z) < 1e38)) return false;
    mesh_.place.push_back(place);
    if (has[kNormalX] && has[kNormalY] && has[kNormalZ])
      mesh_.normal.emplace_back(at[kNormalX], at[kNormalY], at[kNormalZ]);
    if (has[kRed] && has[kGreen] && has[kBlue])
      mesh_.color.push_back(Vec3(DVec3(at[kRed], at[kGreen], at[kBlue]) / white));
    if (has[kU] && has[kV]) mesh_.texture.emplace_back(at[kU], at[kV]);
    return true;
  }

  void add_face(std::span<const double> indices) {
    if (indices.size() < 3) return;
    mesh_.face.push_back({mesh_.corner.size(), static_cast<std::uint32_t>(indices.size()), 0, 0});
    for (double index : indices) {
      bool there = index >= 0 && index < 2147483647.0;
      auto i = there ? static_cast<std::uint32_t>(index) : ~0u;
      auto also = [&](bool any) { return any && there ? static_cast<std::int32_t>(i) : PolygonMesh::kNone; };
      mesh_.corner.push_back({i, also(!mesh_.texture.empty()), also(!mesh_.normal.empty())});
    }
  }

  /// Strips of triangles, each ended by -1.
  void add_strips() {
    std::vector<double> all = std::move(list_);
    std::size_t first = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (all[i] < 0) first = i + 1;
      if (i < first + 2) continue;
      bool odd = (i - first) % 2 == 1;
      add_face(std::array{all[i - (odd ? 1 : 2)], all[i - (odd ? 2 : 1)], all[i]});
    }
  }

  std::string_view rest_;
  const std::string& name_;
  int line_ = 0;
  bool ascii_ = false, big_endian_ = false;
  std::optional<ByteReader> body_;
  std::vector<Element> elements_;
  std::vector<double> list_;
  PolygonMesh mesh_;
};

}  // namespace

Result<PolygonMesh> read_ply_mesh(std::string_view bytes, const std::string& name) {
  return PlyParser(bytes, name).result();
}

}  // namespace frond
