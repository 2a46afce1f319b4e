#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/bounds.h"
#include "core/figures.h"
#include "core/linear.h"
#include "core/text.h"
#include "export/formats.h"

namespace frond {

namespace {

constexpr int kArrayBuffer = 34962, kElementBuffer = 34963;                  // targets of buffer views
constexpr int kFloat = 5126, kUnsigned = 5125, kShort = 5123, kByte = 5121;  // types of components
constexpr std::string_view kInstancing = "EXT_mesh_gpu_instancing", kLod = "MSFT_lod",
                           kTransmission = "KHR_materials_transmission", kIor = "KHR_materials_ior";

/// `[1,2.5e-9]`: as many digits as it takes to read back the same numbers.
template <class Number>
std::string numbers_text(std::initializer_list<Number> numbers) {
  return fmt::format("[{}]", fmt::join(numbers, ","));
}

/// What must be equal to the floats of the binary part in whatever precision it is read.
std::string exact_text(Vec3 v) { return numbers_text<double>({v.x, v.y, v.z}); }

/// A list of texts with commas between.
template <class Items, class Text>
std::string list(const Items& items, const Text& text_of) {
  std::string text = "[";
  for (const auto& item : items) {
    if (text.size() > 1) text += ',';
    text += text_of(item);
  }
  return text + ']';
}

/// The binary part and what the JSON says of it.
struct BinaryPart {
  std::string bytes;
  std::vector<std::string> views, accessors;

  /// Adds bytes as a view; target 0: not of a mesh.
  std::size_t add_view(std::string_view data, int target) {
    views.push_back(fmt::format(R"({{"buffer":0,"byteOffset":{},"byteLength":{}{}}})", bytes.size(),
                                data.size(), target > 0 ? fmt::format(R"(,"target":{})", target) : ""));
    bytes += data;
    bytes.resize((bytes.size() + 3) / 4 * 4, '\0');  // so that every view stays aligned
    return views.size() - 1;
  }

  /// Adds an array as a view and an accessor of its own; `extra` are further members of the accessor.
  template <class T>
  std::size_t add(std::span<const T> items, int target, int component, std::string_view type,
                  std::size_t elements, std::string_view extra = {}) {
    std::size_t view = add_view({reinterpret_cast<const char*>(items.data()), items.size_bytes()}, target);
    accessors.push_back(fmt::format(R"({{"bufferView":{},"componentType":{},"count":{},"type":"{}"{}}})",
                                    view, component, elements, type, extra));
    return accessors.size() - 1;
  }
};

std::string bounds_text(const std::vector<Vec3>& position) {
  Bounds box = bounds_of(position);
  return fmt::format(R"(,"min":{},"max":{})", exact_text(box.low), exact_text(box.high));
}

/// Places on pictures, whose rows glTF counts from the top: in two bytes each where they lie on one picture.
std::size_t add_uv(BinaryPart& buffer, const std::vector<Vec2>& uv) {
  bool within = std::all_of(uv.begin(), uv.end(),
                            [](Vec2 at) { return at.x >= 0 && at.x <= 1 && at.y >= 0 && at.y <= 1; });
  if (within) {
    std::vector<std::uint16_t> at;
    for (Vec2 p : uv)
      for (float x : {p.x, 1 - p.y}) at.push_back(static_cast<std::uint16_t>(std::lround(x * 65535)));
    return buffer.add(std::span<const std::uint16_t>(at), kArrayBuffer, kShort, "VEC2", uv.size(),
                      ",\"normalized\":true");
  }
  std::vector<Vec2> at;
  for (Vec2 p : uv) at.emplace_back(p.x, 1 - p.y);
  return buffer.add(std::span<const Vec2>(at), kArrayBuffer, kFloat, "VEC2", at.size());
}

std::size_t add_indices(BinaryPart& buffer, const Surface& s) {
  std::size_t n = 3 * s.triangle.size();
  if (s.position.size() > 65535)
    return buffer.add(std::span(s.triangle), kElementBuffer, kUnsigned, "SCALAR", n);
  std::vector<std::uint16_t> small;
  for (const auto& t : s.triangle)
    for (std::uint32_t corner : t) small.push_back(static_cast<std::uint16_t>(corner));
  return buffer.add(std::span<const std::uint16_t>(small), kElementBuffer, kShort, "SCALAR", n);
}

std::string primitive_text(BinaryPart& buffer, const ExportPart& part) {
  const Surface& s = part.surface;
  std::size_t n = s.position.size();
  std::size_t at =
      buffer.add(std::span(s.position), kArrayBuffer, kFloat, "VEC3", n, bounds_text(s.position));
  std::size_t normal = buffer.add(std::span(s.normal), kArrayBuffer, kFloat, "VEC3", n);
  std::string text = fmt::format(R"({{"attributes":{{"POSITION":{},"NORMAL":{})", at, normal);
  if (!s.uv.empty()) text += fmt::format(",\"TEXCOORD_0\":{}", add_uv(buffer, s.uv));
  if (!part.tint.empty())
    text += fmt::format(",\"COLOR_0\":{}", buffer.add(std::span(part.tint), kArrayBuffer, kByte, "VEC4", n,
                                                      ",\"normalized\":true"));
  text += fmt::format(R"(}},"indices":{},"material":{})", add_indices(buffer, s), part.material);
  if (!part.shifts.empty())
    text += ",\"targets\":" + list(part.shifts, [&](const ExportShift& shift) {
              auto add = [&](const std::vector<Vec3>& by, std::string_view bounds) {
                return buffer.add(std::span(by), kArrayBuffer, kFloat, "VEC3", n, bounds);
              };
              std::size_t moved = add(shift.position, bounds_text(shift.position));
              return fmt::format(R"({{"POSITION":{},"NORMAL":{}}})", moved, add(shift.normal, ""));
            });
  return text + '}';
}

/// A level of a mesh; its other shapes are named by their seconds.
std::string mesh_text(BinaryPart& buffer, const std::string& name, const std::vector<ExportPart>& parts,
                      const std::vector<double>& keys) {
  std::string text =
      fmt::format(R"({{"name":"{}","primitives":{})", name,
                  list(parts, [&](const ExportPart& part) { return primitive_text(buffer, part); }));
  if (std::vector<double> shifted(parts[0].shifts.size()); !shifted.empty()) {
    std::copy_n(keys.begin(), shifted.size(), shifted.begin());
    text += ",\"weights\":" + list(shifted, [](double) { return "0"; });
    text += R"(,"extras":{"targetNames":)" +
            list(shifted, [](double time) { return fmt::format("\"{:.3f} s\"", time); });
    text += '}';
  }
  return text + '}';
}

std::string material_text(const ExportMaterial& m) {
  bool picture = m.colors != kNoPicture;
  Vec3 color = linear(picture ? m.factor : m.color);  // as glTF has them
  std::string text = fmt::format(R"({{"name":"{}","pbrMetallicRoughness":{{"baseColorFactor":{})", m.name,
                                 numbers_text<float>({color.x, color.y, color.z, 1}));
  if (picture) text += fmt::format(",\"baseColorTexture\":{{\"index\":{}}}", m.colors);
  // A picture of the roughness says all of it.
  bool rough = m.roughness != kNoPicture;
  text += fmt::format(R"(,"metallicFactor":{:d},"roughnessFactor":{})", m.metal,
                      number_text(rough ? 1 : std::max(0.02, 0.95 - 0.75 * m.gloss), 4));
  if (rough) text += fmt::format(",\"metallicRoughnessTexture\":{{\"index\":{}}}", m.roughness);
  text += '}';
  if (m.normals != kNoPicture) text += fmt::format(",\"normalTexture\":{{\"index\":{}}}", m.normals);
  if (m.leaf) text += ",\"doubleSided\":true";
  if (m.cutout && picture) text += ",\"alphaMode\":\"MASK\",\"alphaCutoff\":0.5";
  if (m.transmission > 0)
    text += fmt::format(R"(,"extensions":{{"{}":{{"transmissionFactor":{}}},"{}":{{"ior":1.5}}}})",
                        kTransmission, m.transmission, kIor);
  return text + '}';
}

std::string name_text(std::string_view name) { return fmt::format("{{\"name\":\"{}\"", name); }

void append_place(std::string& text, const ExportPlacement& p, Vec3 from) {
  if (p.at != from)
    text += ",\"translation\":" + numbers_text({p.at.x - from.x, p.at.y - from.y, p.at.z - from.z});
  if (p.turn != Quat(1, 0, 0, 0))
    text += ",\"rotation\":" + numbers_text({p.turn.x, p.turn.y, p.turn.z, p.turn.w});
  if (p.scale != Vec3(1)) text += ",\"scale\":" + numbers_text({p.scale.x, p.scale.y, p.scale.z});
}

/// The nodes of a scene: one for each group, its meshes below it.
class GlbNodes {
 public:
  GlbNodes(const ExportScene& exported, bool instances, BinaryPart& buffer)
      : scene_(exported), instances_(instances), buffer_(buffer) {
    // Coarser meshes come after all others.
    std::size_t next = exported.meshes.size();
    for (std::size_t m = 0; m < exported.meshes.size(); ++m) {
      std::vector<std::size_t>& levels = index_.emplace_back(1, m);
      for (std::size_t level = 1; level <= exported.meshes[m].coarser.size(); ++level)
        levels.push_back(exported.meshes[m].has_level(level) ? next++ : 0);
    }
    for (std::size_t i = 0; i < exported.placements.size();) {
      std::size_t from = i, group = exported.placements[i].group;
      while (i < exported.placements.size() && exported.placements[i].group == group) ++i;
      add_group(exported.groups[group], std::span(exported.placements).subspan(from, i - from));
    }
  }

  std::vector<std::string> all;
  std::vector<std::size_t> roots, moving;
  bool instanced = false, leveled = false;  // whether there are any

 private:
  std::size_t add(std::string node) {
    all.push_back(std::move(node += '}'));
    return all.size() - 1;
  }

  void add_group(const ExportGroup& group, std::span<const ExportPlacement> placements) {
    bool alone = placements.size() == 1;
    Vec3 from = alone ? Vec3(0) : group.foot;
    std::vector<std::size_t> nodes;
    for (std::size_t i = 0; i < placements.size();) {
      std::size_t first = i, mesh = placements[i].mesh;
      while (i < placements.size() && placements[i].mesh == mesh) ++i;
      std::span<const ExportPlacement> alike = placements.subspan(first, i - first);
      if (instances_ && alike.size() > 1) {
        nodes.push_back(add(instances_text(alike, from)));
        continue;
      }
      for (std::size_t k = 0; k < alike.size(); ++k) {
        std::string number = alike.size() > 1 ? fmt::format("_{}", k + 1) : "";
        std::size_t coarser = group.sown || alone ? scene_.meshes[mesh].coarser.size() : 0;
        std::vector<std::size_t> levels;
        for (std::size_t level = 1; level <= coarser; ++level)
          if (scene_.meshes[mesh].has_level(level))
            levels.push_back(add(placed_text(alike[k], from, number, level)));
        nodes.push_back(add(placed_text(alike[k], from, number, 0) + levels_text(levels)));
        if (scene_.meshes[mesh].moves()) moving.push_back(nodes.back());
      }
    }
    roots.push_back(alone ? nodes[0] : add_organism(group, placements, nodes));
  }

  /// A node of all that one organism is made of, and one for each coarser level.
  std::size_t add_organism(const ExportGroup& group, std::span<const ExportPlacement> placements,
                           const std::vector<std::size_t>& nodes) {
    auto text_of = [&](std::size_t level, const std::vector<std::size_t>& children) {
      std::string node = name_text(group.name + level_name(level));
      append_place(node, {0, group.foot}, Vec3(0));
      return node + fmt::format(",\"children\":[{}]", fmt::join(children, ","));
    };
    std::vector<std::size_t> levels;
    for (std::size_t level = 1; !group.sown; ++level) {
      std::vector<std::size_t> parts;
      for (const ExportPlacement& p : placements)
        if (scene_.meshes[p.mesh].has_level(level))
          parts.push_back(add(placed_text(p, group.foot, "", level)));
      if (parts.empty()) break;
      levels.push_back(add(text_of(level, parts)));
    }
    return add(text_of(0, nodes) + levels_text(levels));
  }

  static std::string level_name(std::size_t level) { return level > 0 ? fmt::format("_LOD{}", level) : ""; }

  std::string placed_text(const ExportPlacement& p, Vec3 from, const std::string& number, std::size_t level) {
    std::string node = name_text(scene_.meshes[p.mesh].name + number + level_name(level));
    node += fmt::format(",\"mesh\":{}", index_[p.mesh][level]);
    append_place(node, p, from);
    return node;
  }

  /// What leads from a node to its coarser levels, the share of the picture beside each from which it will
  /// do.
  std::string levels_text(const std::vector<std::size_t>& levels) {
    if (levels.empty()) return {};
    leveled = true;
    std::vector<double> covers;
    for (std::size_t level = 1; level <= levels.size(); ++level)
      covers.push_back(std::pow(kCoarser, static_cast<double>(level)));
    covers.push_back(0);
    return fmt::format(R"(,"extensions":{{"{}":{{"ids":[{}]}}}},"extras":{{"MSFT_screencoverage":[{}]}})",
                       kLod, fmt::join(levels, ","), fmt::join(covers, ","));
  }

  std::string instances_text(std::span<const ExportPlacement> alike, Vec3 from) {
    std::vector<Vec3> at, scale;
    std::vector<std::array<float, 4>> turn;
    for (const ExportPlacement& p : alike) {
      at.push_back(p.at - from), scale.push_back(p.scale);
      turn.push_back({p.turn.x, p.turn.y, p.turn.z, p.turn.w});
    }
    std::string node = name_text(scene_.meshes[alike[0].mesh].name);
    std::size_t n = alike.size();
    node += fmt::format(
        R"(,"mesh":{},"extensions":{{"{}":{{"attributes":{{"TRANSLATION":{},"ROTATION":{},"SCALE":{}}}}}}})",
        alike[0].mesh, kInstancing, buffer_.add(std::span<const Vec3>(at), 0, kFloat, "VEC3", n),
        buffer_.add(std::span<const std::array<float, 4>>(turn), 0, kFloat, "VEC4", n),
        buffer_.add(std::span<const Vec3>(scale), 0, kFloat, "VEC3", n));
    instanced = true;
    return node;
  }

  const ExportScene& scene_;
  bool instances_;
  BinaryPart& buffer_;
  std::vector<std::vector<std::size_t>> index_;  // of each mesh at each of its levels
};

/// One shape after the other: at its time each has a weight of one, and the last is the mesh itself.
std::string animation_text(BinaryPart& buffer, const std::vector<std::size_t>& nodes,
                           const std::vector<double>& keys) {
  std::vector<float> times(keys.begin(), keys.end()), weights;
  for (std::size_t i = 0; i < keys.size(); ++i)
    for (std::size_t k = 0; k + 1 < keys.size(); ++k) weights.push_back(i == k ? 1 : 0);
  std::size_t input = buffer.add(std::span<const float>(times), 0, kFloat, "SCALAR", times.size(),
                                 fmt::format(R"(,"min":[{}],"max":[{}])", static_cast<double>(times.front()),
                                             static_cast<double>(times.back())));
  std::size_t output = buffer.add(std::span<const float>(weights), 0, kFloat, "SCALAR", weights.size());
  return fmt::format(
      R"(,"animations":[{{"name":"film","samplers":[{{"input":{},"output":{}}}],"channels":{}}}])", input,
      output, list(nodes, [](std::size_t node) {
        return fmt::format(R"({{"sampler":0,"target":{{"node":{},"path":"weights"}}}})", node);
      }));
}

void append_word(std::string& bytes, std::size_t value) {
  auto word = static_cast<std::uint32_t>(value);
  bytes.append(reinterpret_cast<const char*>(&word), sizeof word);
}

/// The file of both parts.
Result<std::string> container(std::string json, const std::string& binary) {
  // Chunks end on multiples of four, JSON with blanks.
  json.resize((json.size() + 3) / 4 * 4, ' ');
  std::size_t total = 12 + 8 + json.size() + (binary.empty() ? 0 : 8 + binary.size());
  if (total > 4294967295u)
    return error_at("", "would take {}; a .glb file holds 4.29 GB at most",
                    bytes_text(static_cast<double>(total)));
  std::string bytes = "glTF";
  bytes.reserve(total);
  for (std::size_t word : {std::size_t{2}, total, json.size()}) append_word(bytes, word);
  bytes += "JSON" + json;
  if (binary.empty()) return bytes;
  append_word(bytes, binary.size());
  bytes.append("BIN\0", 4);
  return bytes + binary;
}

}  // namespace

Result<std::string> glb_bytes(const ExportScene& exported, bool instances) {
  std::string json = R"({"asset":{"version":"2.0","generator":"Frond"})";
  if (exported.placements.empty()) return container(json + R"(,"scene":0,"scenes":[{}]})", "");
  BinaryPart buffer;
  GlbNodes nodes(exported, instances, buffer);
  std::string meshes = list(exported.meshes, [&](const ExportMesh& mesh) {
    return mesh_text(buffer, mesh.name, mesh.parts, exported.keys);
  });
  meshes.pop_back();
  for (const ExportMesh& mesh : exported.meshes)
    for (std::size_t level = 1; level <= mesh.coarser.size(); ++level)
      if (mesh.has_level(level))
        meshes +=
            ',' + mesh_text(buffer, fmt::format("{}_LOD{}", mesh.name, level), mesh.coarser[level - 1], {});
  meshes += ']';
  std::vector<std::string_view> extensions;
  if (nodes.instanced)
    extensions.push_back(kInstancing), json += fmt::format(R"(,"extensionsRequired":["{}"])", kInstancing);
  if (nodes.leveled) extensions.push_back(kLod);
  if (std::any_of(exported.materials.begin(), exported.materials.end(),
                  [](const ExportMaterial& m) { return m.transmission > 0; }))
    extensions.insert(extensions.end(), {kTransmission, kIor});
  if (!extensions.empty()) json += fmt::format(R"(,"extensionsUsed":["{}"])", fmt::join(extensions, "\",\""));
  json += fmt::format(R"(,"scene":0,"scenes":[{{"nodes":[{}]}}],"nodes":[{}],"meshes":)",
                      fmt::join(nodes.roots, ","), fmt::join(nodes.all, ",")) +
          meshes;
  if (!nodes.moving.empty()) json += animation_text(buffer, nodes.moving, exported.keys);
  json += ",\"materials\":" + list(exported.materials, material_text);
  if (!exported.pictures.empty()) {
    // All pictures go on over their edges.
    std::size_t source = 0;
    json += R"(,"samplers":[{"magFilter":9729,"minFilter":9987,"wrapS":10497,"wrapT":10497}],"textures":)";
    json += list(exported.pictures, [&](const ExportPicture&) {
      return fmt::format(R"({{"sampler":0,"source":{}}})", source++);
    });
    json += ",\"images\":" + list(exported.pictures, [&](const ExportPicture& picture) {
              return fmt::format(R"({{"name":"{}","mimeType":"image/png","bufferView":{}}})", picture.name,
                                 buffer.add_view(picture.png, 0));
            });
  }
  json += fmt::format(R"(,"accessors":[{}],"bufferViews":[{}],"buffers":[{{"byteLength":{}}}]}})",
                      fmt::join(buffer.accessors, ","), fmt::join(buffer.views, ","), buffer.bytes.size());
  return container(std::move(json), buffer.bytes);
}

}  // namespace frond
