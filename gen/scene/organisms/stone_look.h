#pragma once

#include <optional>

#include "appearance/appearance.h"
#include "core/mask.h"
#include "core/result.h"
#include "core/seed.h"
#include "preset/describe.h"
#include "rocks/rock.h"

namespace frond {

enum class StoneKind { granite, limestone, basalt, reef };

/// The surface of rocks.
struct StoneLook {
  StoneKind kind = StoneKind::granite;
  std::optional<Color> color, second;  ///< of the stone and of its pattern; none: those of its kind
  double scale = 0.12;                 ///< metres, size of the pattern
  double relief = 0.5;                 ///< depth of its grain and cracks
  double moss = 0;                     ///< 0 none .. 1: moss and lichen
  Mask moss_map;                       ///< scales it; it has an area
  double variation = 0.08;             ///< variation of brightness between stones
};

// As presets spell them; see preset/describe.h.
void describe(Properties& v, StoneLook& s);

/// All properties of a shape except its size.
void describe_shape(Properties& v, RockShape& s);

/// The error for a map of moss without an area.
Errors check_stone(const StoneLook& look);
/// What an organism of such stone wears: the picture that scales its moss.
Appearance stone_appearance(const StoneLook& look);

/// The material of one stone.
Material material_of(const StoneLook& look, Seed seed);

/// Errors for a shape without an inside, and for ranges with minimum above maximum.
Errors check_rock(const RockShape& shape);
/// The error for a form of which nothing is left when it is meshed.
Error hollow_rock(RockForm form);

/// Predicted number of triangles of a rock: the smaller of what its tolerance needs and what its finest cells
/// give.
double estimate_triangles(const RockShape& shape);

/// Height of a mesh on the ground, metres.
float height_of(const Surface& surface);

}  // namespace frond
