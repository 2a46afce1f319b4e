#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/parallel.h"
#include "emit/branch_materials.h"
#include "emit/copies.h"
#include "emit/plant.h"
#include "emit/solid.h"

namespace frond {

namespace {

constexpr const char* kCopyMacros[] = {"Copy_Leaf",  "Copy_Petal", "Copy_Fruit",
                                       "Copy_Fruit", "Copy_Fruit", "Copy_Leaf"};  // of each Tissue

std::string leaf_look(const std::vector<Color>& colors, const Color& second, Tissue tissue, bool plain,
                      const std::optional<Luster>& luster) {
  std::string look =
      call_text(plain ? "Copy_Far" : kCopyMacros[static_cast<std::size_t>(tissue)], "C", second, "T");
  return "#local C = " + array_of(colors) + "; " +
         lustrous(look, luster, plain ? "" : relief_macro(tissue), {});
}

/// Declares the pictures that the look of a part names.
void declare_part(std::string& text, const CopyPart& part, const Look& look, const Model& model) {
  if (part.kind == CopyPart::Kind::wood)
    declare_coat(text, look.branches, look.branches.color_of(part.which));
  if (part.kind != CopyPart::Kind::organ) return;
  const Prototype& prototype = model.prototypes[part.which];
  declare_pictures(text, prototype.parts[part.part].pictures, is_lit(prototype.luster));
}

/// The colours of the leaves of a part, of which there may be more than those that it wears: a map of POV-Ray
/// has 256 entries, and each costs time for each copy. Empty for what has no list of colours.
const std::vector<Color>& colors_of(const CopyPart& part, const Look& look, const Model& model) {
  static const std::vector<Color> kNone;
  if (part.kind == CopyPart::Kind::blade) return look.blades.colors;
  if (part.kind != CopyPart::Kind::organ) return kNone;
  const Prototype& prototype = model.prototypes[part.which];
  return prototype.parts[part.part].pictures.empty() ? prototype.colors : kNone;
}

/// Which of many colours a part wears, in their order; all where they are few.
std::vector<std::size_t> worn_colors(const Surface& surface, std::size_t colors) {
  constexpr std::size_t kFew = 24, kMost = 100;
  std::set<std::size_t> worn;
  if (colors > kFew)
    for (Vec2 uv : surface.uv) worn.insert(color_index(uv, colors));
  if (worn.empty())
    for (std::size_t i = 0; i < colors; ++i) worn.insert(i);
  std::vector<std::size_t> list(worn.begin(), worn.end());
  if (colors <= kFew || list.size() <= kMost) return list;
  std::vector<std::size_t> some;
  for (std::size_t i = 0; i < kMost; ++i) some.push_back(list[i * list.size() / kMost]);
  return some;
}

/// A surface whose places tell colours of a shorter list.
Surface with_worn(Surface surface, const std::vector<std::size_t>& worn, std::size_t colors) {
  if (worn.size() == colors) return surface;
  for (Vec2& uv : surface.uv) {
    float place = std::floor(uv.x);
    auto at = std::ranges::upper_bound(worn, color_index(uv, colors)) - worn.begin();
    auto own = static_cast<double>(worn.size()) * std::floor(place / static_cast<double>(colors));
    uv.x += static_cast<float>(own + static_cast<double>(std::max<std::ptrdiff_t>(at - 1, 0))) - place;
  }
  return surface;
}

/// What the macro of a part holds: a texture for the tint T.
std::string look_of(const CopyPart& part, const Look& look, const Model& model, bool plain) {
  std::vector<Color> colors;
  const std::vector<Color>& all = colors_of(part, look, model);
  for (std::size_t i : worn_colors(part.surface, all.size())) colors.push_back(all[i]);
  switch (part.kind) {
    case CopyPart::Kind::wood:
      return "texture{" + copy_texture(look.branches, look.branches.color_of(part.which)) + "}";
    case CopyPart::Kind::blade:
      return leaf_look(colors, look.blades.second, look.blades.tissue, false, {});
    case CopyPart::Kind::organ: {
      const Prototype& prototype = model.prototypes[part.which];
      const OrganPart& organ = prototype.parts[part.part];
      if (organ.pictures.empty())
        return leaf_look(colors, prototype.second, organ.tissue, plain, prototype.luster);
      std::string text = "#local F = " + array_of("Picture", organ.pictures) + "; ";
      Luster luster = prototype.luster.value_or(Luster{.gloss = 0.13});
      std::string how = fmt::format("{:.4g},{:.4g}", luster.through, luster.gloss);
      if (!is_lit(prototype.luster)) return text + "texture{Copy_Picture(F,T," + how + ")} hollow ";
      return text + "#local H = " + array_of("Half", organ.pictures) + "; " +
             fmt::format("texture{{Copy_Lit(F,H,T,{},{:.4g})}} hollow ", how, luster.yellow);
    }
    case CopyPart::Kind::solid:
      return material_text(model.solids.shapes[part.which].material);
  }
  return {};
}

/// No more of a part's mesh than shows at a level: a fortieth of a pixel, from afar an eighth; of leaves of
/// some pixels facets, and places to a hundredth. Wood and plain leaves without pictures need no places.
MeshText mesh_text(const CopyPart& part, const Look& look, const Model& model, int level) {
  double finest = kLevels[level].grain / (kLevels[level].plain ? 8 : 40) * kModelUnit;
  MeshText how;
  how.decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(finest))), 1, 4);
  how.flat = kLevels[level].grain > 0.005 ? 0.7f : 0.9999f;
  bool pictured =
      part.kind == CopyPart::Kind::wood ? is_pictured(look.branches, look.branches.color_of(part.which))
      : part.kind == CopyPart::Kind::organ
          ? !kLevels[level].plain || !model.prototypes[part.which].parts[part.part].pictures.empty()
          : true;
  how.uv_decimals = !pictured ? -1 : kLevels[level].grain > 0.02 ? 2 : 3;
  return how;
}

/// What is written of a part.
Surface skin_for(const CopyPart& part, const Look& look, const Model& model, const Surface& surface) {
  if (part.kind == CopyPart::Kind::solid) return with_light_uv(surface, model.solids.shapes[part.which]);
  std::size_t colors = colors_of(part, look, model).size();
  return with_worn(surface, worn_colors(part.surface, colors), colors);
}

/// A part put together from its blocks, as their files declare them.
void append_joined(std::string& text, const CopyPart& part, std::string_view name, std::size_t which) {
  std::set<int> blocks(part.block.begin(), part.block.end());
  bool many = blocks.size() > 1;
  text += many ? "union{" : "object{";
  for (int block : blocks) {
    std::string own = part_name(fmt::format("{}_{}", name, block), which);
    text += many ? "object{" + own + '}' : own;
  }
  text += '}';
}

}  // namespace

std::string declared_name(const ModelFile& file) {
  return "M" + file.name.substr(1, file.name.find('.') - 1);
}

std::string part_name(std::string_view file, std::size_t part) { return fmt::format("{}_{}", file, part); }

std::vector<int> append_parts(std::string& text, std::string_view name, const Look& look, const Model& model,
                              const std::vector<CopyPart>& all, const ModelFile& file) {
  std::vector<int> parts;
  for (std::size_t p = 0; p < all.size(); ++p) {
    const CopyPart& part = all[p];
    bool whole = file.block == ModelFile::kWhole;
    Surface some = whole ? Surface{} : in_block(part, file.block);
    const Surface& shown = whole ? part.surface : some;
    if (file.blocks == 0 && !has_faces(shown)) continue;  // as where it has only begun to grow
    parts.push_back(static_cast<int>(p));
    std::string own = part_name(name, p);
    declare_part(text, part, look, model);
    text += fmt::format("#declare {} = ", own);
    if (file.blocks > 0)
      append_joined(text, part, name, p);
    else
      append_mesh(text, PovSpace{kModelUnit}, skin_for(part, look, model, shown),
                  mesh_text(part, look, model, file.level));
    text += fmt::format("\n#macro {}_Look(T) {} #end\n", own,
                        look_of(part, look, model, kLevels[file.level].plain));
  }
  return parts;
}

void append_looks(std::string& text, std::string_view name, const Look& look, const Model& model,
                  const std::vector<CopyPart>& all, const ModelFile& file) {
  for (int p : file.parts) {
    const CopyPart& part = all[static_cast<std::size_t>(p)];
    declare_part(text, part, look, model);
    text += fmt::format("#macro {}_Look(T) {} #end\n", part_name(name, static_cast<std::size_t>(p)),
                        look_of(part, look, model, kLevels[file.level].plain));
  }
}

std::string ModelText::file_text() const {
  std::string text = title;
  for (std::string_view include : includes) text += fmt::format("#include \"frond_{}.inc\"\n", include);
  return text + body;
}

std::vector<ModelText> model_texts(const std::vector<ModelFile>& files, const CopySet& set,
                                   const Model& model, const ModelBlocks& blocks) {
  const Look& look = set.appearance.look;
  std::vector<CopyPart> all = copy_parts(look, model, kLevels[files[0].level], &blocks);
  std::vector<ModelText> texts(files.size());
  parallel_for(files.size(), [&](std::size_t i) {
    ModelText& text = texts[i];
    text.parts = append_parts(text.body, declared_name(files[i]), look, model, all, files[i]);
    std::set<std::string_view> includes{"copy"};
    if (std::string_view own = copy_include(look.branches); !own.empty()) includes.insert(own);
    for (int p : text.parts)
      if (const CopyPart& part = all[static_cast<std::size_t>(p)]; part.kind == CopyPart::Kind::solid)
        includes.insert(material_include(model.solids.shapes[part.which].material));
    text.includes.assign(includes.begin(), includes.end());
    append_comment(text.title,
                   fmt::format("parts{}{}; {} segments, {} organs", text.parts.empty() ? "" : " ",
                               fmt::join(text.parts, " "),
                               std::max<std::size_t>(1, model.skeleton.size()) - 1, model.organs.size()));
  });
  return texts;
}

}  // namespace frond
