#include <algorithm>
#include <numeric>
#include <tuple>

#include "core/text.h"
#include "export/formats.h"

namespace frond {

namespace {

void append_row(std::string& text, const char* word, Vec3 v, int decimals) {
  text += word;
  for (int axis = 0; axis < 3; ++axis) text += ' ', append(text, v[axis], decimals);
  text += '\n';
}

/// The places of a mesh, each once: where normals or the texture have a seam the body has none.
struct Welded {
  std::vector<Vec3> place;
  std::vector<std::uint32_t> of;  // of each vertex
};

Welded welded(const std::vector<Vec3>& position) {
  std::vector<std::uint32_t> order(position.size());
  std::iota(order.begin(), order.end(), 0u);
  auto key = [&](std::uint32_t v) { return std::tuple(position[v].x, position[v].y, position[v].z); };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  // The first vertex at each place stands for all of them, so that the order stays.
  std::vector<std::uint32_t> first(position.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    first[order[i]] = i > 0 && key(order[i]) == key(order[i - 1]) ? first[order[i - 1]] : order[i];
  Welded result;
  for (std::uint32_t v = 0; v < position.size(); ++v) {
    result.of.push_back(first[v] == v ? static_cast<std::uint32_t>(result.place.size())
                                      : result.of[first[v]]);
    if (first[v] == v) result.place.push_back(position[v]);
  }
  return result;
}

/// How many vertices, places on textures and normals there are already; OBJ counts from 1, over the file.
struct Counted {
  std::size_t places = 1, uvs = 1, normals = 1;
};

/// `f 1/1/1 2/2/2 3/3/3`: vertex, place on the texture if it has one, normal.
void append_face(std::string& text, const std::array<std::uint32_t, 3>& corners, const Welded& mesh,
                 const Counted& counted, bool with_uv) {
  text += 'f';
  for (std::uint32_t corner : corners) {
    text += ' ';
    append_integer(text, static_cast<long long>(counted.places + mesh.of[corner]));
    text += '/';
    if (with_uv) append_integer(text, static_cast<long long>(counted.uvs + corner));
    text += '/';
    append_integer(text, static_cast<long long>(counted.normals + corner));
  }
  text += '\n';
}

}  // namespace

std::string obj_text(const Cast& cast, std::string_view materials) {
  std::string text = "# metres, y up\nmtllib ";
  text += materials;
  text += '\n';
  Counted counted;
  for (std::size_t i = 0; i < cast.placements.size(); ++i) {
    const CastMesh& mesh = cast.meshes[cast.placements[i].mesh];
    Surface surface = placed(mesh, cast.placements[i]);
    text += "o " + mesh.name + '_';
    append_integer(text, static_cast<long long>(i));
    text += "\nusemtl " + cast.materials[mesh.material].name + '\n';
    Welded body = welded(surface.position);
    for (Vec3 p : body.place) append_row(text, "v", p, 6);
    for (Vec2 at : surface.uv) {
      text += "vt ";
      append(text, at.x, 5);
      text += ' ';
      append(text, at.y, 5);
      text += '\n';
    }
    for (Vec3 n : surface.normal) append_row(text, "vn", n, 5);
    for (const auto& t : surface.triangle) append_face(text, t, body, counted, !surface.uv.empty());
    counted.places += body.place.size();
    counted.uvs += surface.uv.size();
    counted.normals += surface.normal.size();
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
