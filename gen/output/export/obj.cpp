#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>
#include <tuple>

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

/// Writes lines of one sort, those alike once, and tells the number of each; OBJ counts from 1, over the
/// file.
template <class V>
std::vector<std::size_t> append_lines(std::string& text, std::string_view word, int decimals,
                                      const std::vector<V>& items, std::size_t& count) {
  constexpr auto kSize = static_cast<std::size_t>(V::length());
  auto unit = std::pow(10.0, decimals);
  std::vector<std::array<long long, kSize>> key(items.size());
  for (std::size_t i = 0; i < items.size(); ++i)
    for (std::size_t k = 0; k < kSize; ++k)
      key[i][k] = std::llround(static_cast<double>(items[i][static_cast<int>(k)]) * unit);
  std::vector<std::uint32_t> order(items.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return std::tie(key[a], a) < std::tie(key[b], b); });
  // The first of those alike stands for all of them, so that the order stays.
  std::vector<std::uint32_t> first(items.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    first[order[i]] = i > 0 && key[order[i]] == key[order[i - 1]] ? first[order[i - 1]] : order[i];
  std::vector<std::size_t> number(items.size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    number[i] = first[i] == i ? ++count : number[first[i]];
    if (first[i] == i) append_row(text, word, std::span(&items[i].x, kSize), decimals);
  }
  return number;
}

/// How many vertices, places on textures and normals there are already.
struct Counted {
  std::size_t places = 0, uvs = 0, normals = 0;
};

/// `f 1/1/1 2/2/2 3/3/3`: vertex, place on the texture if it has one, normal.
void append_part(std::string& text, const Surface& surface, Counted& counted) {
  std::vector<std::size_t> place = append_lines(text, "v", kPlaceDigits, surface.position, counted.places);
  std::vector<std::size_t> uv = append_lines(text, "vt", kUvDigits, surface.uv, counted.uvs);
  std::vector<std::size_t> normal = append_lines(text, "vn", kNormalDigits, surface.normal, counted.normals);
  for (const auto& t : surface.triangle) {
    text += 'f';
    for (std::uint32_t corner : t) {
      text += ' ';
      append_integer(text, static_cast<long long>(place[corner]));
      text += '/';
      if (!uv.empty()) append_integer(text, static_cast<long long>(uv[corner]));
      text += '/';
      append_integer(text, static_cast<long long>(normal[corner]));
    }
    text += '\n';
  }
}

}  // namespace

std::string obj_text(const ExportScene& exported, std::string_view materials) {
  std::string text = "# metres, y up\nmtllib ";
  text += materials;
  text += '\n';
  std::vector<std::size_t> times(exported.meshes.size(), 0);
  for (const ExportPlacement& p : exported.placements) ++times[p.mesh];
  Counted counted;
  for (std::size_t i = 0; i < exported.placements.size(); ++i) {
    const ExportMesh& mesh = exported.meshes[exported.placements[i].mesh];
    text += "o " + mesh.name;
    if (times[exported.placements[i].mesh] > 1) text += '_', append_integer(text, static_cast<long long>(i));
    text += '\n';
    for (const ExportPart& part : mesh.parts) {
      text += "usemtl " + exported.materials[part.material].name + '\n';
      append_part(text, placed(part, exported.placements[i]), counted);
    }
  }
  return text;
}

std::string mtl_text(const ExportScene& exported) {
  std::string text;
  auto file = [&](std::size_t picture) { return exported.pictures[picture].name + ".png\n"; };
  for (const ExportMaterial& m : exported.materials) {
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
    if (m.cutout && m.colors != kNoPicture) text += "map_d -imfchan m " + file(m.colors);
    if (m.normals != kNoPicture) text += "norm " + file(m.normals);
    if (m.roughness != kNoPicture) text += "map_Pr -imfchan g " + file(m.roughness);
  }
  return text;
}

}  // namespace frond
