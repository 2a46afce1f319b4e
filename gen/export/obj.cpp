#include "core/text.h"
#include "export/formats.h"

namespace frond {

namespace {

void append_row(std::string& text, const char* word, Vec3 v, int decimals) {
  text += word;
  for (int axis = 0; axis < 3; ++axis) text += ' ', append(text, v[axis], decimals);
  text += '\n';
}

/// `f 1/1/1 2/2/2 3/3/3`: vertex, place on the texture if it has one, normal.
void append_face(std::string& text, const std::array<std::uint32_t, 3>& corners, std::size_t vertices,
                 std::size_t places, bool with_uv) {
  text += 'f';
  for (std::uint32_t corner : corners) {
    text += ' ';
    append_integer(text, static_cast<long long>(vertices + corner));
    text += '/';
    if (with_uv) append_integer(text, static_cast<long long>(places + corner));
    text += '/';
    append_integer(text, static_cast<long long>(vertices + corner));
  }
  text += '\n';
}

}  // namespace

std::string obj_text(const Cast& cast, std::string_view materials) {
  std::string text = "# metres, y up\nmtllib ";
  text += materials;
  text += '\n';
  std::size_t vertices = 1, places = 1;  // OBJ counts from 1, over the whole file
  for (std::size_t i = 0; i < cast.placements.size(); ++i) {
    const CastMesh& mesh = cast.meshes[cast.placements[i].mesh];
    Surface surface = placed(mesh, cast.placements[i]);
    text += "o " + mesh.name + '_';
    append_integer(text, static_cast<long long>(i));
    text += "\nusemtl " + cast.materials[mesh.material].name + '\n';
    for (Vec3 p : surface.position) append_row(text, "v", p, 6);
    for (Vec2 at : surface.uv) {
      text += "vt ";
      append(text, at.x, 5);
      text += ' ';
      append(text, at.y, 5);
      text += '\n';
    }
    for (Vec3 n : surface.normal) append_row(text, "vn", n, 5);
    for (const auto& t : surface.triangle) append_face(text, t, vertices, places, !surface.uv.empty());
    vertices += surface.position.size();
    places += surface.uv.size();
  }
  return text;
}

std::string mtl_text(const Cast& cast) {
  std::string text;
  for (const CastMaterial& m : cast.materials) {
    text += "newmtl " + m.name + '\n';
    append_row(text, "Kd", Vec3(m.color.red, m.color.green, m.color.blue), 4);
    append_row(text, "Ks", Vec3(static_cast<float>(0.5 * m.gloss)), 4);
    text += "Ns ";
    append(text, 10 + 300 * m.gloss, 2);
    text += "\nillum 2\n";
  }
  return text;
}

}  // namespace frond
