#include <fmt/format.h>

#include <bit>
#include <cmath>

#include "core/linear.h"
#include "export/formats.h"

static_assert(std::endian::native == std::endian::little, "PLY and GLB are written as the memory has them");

namespace frond {

namespace {

template <class T>
void append_raw(std::string& bytes, const T& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// A channel of a colour as a byte, times a factor of its light.
char channel(std::uint8_t tint, float x) {
  double c = tint == 255 ? static_cast<double>(x) : encoded(linear(x) * tint / 255);
  return static_cast<char>(static_cast<unsigned char>(std::lround(c * 255)));
}

template <class Visit>
void each_part(const ExportScene& exported, const Visit& visit) {
  for (const ExportPlacement& p : exported.placements)
    for (const ExportPart& part : exported.meshes[p.mesh].parts) visit(part, p);
}

}  // namespace

std::string ply_bytes(const ExportScene& exported) {
  std::size_t vertices = 0, triangles = 0;
  each_part(exported, [&](const ExportPart& part, const ExportPlacement&) {
    vertices += part.surface.position.size(), triangles += part.surface.triangle.size();
  });
  std::string text =
      fmt::format("ply\nformat binary_little_endian 1.0\ncomment metres, y up\nelement vertex {}", vertices);
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz", "s", "t"})
    text += std::string("\nproperty float ") + name;
  for (const char* name : {"red", "green", "blue"}) text += std::string("\nproperty uchar ") + name;
  text += fmt::format("\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n", triangles);
  text.reserve(text.size() + vertices * 35 + triangles * 13);
  each_part(exported, [&](const ExportPart& part, const ExportPlacement& p) {
    Surface surface = placed(part, p);
    const Color& color = exported.materials[part.material].color;
    for (std::size_t v = 0; v < surface.position.size(); ++v) {
      append_raw(text, surface.position[v]);
      append_raw(text, surface.normal[v]);
      append_raw(text, surface.uv.empty() ? Vec2(0) : surface.uv[v]);
      ExportTint tint = part.tint.empty() ? ExportTint{255, 255, 255, 255} : part.tint[v];
      std::size_t k = 0;
      for (float c : {color.red, color.green, color.blue}) text += channel(tint[k], c), ++k;
    }
  });
  std::uint32_t first = 0;
  each_part(exported, [&](const ExportPart& part, const ExportPlacement&) {
    for (const auto& t : part.surface.triangle) {
      text += '\3';
      for (std::uint32_t corner : t) append_raw(text, first + corner);
    }
    first += static_cast<std::uint32_t>(part.surface.position.size());
  });
  return text;
}

}  // namespace frond
