#include <algorithm>
#include <array>
#include <span>
#include <unordered_map>

#include "core/text.h"
#include "export/formats.h"

namespace frond {

namespace {

constexpr int kPlaceDigits = 6, kUvDigits = 4, kNormalDigits = 3;

void append_row(std::string& text, std::string_view word, std::span<const float> numbers, int decimals) {
  text += word;
  for (float number : numbers) text += ' ', append(text, number, decimals);
  text += '\n';
}

/// Lines of one sort, each written once; OBJ counts from 1, over the file.
class Lines {
 public:
  Lines(std::string_view word, int decimals) : word_(word), decimals_(decimals) {}

  /// The number of a line, which is added to the text where it is new.
  std::size_t number(std::string& text, std::span<const float> numbers) {
    line_.clear();
    append_row(line_, word_, numbers, decimals_);
    auto [at, fresh] = index_.try_emplace(line_, count_ + 1);
    if (fresh) text += line_, ++count_;
    return at->second;
  }
  /// What follows shares no line with what went before.
  void part() { index_.clear(); }

 private:
  std::string_view word_;
  int decimals_;
  std::size_t count_ = 0;
  std::string line_;
  std::unordered_map<std::string, std::size_t> index_;
};

/// `f 1/1/1 2/2/2 3/3/3`: vertex, place on the texture if it has one, normal.
void append_faces(std::string& text, const Surface& surface, Lines& places, Lines& uvs, Lines& normals) {
  std::vector<std::string> corner;
  auto append_slash = [](std::string& to, std::size_t n) {
    to += '/', append_integer(to, static_cast<long long>(n));
  };
  for (std::size_t v = 0; v < surface.position.size(); ++v) {
    std::string own = " ";
    append_integer(own, static_cast<long long>(places.number(text, std::span(&surface.position[v].x, 3))));
    if (surface.uv.empty())
      own += '/';
    else
      append_slash(own, uvs.number(text, std::span(&surface.uv[v].x, 2)));
    append_slash(own, normals.number(text, std::span(&surface.normal[v].x, 3)));
    corner.push_back(std::move(own));
  }
  for (const auto& t : surface.triangle) text += 'f' + corner[t[0]] + corner[t[1]] + corner[t[2]] + '\n';
}

}  // namespace

std::string obj_text(const Cast& cast, std::string_view materials) {
  std::string text = "# metres, y up\nmtllib ";
  text += materials;
  text += '\n';
  std::vector<std::size_t> times(cast.meshes.size(), 0);
  for (const CastPlacement& p : cast.placements) ++times[p.mesh];
  Lines places("v", kPlaceDigits), uvs("vt", kUvDigits), normals("vn", kNormalDigits);
  for (std::size_t i = 0; i < cast.placements.size(); ++i) {
    const CastMesh& mesh = cast.meshes[cast.placements[i].mesh];
    text += "o " + mesh.name;
    if (times[cast.placements[i].mesh] > 1) text += '_', append_integer(text, static_cast<long long>(i));
    text += '\n';
    places.part();
    for (const CastPart& part : mesh.parts) {
      text += "usemtl " + cast.materials[part.material].name + '\n';
      append_faces(text, placed(part, cast.placements[i]), places, uvs, normals);
    }
  }
  return text;
}

std::string mtl_text(const Cast& cast) {
  std::string text;
  auto file = [&](std::size_t picture) { return cast.pictures[picture].name + ".png\n"; };
  for (const CastMaterial& m : cast.materials) {
    text += "newmtl " + m.name + '\n';
    const Color& color = m.colors == kNoPicture ? m.color : m.factor;
    auto shine = static_cast<float>(0.5 * std::min(m.gloss, 1.0));
    append_row(text, "Kd", std::array{color.red, color.green, color.blue}, 4);
    append_row(text, "Ks", std::array{shine, shine, shine}, 4);
    text += "Ns ";
    append(text, 10 + 300 * m.gloss, 2);
    if (m.transmission > 0) text += "\nd ", append(text, 1 - m.transmission, 2), text += "\nNi 1.5";
    text += "\nillum 2\n";
    if (m.colors != kNoPicture) text += "map_Kd " + file(m.colors);
    if (m.cutout) text += "map_d -imfchan m " + file(m.colors);
    if (m.normals != kNoPicture) text += "norm " + file(m.normals);
    if (m.roughness != kNoPicture) text += "map_Pr -imfchan g " + file(m.roughness);
  }
  return text;
}

}  // namespace frond
