#pragma once

#include <string>

#include "core/text.h"
#include "emit/pov.h"
#include "scene/scene.h"

namespace frond {

/// Whether the bark has a pattern, which must move with the branch.
bool patterned(const Bark& bark);

/// Whether that pattern goes round the branch, so that it must lie along it from the start.
bool ringed(const Bark& bark);

/// Whether a chunk is a limb thick enough to show a bark that lies along it, and not upright, where it does
/// so anyway.
bool slanted(const Specimen& plant, const Chunk& chunk);

/// Whether all branches of a plant have one and the same texture in the whole film, which then stands on
/// their union.
bool one_texture(const Specimen& plant);

/// Which of the colours of its bark a node has.
std::size_t bark_color(const Specimen& plant, std::int32_t node);

/// The macro that raises the relief of a tissue; empty: it has none.
std::string_view relief_macro(Tissue tissue);

/// The textures of an organ, given what stands inside `texture { }`: with a gloss above, none below and a
/// relief by that macro, which may take a `file`, where it has a luster of its own.
std::string lustrous(const std::string& inside, const std::optional<Luster>& luster, std::string_view relief,
                     std::string_view file);

/// Appends the calls that declare the skins of a plant, one for each colour of its bark, from `first` on.
void append_bark(std::string& text, const Specimen& plant, std::size_t first);

/// Declares the organs of all plants, once for each entry of the preset, and what they are made of.
std::string prototypes_text(const PovSpace& space, const Scene& scene);

/// Writes the organs and blades of one plant at a pose and a time: for each material one union or one mesh.
/// Gives how many of these there are.
std::size_t write_foliage(const PovSpace& space, const Specimen& plant, const Pose& pose, double time,
                          const Out& out);

}  // namespace frond
