#include "appearance/leaf_look.h"

#include <fmt/format.h>

#include <algorithm>

#include "appearance/describe.h"
#include "appearance/photographs.h"
#include "core/content.h"
#include "images/leaf_photo.h"
#include "preset/keys.h"

namespace frond {

namespace {

LeafTint leaf_tint(const LeafLook& look, std::size_t color) {
  color %= look.looks();
  bool own = color < look.colors.size();
  return own ? LeafTint{look.colors[color], look.veins, look.rim} : look.turned[color - look.colors.size()];
}

/// Where the spots of a leaf of that colour lie: in all seasons the same.
std::uint64_t spots_of(const LeafLook& look, std::size_t color) {
  return color < look.colors.size() ? color : 0;
}

/// A picture without opacity, for the mesh has the outline: to POV-Ray a leaf with an opacity is one that
/// each ray of light must look through. Where nothing is drawn it has the colour of the rim.
Raster opaque(const Raster& from, const Color& rim) {
  Raster to(from.width, from.height, 3);
  std::uint8_t ground[] = {to_byte(rim.red), to_byte(rim.green), to_byte(rim.blue)};
  for (std::size_t i = 0; i < to.data.size() / 3; ++i) {
    const std::uint8_t* pixel = &from.data[4 * i];
    bool drawn = pixel[0] != 0 || pixel[1] != 0 || pixel[2] != 0;
    std::copy_n(drawn ? pixel : ground, 3, &to.data[3 * i]);
  }
  return to;
}

/// The sprigs along branches, where they are others than those at their ends.
std::optional<LeafLook> side_sprigs(const LeafLook& look) {
  if (!look.sprig || !look.end_sprigs || !look.sprigs.end_leaf) return std::nullopt;
  LeafLook side = look;
  side.end_sprigs = side.sprigs.end_leaf = false;
  return side;
}

}  // namespace

std::string picture_name(LeafLook look, std::size_t color) {
  std::uint64_t spots = spots_of(look, color);
  LeafTint tint = leaf_tint(look, color);
  look.colors = {tint.color}, look.veins = tint.veins, look.rim = tint.rim;
  return fmt::format("leaf_{}.png", made_id(fmt::format("{} {}", keys_of(std::move(look)).look, spots)));
}

std::vector<LeafLook> variants(const LeafLook& look) {
  std::vector<LeafLook> all{look};
  if (auto side = side_sprigs(look)) all.push_back(std::move(*side));
  return all;
}

Drawing drawing_of(std::string name, double pixels, double seconds_a_pixel, std::function<Raster()> draw) {
  auto made = [name, draw = std::move(draw)]() -> Result<std::vector<Picture>> {
    Result<std::string> bytes = png_text(draw());
    if (!bytes) return bytes.errors();
    return std::vector<Picture>{{name, std::move(*bytes)}};
  };
  return {{std::move(name)}, std::move(made), pixels, seconds_a_pixel * pixels};
}

Errors load_leaf_photo(const NamedFile& file, bool colored, LeafLook& look) {
  auto photo = photograph<LeafPhoto>(file, read_leaf_photo,
                                     [](const LeafPhoto& p) { return 2 * p.levels.front().data.size(); });
  if (!photo) return photo.errors();
  if (!colored) look.colors = {(*photo)->mean};
  look.photographed = std::move(*photo);
  return {};
}

LeafImage leaf_image(const LeafLook& look, std::size_t color) {
  LeafImage leaf;
  leaf.photo = look.photographed;
  if (leaf.photo) {
    leaf.outline = leaf.photo->outline;
  } else if (look.shape == LeafShape::own) {
    if (!look.outline.empty()) leaf.outline.radii = look.outline;
  } else {
    leaf.outline = leaf_outline(leaf_names()[static_cast<std::size_t>(look.shape)]);
  }
  leaf.outline.width *= look.width;
  if (look.stalk) leaf.outline.stalk = *look.stalk;
  if (look.teeth) leaf.outline.teeth = *look.teeth;
  if (look.tooth) leaf.outline.tooth = *look.tooth;
  if (look.palmate)
    leaf.outline.venation.pattern = *look.palmate ? VeinPattern::palmate : VeinPattern::pinnate;
  if (look.venation) leaf.outline.venation.pattern = *look.venation;
  if (look.secondaries) leaf.outline.venation.secondaries = *look.secondaries;
  leaf.outline.venation.density = look.vein_density;
  leaf.outline.venation.loops = look.loops;
  leaf.pleat = look.pleat;
  leaf.sprig = look.sprig;
  leaf.sprigs = look.sprigs;
  LeafTint tint = leaf_tint(look, color);
  leaf.color = tint.color;
  leaf.veins = tint.veins;
  leaf.rim = tint.rim;
  leaf.spots = look.spots;
  leaf.age = look.age;
  return leaf;
}

Prototype leaf_prototype(const LeafLook& look, double phase) {
  Prototype made{"leaf", {}, look.colors, look.veins};
  OrganPart part{Tissue::leaf,
                 leaf_mesh(leaf_image(look, 0), look.detail, look.fold, look.bend, {look.curl, phase})};
  for (std::size_t i = 0; i < look.looks(); ++i) part.pictures.push_back(picture_name(look, i));
  made.luster = look.luster;
  for (const LeafTint& tint : look.turned) made.colors.push_back(tint.color);
  if (!look.turned.empty()) made.summer = look.colors.size();
  made.parts.push_back(std::move(part));
  return made;
}

std::vector<Prototype> leaf_prototypes(const LeafLook& look) {
  std::vector<Prototype> all{leaf_prototype(look)};
  if (auto side = side_sprigs(look)) all.push_back(leaf_prototype(*side));
  if (look.sprig)
    for (Prototype& prototype : all) prototype.name = "sprig";
  return all;
}

LeafLook shown_in(const LeafLook& look, const std::string& picture) {
  std::optional<LeafLook> side = side_sprigs(look);
  for (std::size_t i = 0; side && i < side->looks(); ++i)
    if (picture_name(*side, i) == picture) return *side;
  return look;
}

std::vector<Drawing> leaf_drawings(const LeafLook& look) {
  constexpr double kSecondsAPixel = 1.8e-6;
  std::vector<Drawing> drawings;
  PictureFrame frame = picture_frame(leaf_image(look, 0));
  double pixels = 2 * frame.half / (frame.high - frame.low) * look.pixels * look.pixels;
  for (std::size_t i = 0; i < look.looks(); ++i)
    drawings.push_back(
        drawing_of(picture_name(look, i), pixels, kSecondsAPixel,
                   [image = leaf_image(look, i), high = look.pixels, spots = Seed{spots_of(look, i)}] {
                     return opaque(leaf_picture(image, high, spots), image.rim);
                   }));
  if (auto side = side_sprigs(look)) std::ranges::move(leaf_drawings(*side), std::back_inserter(drawings));
  return drawings;
}

}  // namespace frond
