#include "emit/twigs.h"

#include <fmt/format.h>

#include <map>
#include <tuple>

#include "core/parallel.h"
#include "emit/branch_materials.h"
#include "emit/plant.h"

namespace frond {

namespace {

constexpr std::size_t kTextPiece = 1'000'000;  // bytes that are handed on at once

/// What parts are drawn together: kind, prototype or skin, part.
using LookKey = std::tuple<CopyPart::Kind, std::size_t, std::size_t>;

std::string twig_name(std::size_t kept, std::size_t part) { return fmt::format("Twig{}_{}", kept, part); }

/// The textures of leaves of pictures: glossy above, matt below where they have a luster of their own;
/// hollow, since POV-Ray has no fog within what is not.
std::string picture_text(const std::optional<Luster>& luster) {
  if (!luster) return "texture{Twig_Picture(Twig_Pictures,0.62,0.34,0.13)} hollow ";
  const bool lit = is_lit(luster);
  const std::string leaf =
      lit ? fmt::format("Twig_Pictures,Twig_Halves,{:.4g},{:.4g}", luster->through, luster->yellow)
          : fmt::format("Twig_Pictures,{:.4g},{:.4g}", 0.94 * (1 - luster->through), 0.94 * luster->through);
  return fmt::format("texture{{{0}({1},{2:.4g})}}interior_texture{{{0}_Under({1})}} hollow ",
                     lit ? "Twig_Lit" : "Twig_Picture", leaf, luster->gloss);
}

/// What is declared for a look and its textures.
struct TwigLook {
  std::string before, texture;
};

/// What has no pictures is no leaf.
TwigLook organ_look(const Prototype& prototype, const OrganPart& part) {
  if (!part.pictures.empty()) {
    bool lit = is_lit(prototype.luster);
    std::string before;
    declare_pictures(before, part.pictures, lit);
    before += "#declare Twig_Pictures = " + array_of("Picture", part.pictures) + ";\n";
    if (lit) before += "#declare Twig_Halves = " + array_of("Half", part.pictures) + ";\n";
    return {before, picture_text(prototype.luster)};
  }
  return {
      "#declare Twig_Hues = " + array_of(prototype.colors) + ";\n",
      lustrous(call_text("Copy_Fruit", "Twig_Hues", prototype.second, "<0,1,1>"), prototype.luster, "", {})};
}

/// The skins of the wood of each twig of a palette, each of one age.
class TwigSkins {
 public:
  TwigSkins(const DrawList& drawn, std::size_t index) : drawn_(drawn), index_(index) {
    longest_ = drawn.model.skeleton.longest();
    young_ = static_cast<float>(drawn.traits.look.branches.young_length());
  }

  /// The number of one, for text().
  std::size_t of(std::size_t kept) const {
    std::int32_t node = drawn_.twigs->plan.palette[kept].node;
    float age = youth(drawn_.model.skeleton, drawn_.pose, longest_, young_, node);
    return drawn_.traits.look.branches.color_at(drawn_.model, node) * SharedTextures::kAges +
           static_cast<std::size_t>(std::lround(age * (SharedTextures::kAges - 1)));
  }
  std::string text(std::size_t number) const {
    return SharedTextures{*drawn_.branches}.text(number, index_) +
           weather_over(drawn_.traits.snowy, drawn_.traits.wet, Wetting::wood);
  }

 private:
  const DrawList& drawn_;
  std::size_t index_;
  float longest_ = 0, young_ = 0;
};

/// How much of a part is written: places to a twentieth of a pixel.
MeshText mesh_text(const PovSpace& space, const DrawList& drawn, const TwigPart& part) {
  const double pixel = drawn.twigs->plan.grain;
  MeshText how{.decimals = decimals_for(space, pixel), .uv_decimals = 2};
  if (part.kind == CopyPart::Kind::wood) how.uv_decimals = -1, how.flat = 0;
  return how;
}

}  // namespace

std::size_t write_palette(const PovSpace& space, const DrawList& drawn, std::size_t index, const Out& out) {
  if (!drawn.twigs || !drawn.branches) return 0;
  const DrawnTwigs& twigs = *drawn.twigs;
  TwigSkins skins(drawn, index);
  std::vector<std::string> declared(twigs.shapes.size());
  parallel_for(declared.size(), [&](std::size_t k) {
    for (std::size_t p = 0; p < twigs.shapes[k].size(); ++p) {
      const TwigPart& part = twigs.shapes[k][p];
      if (!has_faces(part.surface)) continue;
      declared[k] += "#declare " + twig_name(k, p) + " = ";
      append_mesh(declared[k], space, part.surface, mesh_text(space, drawn, part));
      declared[k] += '\n';
    }
  });
  std::map<LookKey, std::vector<std::pair<std::size_t, std::size_t>>> looks;  // parts of the palette
  for (std::size_t k = 0; k < twigs.shapes.size(); ++k) {
    out(declared[k]);
    for (std::size_t p = 0; p < twigs.shapes[k].size(); ++p) {
      const TwigPart& part = twigs.shapes[k][p];
      bool wood = part.kind == CopyPart::Kind::wood;
      if (has_faces(part.surface))
        looks[{part.kind, wood ? skins.of(k) : part.which, part.part}].push_back({k, p});
    }
  }
  MatrixText how = matrix_text_for(space, twigs.reach(), twigs.plan.grain);
  std::vector<std::string> matrices(twigs.places.size());
  parallel_for(matrices.size(), [&](std::size_t i) {
    const OrganPlace& place = twigs.places[i];
    if (append_matrix(matrices[i], space, axes_of(place.turn, place.scale), place.at, how))
      matrices[i] += "}\n";
  });
  std::size_t objects = 0;
  for (const auto& [key, parts] : looks) {
    auto [kind, which, number] = key;
    std::vector<std::string> name(twigs.shapes.size());
    for (auto [k, p] : parts) name[k] = "object{" + twig_name(k, p) + ' ';
    TwigLook look;
    if (kind == CopyPart::Kind::wood)
      look.texture = skins.text(which);
    else {
      const Prototype& prototype = drawn.model.prototypes[which];
      look = organ_look(prototype, prototype.parts[number]);
      look.texture += weather_over(drawn.traits.snowy, drawn.traits.wet, Wetting::leaf);
    }
    std::string text = look.before + "union{\n";
    for (std::size_t i = 0; i < matrices.size(); ++i) {
      const std::string& own = name[twigs.plan.places[i].kept];
      if (own.empty() || matrices[i].empty()) continue;
      text += own, text += matrices[i];
      if (text.size() > kTextPiece) out(text), text.clear();
    }
    out(text + look.texture + "}\n");
    ++objects;
  }
  return objects;
}

}  // namespace frond
