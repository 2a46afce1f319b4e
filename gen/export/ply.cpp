#include <bit>
#include <cmath>
#include <cstring>

#include "core/text.h"
#include "export/formats.h"

static_assert(std::endian::native == std::endian::little, "PLY and GLB are written as the memory has them");

namespace frond {

namespace {

template <class T>
void append_raw(std::string& bytes, const T& value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  bytes.append(raw, sizeof(T));
}

char channel(float x) { return static_cast<char>(static_cast<unsigned char>(std::lround(x * 255))); }

}  // namespace

std::string ply_bytes(const Cast& cast) {
  std::size_t vertices = 0, triangles = 0;
  for (const CastPlacement& p : cast.placements) {
    vertices += cast.meshes[p.mesh].surface.position.size();
    triangles += cast.meshes[p.mesh].surface.triangle.size();
  }
  std::string text = "ply\nformat binary_little_endian 1.0\ncomment metres, y up\nelement vertex ";
  append_integer(text, static_cast<long long>(vertices));
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz", "s", "t"})
    text += std::string("\nproperty float ") + name;
  for (const char* name : {"red", "green", "blue"}) text += std::string("\nproperty uchar ") + name;
  text += "\nelement face ";
  append_integer(text, static_cast<long long>(triangles));
  text += "\nproperty list uchar int vertex_indices\nend_header\n";
  text.reserve(text.size() + vertices * 35 + triangles * 13);
  for (const CastPlacement& p : cast.placements) {
    const CastMesh& mesh = cast.meshes[p.mesh];
    Surface surface = placed(mesh, p);
    const Color& color = cast.materials[mesh.material].color;
    for (std::size_t v = 0; v < surface.position.size(); ++v) {
      append_raw(text, surface.position[v]);
      append_raw(text, surface.normal[v]);
      append_raw(text, surface.uv.empty() ? Vec2(0) : surface.uv[v]);
      for (float c : {color.red, color.green, color.blue}) text += channel(c);
    }
  }
  std::uint32_t first = 0;
  for (const CastPlacement& p : cast.placements) {
    const Surface& surface = cast.meshes[p.mesh].surface;
    for (const auto& t : surface.triangle) {
      text += '\3';
      for (std::uint32_t corner : t) append_raw(text, first + corner);
    }
    first += static_cast<std::uint32_t>(surface.position.size());
  }
  return text;
}

}  // namespace frond
