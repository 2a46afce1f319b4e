#include "emit/plant.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "draw/solids.h"

namespace frond {

namespace {

constexpr double kUnknown = 1e30;          // metres of a pixel
constexpr std::size_t kPiece = 1'000'000;  // bytes that are handed on at once

constexpr const char* kTissueMacros[] = {"Plant_Leaf",  "Plant_Petal", "Plant_Heart",
                                         "Plant_Fruit", "Plant_Fruit", "Ivy_Leaf"};

/// `Organ2_0_1`: the shape of a part of an organ of an entry of the preset.
std::string organ_name(std::size_t entry, std::size_t prototype, std::size_t part) {
  return fmt::format("Organ{}_{}_{}", entry, prototype, part);
}

/// What is clear at its rims is hollow, since POV-Ray has no fog within what is not.
constexpr std::string_view kHollow = " hollow ";

/// The texture of a part that shows the picture `name`.
std::string picture_look(const OrganPart& part, std::string_view name, std::size_t shade,
                         const std::optional<Luster>& luster) {
  if (luster && luster->yellow > 0) {
    std::string leaf = fmt::format("\"{}\",{},{:.4g},{:.4g}", name, shade, luster->through, luster->yellow);
    return fmt::format(
        "texture{{Tree_Lit({0},{1:.4g},{2:.4g})}}interior_texture{{Tree_Lit_Under({0},{2:.4g})}}{3}", leaf,
        luster->gloss, luster->relief, kHollow);
  }
  return lustrous(fmt::format("Tree_Leaf(\"{}\",{})", name, shade), luster, "Tree_Veined",
                  part.relief.empty() ? name : part.relief)
      .append(kHollow);
}

/// Writes a group of organs, each line made once and used by all parts. Gives the number of objects.
std::size_t write_group(const PovSpace& space, const DrawList& drawn, const OrganGroup& group, double pixel,
                        const Out& out) {
  const Prototype& prototype = drawn.model.prototypes[group.prototype];
  MatrixText how = matrix_text_for(space, static_cast<double>(reach_of(prototype)), pixel);
  std::string lines;
  for (const OrganPlace& place : drawn.organs.places(group))
    if (append_matrix(lines, space, axes_of(place.turn, place.scale), place.at, how)) lines += "}\n";
  if (lines.empty()) return 0;
  std::string text;
  for (std::size_t part = 0; part < prototype.parts.size(); ++part) {
    text += group_opening(lines);
    std::string object = "object{" + organ_name(drawn.traits.entry, group.prototype, part) + ' ';
    for (std::size_t from = 0; from < lines.size();) {
      std::size_t to = lines.find('\n', from) + 1;
      text += object;
      text.append(lines, from, to - from);
      from = to;
      if (text.size() > kPiece) out(text), text.clear();
    }
    if (!prototype.parts[part].pictures.empty())
      text += picture_look(prototype.parts[part], prototype.parts[part].pictures[group.color], group.shade,
                           prototype.luster) +
              shift_over(drawn.traits.shift, prototype.colors[group.color]);
    else
      text += tissue_text(prototype.parts[part].tissue, group.tint, prototype.second, group.shade,
                          prototype.luster);
    text += weather_over(drawn.traits.snowy, drawn.traits.wet, Wetting::leaf);
    text += "}\n";
  }
  out(text);
  return prototype.parts.size();
}

}  // namespace

std::string tissue_text(Tissue tissue, const Color& color, const Color& second, std::size_t shade,
                        const std::optional<Luster>& luster) {
  if (tissue == Tissue::dew) return "texture{Plant_Dew()}interior{ior 1.33}";
  std::string_view macro = kTissueMacros[static_cast<std::size_t>(tissue)];
  std::string text = lustrous(call_text(macro, color, second, shade), luster, relief_macro(tissue), {});
  if (tissue == Tissue::ivy) text += "interior_texture{" + call_text("Ivy_Under", color, second, shade) + '}';
  return text;
}

std::string shift_over(const ColorShift& by, const Color& mean) {
  return by.plain() ? "" : "texture{" + call_text("Plant_Filter", shift_filter(mean, by)) + '}';
}

std::string_view relief_macro(Tissue tissue) {
  return tissue == Tissue::leaf ? "Plant_Veined" : tissue == Tissue::petal ? "Plant_Pleated" : "";
}

std::string lustrous(const std::string& inside, const std::optional<Luster>& luster, std::string_view relief,
                     std::string_view file) {
  if (!luster) return "texture{" + inside + '}';
  std::string above = fmt::format(" Plant_Luster({:.4g},{:.4g})", luster->through, luster->gloss), rough;
  if (luster->relief > 0 && !relief.empty())
    rough = fmt::format(" {}({}{:.4g})", relief, file.empty() ? "" : fmt::format("\"{}\",", file),
                        luster->relief);
  return fmt::format("texture{{{0}{1}{2}}}interior_texture{{{0} Plant_Luster({3:.4g},0){2}}}", inside, above,
                     rough, luster->through);
}

std::string prototypes_text(const PovSpace& space, const Scene& scene, std::span<const double> pixel) {
  // The plants of an entry share shapes, but one that bears nothing need not have any. Those that none bears
  // are left out.
  struct Shapes {
    std::size_t entry;
    double pixel;                        // metres, of the nearest
    std::vector<const Prototype*> used;  // null where none bears it
  };
  std::vector<Shapes> entries;
  std::map<std::size_t, std::size_t> index;  // in `entries`, which are in the order of the scene
  for (std::size_t i = 0; i < scene.specimens.size(); ++i) {
    const Specimen& b = scene.specimens[i];
    if (!b.look.branches.plant()) continue;
    auto [at, fresh] = index.try_emplace(b.entry, entries.size());
    if (fresh) entries.push_back({b.entry, kUnknown, {}});
    float largest = largest_scale(b.model.organs);
    // At other times a tree bears organs whose scale is not known here; a school keeps its fish.
    if (largest <= 0 || (b.life.changes() && b.model.skeleton.size() > 0)) largest = std::max(largest, 1.0f);
    double& least = entries[at->second].pixel;
    if (pixel[i] > 0) least = std::min(least, pixel[i] / static_cast<double>(largest));
    std::vector<const Prototype*>& used = entries[at->second].used;
    used.resize(std::max(used.size(), b.model.prototypes.size()));
    auto use = [&](std::size_t p) { used[p] = used[p] ? used[p] : &b.model.prototypes[p]; };
    for (std::size_t p = 0; b.life.reshapes() && p < b.model.prototypes.size(); ++p) use(p);
    for (std::uint16_t which : b.model.organs.prototype) use(which);
  }
  std::string text;
  for (const Shapes& shapes : entries) {
    for (std::size_t p = 0; p < shapes.used.size(); ++p) {
      for (std::size_t part = 0; shapes.used[p] && part < shapes.used[p]->parts.size(); ++part) {
        text += fmt::format("#declare {} = ", organ_name(shapes.entry, p, part));
        const Surface& whole = shapes.used[p]->parts[part].surface;
        std::optional<Coarser> less =
            coarser(whole, shapes.pixel < kUnknown ? shapes.pixel : 0, scene.film.quality);
        append_mesh(text, space, less ? drawn_coarser(whole, *less) : whole);
        text += '\n';
      }
    }
  }
  return text;
}

std::size_t write_foliage(const PovSpace& space, const DrawList& drawn, double pixel, const Out& out) {
  std::size_t objects = 0;
  for (const OrganGroup& group : drawn.organs.groups) objects += write_group(space, drawn, group, pixel, out);
  const BladeLook& look = drawn.traits.look.blades;
  for (const DrawnBlades& blades : drawn.blades) {
    if (!has_faces(blades.surface)) continue;
    std::string text = "object{";
    append_mesh(text, space, blades.surface, {.decimals = decimals_for(space, pixel)});
    text += tissue_text(look.tissue, look.colors[blades.color], look.second, blades.shade, {});
    text += weather_over(drawn.traits.snowy, drawn.traits.wet, Wetting::leaf);
    text += "}\n";
    out(text);
    ++objects;
  }
  return objects;
}

}  // namespace frond
