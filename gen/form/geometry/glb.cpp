#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <limits>
#include <nlohmann/json.hpp>
#include <type_traits>

#include "core/linear.h"
#include "geometry/byte_reader.h"
#include "geometry/mesh_formats.h"

namespace frond {

namespace {

using Json = nlohmann::json;

/// What is not as glTF has it, thrown within this file alone.
struct Fault {
  std::string what;
};

enum Mode { kTriangles = 4, kStrip, kFan };

/// A description, which nests no deeper than any that is meant: to copy or free one takes the stack.
Json parsed(std::string_view text) {
  constexpr int kDeepest = 200;
  return Json::parse(text, [](int depth, Json::parse_event_t, const Json&) {
    if (depth > kDeepest) throw Fault{"has a description that nests too deeply"};
    return true;
  });
}

/// A type of the numbers of an accessor.
struct Component {
  int code;
  std::size_t bytes;
  double largest;  // of those that may be normalized; else 1
  double (*read)(ByteReader&);
};

template <class T>
constexpr Component component(int code) {
  double largest = 1;
  if constexpr (std::is_integral_v<T> && sizeof(T) < 4) largest = std::numeric_limits<T>::max();
  return {code, sizeof(T), largest,
          [](ByteReader& reader) { return static_cast<double>(reader.read<T>().value_or(0)); }};
}
constexpr Component kComponents[] = {component<std::int8_t>(5120),   component<std::uint8_t>(5121),
                                     component<std::int16_t>(5122),  component<std::uint16_t>(5123),
                                     component<std::uint32_t>(5125), component<float>(5126)};

const Component& component_of(int code) {
  auto found = std::ranges::find(kComponents, code, &Component::code);
  if (found == std::end(kComponents)) throw Fault{"an accessor of no type that is known"};
  return *found;
}

std::size_t width_of(const std::string& type) {
  for (auto [name, width] : {std::pair("SCALAR", 1), {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}})
    if (type == name) return static_cast<std::size_t>(width);
  throw Fault{fmt::format("an accessor of type {} where numbers or vectors are expected", type)};
}

const Vec2 kNoTexture(std::numeric_limits<float>::quiet_NaN());

/// A vector, or another where one of its numbers is none or infinite.
template <class V>
V finite(const V& v, const V& otherwise) {
  return std::isfinite(glm::dot(v, V(0))) ? v : otherwise;
}

class GlbReader {
 public:
  PolygonMesh read(std::string_view bytes) {
    read_chunks(bytes);
    check_extensions();
    for (const Json& m : list("materials")) mesh_.material.push_back(material(m));
    visited_.assign(list("nodes").size(), 0);
    if (list("scenes").empty()) {
      for (std::size_t i = 0; i < list("meshes").size(); ++i) add_mesh(i, glm::dmat4(1), "");
    } else {
      const Json& scene = list("scenes").at(json_.value("scene", std::size_t{0}));
      for (const Json& node : scene.value("nodes", Json::array()))
        add_node(node.get<std::size_t>(), glm::dmat4(1), 0);
    }
    settle_attributes();
    return std::move(mesh_);
  }

 private:
  void read_chunks(std::string_view bytes) {
    constexpr std::uint32_t kJson = 0x4E4F534A, kBinary = 0x004E4942;
    ByteReader reader(bytes);
    reader.skip(4);
    if (reader.read<std::uint32_t>() != 2u)
      throw Fault{"is a GLB file of another version; expected glTF 2.0"};
    reader.skip(4);
    while (reader.left() >= 8) {
      std::uint32_t length = *reader.read<std::uint32_t>(), kind = *reader.read<std::uint32_t>();
      std::string_view chunk = bytes.substr(bytes.size() - reader.left());
      if (!reader.skip(length)) throw Fault{"is a GLB file that ends too early"};
      if (kind == kJson) json_ = parsed(chunk.substr(0, length));
      if (kind == kBinary && binary_.empty()) binary_ = chunk.substr(0, length);
    }
    if (!json_.is_object()) throw Fault{"is a GLB file without its description"};
  }

  void check_extensions() const {
    for (const Json& name : json_.value("extensionsRequired", Json::array())) {
      auto extension = name.get<std::string>();
      if (extension.find("compression") != extension.npos)
        throw Fault{
            fmt::format("is a GLB file compressed by {}, which is not read; expected one exported without "
                        "compression",
                        extension)};
    }
  }

  const Json& list(const char* name) const {
    static const Json kNone = Json::array();
    auto found = json_.find(name);
    return found == json_.end() ? kNone : *found;
  }

  /// The bytes of a view of the file's own buffer.
  std::string_view view(std::size_t index) const {
    const Json& view = list("bufferViews").at(index);
    if (view.at("buffer").get<std::size_t>() != 0 || list("buffers").at(0).contains("uri"))
      throw Fault{"names data in other files; expected a GLB that holds all of it"};
    auto offset = view.value("byteOffset", std::size_t{0}), length = view.at("byteLength").get<std::size_t>();
    if (offset > binary_.size() || length > binary_.size() - offset) throw Fault{"names data beyond its end"};
    return binary_.substr(offset, length);
  }

  /// The numbers of an accessor, one after the other; `width`: how many each entry has.
  std::vector<double> numbers(std::size_t index, std::size_t& width) const {
    constexpr std::size_t kMostSparse = 100'000'000;
    const Json& a = list("accessors").at(index);
    int type = a.at("componentType").get<int>();
    auto count = a.at("count").get<std::size_t>();
    width = width_of(a.at("type").get<std::string>());
    bool normalized = a.value("normalized", false);
    std::vector<double> all;
    if (a.contains("bufferView"))
      all = entries(a, type, width, count, normalized);
    else if (!a.contains("sparse"))
      throw Fault{"has an accessor without data"};
    else if (count > kMostSparse)
      throw Fault{"has a sparse accessor of more than 100 million entries"};
    else
      all.assign(count * width, 0);
    if (a.contains("sparse")) replace_some(all, a["sparse"], type, width, normalized);
    return all;
  }

  /// Puts the values of a sparse accessor in the place of those whose indices it names.
  void replace_some(std::vector<double>& all, const Json& sparse, int type, std::size_t width,
                    bool normalized) const {
    auto count = sparse.at("count").get<std::size_t>();
    const Json& where = sparse.at("indices");
    std::vector<double> places = entries(where, where.at("componentType").get<int>(), 1, count, false);
    std::vector<double> values = entries(sparse.at("values"), type, width, count, normalized);
    for (std::size_t i = 0; i < count; ++i) {
      if (!(places[i] >= 0 && places[i] < static_cast<double>(all.size() / width)))
        throw Fault{"has a sparse accessor that replaces an entry which is not there"};
      std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(i * width), width,
                  all.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(places[i]) * width));
    }
  }

  /// So many entries of a view that `a` names, all numbers one after the other.
  std::vector<double> entries(const Json& a, int type, std::size_t width, std::size_t count,
                              bool normalized) const {
    const Component& component = component_of(type);
    std::size_t each = component.bytes;
    double most = normalized ? component.largest : 1;
    auto which = a.at("bufferView").get<std::size_t>();
    std::string_view bytes = view(which);
    auto stride = list("bufferViews").at(which).value("byteStride", each * width);
    auto offset = a.value("byteOffset", std::size_t{0});
    if (offset > bytes.size()) throw Fault{"names data beyond its end"};
    bytes.remove_prefix(offset);
    if (stride == 0 ||
        (count > 0 && (bytes.size() < each * width || (bytes.size() - each * width) / stride < count - 1)))
      throw Fault{"names data beyond its end"};
    std::vector<double> all;
    all.reserve(count * width);
    for (std::size_t i = 0; i < count; ++i) {
      ByteReader reader(bytes.substr(i * stride));
      for (std::size_t k = 0; k < width; ++k) all.push_back(component.read(reader) / most);
    }
    return all;
  }

  MeshMaterial material(const Json& m) const {
    MeshMaterial made;
    made.name = m.value("name", std::string());
    const Json pbr = m.value("pbrMetallicRoughness", Json::object());
    auto factor = pbr.value("baseColorFactor", std::vector<float>{1, 1, 1, 1});
    if (factor.size() != 4) throw Fault{"has a colour that is none"};
    made.color = srgb(glm::clamp(Vec3(factor[0], factor[1], factor[2]), Vec3(0), Vec3(1)));
    std::string mode = m.value("alphaMode", std::string("OPAQUE"));
    if (mode == "BLEND") made.opacity = static_cast<double>(factor[3]);
    if (!pbr.contains("baseColorTexture")) return made;
    const Json& texture = list("textures").at(pbr["baseColorTexture"].at("index").get<std::size_t>());
    if (!texture.contains("source")) {
      made.picture_name = "a picture in a format of an extension";
      return made;
    }
    const Json& image = list("images").at(texture["source"].get<std::size_t>());
    made.picture_name = image.value("name", image.value("uri", std::string("a picture")));
    if (image.contains("bufferView"))
      made.picture = std::make_shared<const std::string>(view(image["bufferView"].get<std::size_t>()));
    return made;
  }

  static glm::dmat4 placement(const Json& node) {
    if (node.contains("matrix")) {
      auto m = node["matrix"].get<std::array<double, 16>>();
      glm::dmat4 out;
      for (int i = 0; i < 16; ++i) out[i / 4][i % 4] = m[i];
      return out;
    }
    auto t = node.value("translation", std::array<double, 3>{0, 0, 0});
    auto r = node.value("rotation", std::array<double, 4>{0, 0, 0, 1});
    auto s = node.value("scale", std::array<double, 3>{1, 1, 1});
    glm::dmat4 out = glm::mat4_cast(glm::normalize(glm::dquat(r[3], r[0], r[1], r[2])));
    for (int axis = 0; axis < 3; ++axis) out[axis] *= s[axis];
    out[3] = glm::dvec4(t[0], t[1], t[2], 1);
    return out;
  }

  void add_node(std::size_t index, const glm::dmat4& above, int depth) {
    constexpr int kDeepest = 1000;
    const Json& node = list("nodes").at(index);
    if (visited_[index]++ || depth > kDeepest) throw Fault{"has nodes that hang on themselves"};
    glm::dmat4 here = above * placement(node);
    if (node.contains("mesh"))
      add_mesh(node["mesh"].get<std::size_t>(), here, node.value("name", std::string()));
    for (const Json& child : node.value("children", Json::array()))
      add_node(child.get<std::size_t>(), here, depth + 1);
  }

  void add_mesh(std::size_t index, const glm::dmat4& to, const std::string& node) {
    const Json& mesh = list("meshes").at(index);
    for (const Json& primitive : mesh.at("primitives")) {
      int mode = primitive.value("mode", static_cast<int>(kTriangles));
      if (mode < kTriangles || mode > kFan || !primitive.at("attributes").contains("POSITION")) continue;
      std::int32_t material = primitive.value("material", PolygonMesh::kNone);
      if (material < PolygonMesh::kNone || material >= static_cast<std::int32_t>(mesh_.material.size()))
        throw Fault{"names a material that it has not"};
      std::uint32_t part = mesh_.part_of({node, mesh.value("name", std::string()), material});
      add_primitive(primitive, mode, to, part);
    }
  }

  std::vector<double> attribute(const Json& primitive, const char* name, std::size_t least,
                                std::size_t& width) const {
    const Json& attributes = primitive.at("attributes");
    if (!attributes.contains(name)) return {};
    std::vector<double> all = numbers(attributes[name].get<std::size_t>(), width);
    if (width < least) throw Fault{fmt::format("has {} of {} numbers", name, width)};
    return all;
  }

  void add_primitive(const Json& primitive, int mode, const glm::dmat4& to, std::uint32_t part) {
    std::size_t width = 3, first = mesh_.place.size();
    std::vector<double> at = attribute(primitive, "POSITION", 3, width);
    std::size_t count = at.size() / width;
    check_repeated(first + count);
    for (std::size_t i = 0; i < count; ++i) {
      glm::dvec4 p = to * glm::dvec4(at[i * width], at[i * width + 1], at[i * width + 2], 1);
      if (!(std::abs(p.x) < 1e38 && std::abs(p.y) < 1e38 && std::abs(p.z) < 1e38))
        throw Fault{"has a vertex at no finite place"};
      mesh_.place.emplace_back(p);
    }
    glm::dmat3 turn = glm::transpose(glm::inverse(glm::dmat3(to)));
    std::vector<double> normal = attribute(primitive, "NORMAL", 3, width);
    normal_.resize(first, Vec3(0));
    for (std::size_t i = 0; i + 2 < normal.size(); i += width)
      normal_.push_back(Vec3(turn * DVec3(normal[i], normal[i + 1], normal[i + 2])));
    std::vector<double> uv = attribute(primitive, "TEXCOORD_0", 2, width);
    texture_.resize(first, kNoTexture);
    for (std::size_t i = 0; i + 1 < uv.size(); i += width)
      texture_.push_back(finite(Vec2(uv[i], 1 - uv[i + 1]), kNoTexture));
    std::vector<double> color = attribute(primitive, "COLOR_0", 3, width);
    color_.resize(first, Vec3(-1));
    for (std::size_t i = 0; i + 2 < color.size(); i += width) {
      Vec3 light = finite(Vec3(color[i], color[i + 1], color[i + 2]), Vec3(0));
      Color shown = srgb(glm::clamp(light, Vec3(0), Vec3(1)));
      color_.emplace_back(shown.red, shown.green, shown.blue);
    }
    normal_.resize(first + count, Vec3(0));
    texture_.resize(first + count, kNoTexture);
    color_.resize(first + count, Vec3(-1));
    add_faces(indices(primitive, count), mode, first, part, glm::determinant(glm::dmat3(to)) < 0);
  }

  /// Refuses more vertices or triangles than are meant: few bytes may name the same data many times.
  void check_repeated(std::size_t count) const {
    if (count > 10'000'000 + binary_.size())
      throw Fault{"draws the same data so often that it comes to more than 10 million vertices"};
  }

  std::vector<std::uint32_t> indices(const Json& primitive, std::size_t count) const {
    std::vector<std::uint32_t> all;
    if (!primitive.contains("indices")) {
      for (std::uint32_t i = 0; i < count; ++i) all.push_back(i);
      return all;
    }
    std::size_t width = 1;
    for (double index : numbers(primitive["indices"].get<std::size_t>(), width)) {
      if (!(index >= 0 && index < static_cast<double>(count))) throw Fault{"names a vertex that it has not"};
      all.push_back(static_cast<std::uint32_t>(index));
    }
    return all;
  }

  void add_faces(const std::vector<std::uint32_t>& index, int mode, std::size_t first, std::uint32_t part,
                 bool mirrored) {
    check_repeated(mesh_.face.size() + index.size());
    auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      if (mirrored) std::swap(b, c);
      mesh_.face.push_back({mesh_.corner.size(), 3, part, 0});
      for (std::uint32_t i : {a, b, c}) {
        auto place = static_cast<std::uint32_t>(first + i);
        mesh_.corner.push_back({place, static_cast<std::int32_t>(place), static_cast<std::int32_t>(place)});
      }
    };
    for (std::size_t i = 0; i + 2 < index.size(); i += mode == kTriangles ? 3 : 1) {
      if (mode == kFan)
        add(index[0], index[i + 1], index[i + 2]);
      else if (mode == kStrip && i % 2 == 1)
        add(index[i + 1], index[i], index[i + 2]);
      else
        add(index[i], index[i + 1], index[i + 2]);
    }
  }

  /// Keeps what there is of normals, texture coordinates and colours.
  void settle_attributes() {
    for (PolygonMesh::Corner& c : mesh_.corner) {
      if (texture_[c.place].x != texture_[c.place].x) c.texture = PolygonMesh::kNone;
      if (normal_[c.place] == Vec3(0)) c.normal = PolygonMesh::kNone;
    }
    mesh_.normal = std::move(normal_), mesh_.texture = std::move(texture_);
    bool colored = !color_.empty() && std::ranges::all_of(color_, [](const Vec3& c) { return c.x >= 0; });
    if (colored) mesh_.color = std::move(color_);
  }

  Json json_;
  std::string_view binary_;
  std::vector<char> visited_;
  std::vector<Vec3> normal_, color_;
  std::vector<Vec2> texture_;
  PolygonMesh mesh_;
};

}  // namespace

Result<PolygonMesh> read_glb_mesh(std::string_view bytes, const std::string& name) {
  try {
    PolygonMesh mesh = GlbReader().read(bytes);
    if (mesh.face.empty()) return Error{name, "is a GLB file without a triangle"};
    return mesh;
  } catch (const Fault& fault) {
    return Error{name, fault.what};
  } catch (const nlohmann::json::exception&) {
    return Error{name, "is a GLB file whose description is not as glTF has it"};
  }
}

}  // namespace frond
