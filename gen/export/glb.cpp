#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <span>

#include "core/linear.h"
#include "core/text.h"
#include "export/formats.h"

namespace frond {

namespace {

constexpr int kArrayBuffer = 34962, kElementBuffer = 34963;  // targets of buffer views
constexpr int kFloat = 5126, kUnsigned = 5125;               // types of components

/// `[1,2.5e-9]`: as many digits as it takes to read back the same numbers.
template <class Number>
void append_numbers(std::string& json, std::initializer_list<Number> numbers) {
  json += fmt::format("[{}]", fmt::join(numbers, ","));
}

/// The same for what must be equal to the floats of the binary part in whatever precision it is read.
void append_exactly(std::string& json, Vec3 v) { append_numbers<double>(json, {v.x, v.y, v.z}); }

void append_count(std::string& json, std::size_t n) { append_integer(json, static_cast<long long>(n)); }

/// The binary part and what the JSON says of it.
struct BinaryPart {
  std::string bytes, views, accessors;
  std::size_t count = 0;  // of views, and of accessors

  /// Adds an array as a view and an accessor of its own; `extra` are further members of the accessor.
  template <class T>
  std::size_t add(std::span<const T> items, int target, int component, std::string_view type,
                  std::size_t elements, std::string_view extra = {}) {
    if (count > 0) views += ',', accessors += ',';
    // All items are of four bytes each, so that every view stays aligned.
    views += fmt::format(R"({{"buffer":0,"byteOffset":{},"byteLength":{},"target":{}}})", bytes.size(),
                         items.size_bytes(), target);
    accessors += fmt::format(R"({{"bufferView":{},"componentType":{},"count":{},"type":"{}"{}}})", count,
                             component, elements, type, extra);
    bytes.append(reinterpret_cast<const char*>(items.data()), items.size_bytes());
    return count++;
  }
};

std::string bounds_text(const Surface& surface) {
  Vec3 low = surface.position[0], high = low;
  for (const Vec3& p : surface.position) low = glm::min(low, p), high = glm::max(high, p);
  std::string text = ",\"min\":";
  append_exactly(text, low);
  text += ",\"max\":";
  append_exactly(text, high);
  return text;
}

std::string mesh_text(BinaryPart& buffer, const CastMesh& mesh) {
  const Surface& s = mesh.surface;
  std::size_t n = s.position.size();
  std::size_t at = buffer.add(std::span(s.position), kArrayBuffer, kFloat, "VEC3", n, bounds_text(s));
  std::size_t normal = buffer.add(std::span(s.normal), kArrayBuffer, kFloat, "VEC3", n);
  std::string text = fmt::format(R"({{"name":"{}","primitives":[{{"attributes":{{"POSITION":{},"NORMAL":{})",
                                 mesh.name, at, normal);
  if (!s.uv.empty()) {
    text += ",\"TEXCOORD_0\":";
    append_count(text, buffer.add(std::span(s.uv), kArrayBuffer, kFloat, "VEC2", n));
  }
  std::size_t index =
      buffer.add(std::span(s.triangle), kElementBuffer, kUnsigned, "SCALAR", 3 * s.triangle.size());
  return text + fmt::format(R"(}},"indices":{},"material":{}}}]}})", index, mesh.material);
}

std::string material_text(const CastMaterial& m) {
  std::string text = "{\"name\":\"" + m.name + "\",\"pbrMetallicRoughness\":{\"baseColorFactor\":";
  Vec3 color = linear(m.color);  // as glTF has them
  append_numbers<float>(text, {color.x, color.y, color.z, 1});
  text += ",\"metallicFactor\":";
  text += m.metal ? '1' : '0';
  text += ",\"roughnessFactor\":";
  append(text, 0.95 - 0.75 * m.gloss, 4);
  text += '}';
  if (m.leaf) text += ",\"doubleSided\":true";
  return text + '}';
}

std::string node_text(const CastPlacement& p) {
  std::string text = "{\"mesh\":";
  append_count(text, p.mesh);
  if (p.at != Vec3(0)) text += ",\"translation\":", append_numbers(text, {p.at.x, p.at.y, p.at.z});
  if (p.turn != Quat(1, 0, 0, 0))
    text += ",\"rotation\":", append_numbers(text, {p.turn.x, p.turn.y, p.turn.z, p.turn.w});
  if (p.scale != Vec3(1)) text += ",\"scale\":", append_numbers(text, {p.scale.x, p.scale.y, p.scale.z});
  return text + '}';
}

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

void append_word(std::string& bytes, std::size_t value) {
  auto word = static_cast<std::uint32_t>(value);
  char raw[4];
  std::memcpy(raw, &word, 4);
  bytes.append(raw, 4);
}

}  // namespace

Result<std::string> glb_bytes(const Cast& cast) {
  if (cast.placements.empty()) return Error{"", "there is nothing at that frame to write"};
  BinaryPart buffer;
  std::string json = R"({"asset":{"version":"2.0","generator":"Frond"},"scene":0,"scenes":[{"nodes":[)";
  for (std::size_t i = 0; i < cast.placements.size(); ++i) {
    if (i > 0) json += ',';
    append_count(json, i);
  }
  json += "]}],\"nodes\":" + list(cast.placements, node_text);
  json += ",\"meshes\":" + list(cast.meshes, [&](const CastMesh& mesh) { return mesh_text(buffer, mesh); });
  json += ",\"materials\":" + list(cast.materials, material_text);
  json += ",\"accessors\":[" + buffer.accessors + "],\"bufferViews\":[" + buffer.views + "]";
  json += fmt::format(R"(,"buffers":[{{"byteLength":{}}}]}})", buffer.bytes.size());
  // Chunks end on multiples of four, JSON with blanks.
  json.resize((json.size() + 3) / 4 * 4, ' ');
  std::size_t total = 12 + 8 + json.size() + 8 + buffer.bytes.size();
  if (total > 4294967295u)
    return Error{"", fmt::format("would take {:.2g} GB; a .glb file holds 4.29 GB at most",
                                 static_cast<double>(total) / 1e9)};
  std::string bytes = "glTF";
  bytes.reserve(total);
  append_word(bytes, 2);
  append_word(bytes, total);
  append_word(bytes, json.size());
  bytes += "JSON";
  bytes += json;
  append_word(bytes, buffer.bytes.size());
  bytes.append("BIN\0", 4);
  return bytes + buffer.bytes;
}

}  // namespace frond
