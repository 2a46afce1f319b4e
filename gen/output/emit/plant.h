#pragma once

#include <span>
#include <string>

#include "core/text.h"
#include "draw/draw_list.h"
#include "emit/pov.h"
#include "scene/scene.h"

namespace frond {

/// The layer over a picture that shifts its colours, `mean` being that of the picture; empty where
/// it changes none.
std::string shift_over(const ColorShift& by, const Color& mean);

/// The macro that raises the relief of a tissue; empty: it has none.
std::string_view relief_macro(Tissue tissue);

/// The textures of an organ, given what stands inside `texture { }`: with a gloss above, none below and a
/// relief by that macro, which may take a `file`, where it has a luster of its own.
std::string lustrous(const std::string& inside, const std::optional<Luster>& luster, std::string_view relief,
                     std::string_view file);

/// What stands in an object of a tissue: `texture{...}`, and where it has one that of its other side. `shade`
/// tells single organs apart, 0 to 2.
std::string tissue_text(Tissue tissue, const Color& color, const Color& second, std::size_t shade,
                        const std::optional<Luster>& luster);

/// Declares the organs of all plants, once for each entry of the preset, and what they are made of.
/// `pixel`: of each specimen, metres; 0: in all detail.
std::string prototypes_text(const PovSpace& space, const Scene& scene, std::span<const double> pixel);

/// Writes the organs and blades of one plant: for each material one union or one mesh. `pixel`: metres, 0: no
/// number is shortened. Gives how many objects these are.
std::size_t write_foliage(const PovSpace& space, const DrawList& drawn, double pixel, const Out& out);

}  // namespace frond
