#pragma once

#include <cstddef>
#include <iterator>
#include <string_view>

namespace frond {

/// Materials of solids. Each is a row below and a macro of povinc/, which alone says what it looks like.
enum class Matter {
  plain,      ///< one matt colour
  brick,      ///< fired clay, each slightly different
  mortar,     ///< sandy, between bricks
  limestone,  ///< dressed, weathered
  plaster,    ///< lime, flaking
  paint,      ///< on wood
  pane,       ///< a window before a dark room
  timber,     ///< sawn wood, grain along x, the pith on the x axis
  ashlar,     ///< dressed stone
  bed,        ///< the mortar around it
  ceramic,    ///< glazed; `scale` is the vessel's height, as of everything turned
  terracotta,
  glass,
  soil,
  granite,  ///< speckled, massive
  karst,    ///< natural limestone: pale, banded and pitted
  basalt,   ///< dark, fine and cracked
  // What lives; u of its `uv` is 0 in hollows .. 1 on ridges, v the share of growth after which it was there.
  polyps,   ///< stony coral with a cup for each polyp; `scale` is that of a cup
  meander,  ///< brain coral: valleys between ridges, by u
  sponge,   ///< soft, pitted
  reef,     ///< old coral rock, overgrown with crusts and turf of algae
  // Materials with a picture by `uv`; `second` is multiplied with it.
  shell,
  mantle,  ///< soft tissue of a clam
  snow,    ///< that lies
  water,   ///< of puddles
};

/// What a material is, beside how it looks.
enum class Nature {
  other,
  stone,   ///< moss and lichen grow on it
  vessel,  ///< turned on a wheel: its pattern lies round the y axis
  coral,   ///< tissue that lives by light
  tissue,  ///< that lives, in the shade as well
  reef,    ///< rock that such skins made
};

struct MatterRow {
  Matter matter;
  /// The file of povinc/, as `stone` for frond_stone.inc, and its macro, called inside texture { } as
  /// Macro(Color, Second, Scale, Relief, Moss, Gloss); what wears a picture has its file's name before these.
  std::string_view include, macro;
  /// How many times its `scale` a picture of it is wide; 0: it has no pattern.
  double widths;
  Nature nature = Nature::other;
  std::string_view inside = {};  ///< the macro of what stands in interior { }, of what light goes through
};

inline constexpr MatterRow kMatters[] = {
    {Matter::plain, "matter", "Matter_Plain", 0},
    {Matter::brick, "masonry", "Masonry_Brick", 14},
    {Matter::mortar, "masonry", "Masonry_Mortar", 8},
    {Matter::limestone, "masonry", "Masonry_Limestone", 8},
    {Matter::plaster, "masonry", "Masonry_Plaster", 24},
    {Matter::paint, "masonry", "Masonry_Paint", 24},
    {Matter::pane, "masonry", "Masonry_Pane", 0},
    {Matter::timber, "wood", "Wood_Timber", 24},
    {Matter::ashlar, "ashlar", "Ashlar_Stone", 3, Nature::stone},
    {Matter::bed, "ashlar", "Ashlar_Bed", 3, Nature::stone},
    {Matter::ceramic, "vessel", "Vessel_Ceramic", 1, Nature::vessel},
    {Matter::terracotta, "vessel", "Vessel_Terracotta", 1, Nature::vessel},
    {Matter::glass, "vessel", "Vessel_Glass", 0, Nature::vessel, "Vessel_Glass_Inside"},
    {Matter::soil, "vessel", "Vessel_Soil", 40},
    {Matter::granite, "stone", "Stone_Granite", 8.4, Nature::stone},
    {Matter::karst, "stone", "Stone_Limestone", 8.4, Nature::stone},
    {Matter::basalt, "stone", "Stone_Basalt", 8.4, Nature::stone},
    {Matter::polyps, "reef", "Reef_Polyps", 24, Nature::coral},
    {Matter::meander, "reef", "Reef_Meander", 24, Nature::coral},
    {Matter::sponge, "reef", "Reef_Sponge", 24, Nature::tissue},
    {Matter::reef, "reef", "Reef_Rock", 5, Nature::reef},
    {Matter::shell, "shell", "Shell_Porcelain", 0},
    {Matter::mantle, "shell", "Shell_Mantle", 0},
    {Matter::snow, "snow", "Snow_Lying", 0},
    {Matter::water, "rain", "Rain_Water", 0, Nature::other, "Rain_Water_Inside"}};

constexpr const MatterRow& row_of(Matter matter) { return kMatters[static_cast<std::size_t>(matter)]; }

static_assert([] {
  for (std::size_t i = 0; i < std::size(kMatters); ++i)
    if (kMatters[i].matter != static_cast<Matter>(i)) return false;
  return true;
}());

/// Tissue that lives.
constexpr bool is_tissue(Matter m) {
  return row_of(m).nature == Nature::coral || row_of(m).nature == Nature::tissue;
}
/// The skin of what lives on a reef, or the rock that such skins made: its texture knows how far it has
/// grown.
constexpr bool is_of_reef(Matter m) { return is_tissue(m) || row_of(m).nature == Nature::reef; }
/// What moss and lichen grow on.
constexpr bool is_rock(Matter m) {
  return row_of(m).nature == Nature::stone || row_of(m).nature == Nature::reef;
}

}  // namespace frond
