#pragma once

#include <optional>
#include <string_view>

#include "scene/preset.h"

namespace frond {

/// An angle that is given as so few degrees was meant as radians.
inline constexpr double kRadians = 1.5;

/// The settings that a preset's own file gives, or the command line, and that do nothing in it: of another
/// surrounding, or of a motion that is left at 0. What a base or the defaults bring may be meant for others
/// and is passed over. `preset.written` must be there.
Errors unused_properties(const Preset& preset, const std::string& file_name);

/// What the sentence of a property says that it does nothing without: `Needs "shape": "own"`, `Needs "build":
/// "fused" or "rough"`, `Needs "sprig": true`, `Needs a patch above 0`, `Needs fading other than diffuse`.
/// Always of a property beside it.
struct Need {
  std::string_view name;  ///< of that property
  enum class Of { equal, other, above_0 } of = Of::equal;
  std::string_view value;  ///< as JSON, but for a text without its first and last quote
  std::string_view words;  ///< what follows the word "Needs"
};

/// The need in a sentence; nothing where it has none, or one of another kind, such as `Needs a coat`.
std::optional<Need> need_of(std::string_view sentence);

}  // namespace frond
