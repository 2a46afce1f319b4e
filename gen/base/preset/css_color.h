#pragma once

#include <optional>
#include <string_view>

#include "core/vec.h"

namespace frond {

/// A colour as CSS Color 4 writes it, in any case: one of the 148 names ("goldenrod"), "#d92", "#dd9922",
/// "rgb(221, 153, 34)" (0 to 255, or percentages) or "hsl(38, 73%, 50%)", also with blanks for the commas.
/// None where it is no such text, a number is out of its range, or the colour would let something through.
std::optional<Color> css_color(std::string_view text);

/// The name nearest to a misspelt one, or empty where none is near enough.
std::string_view nearest_css_name(std::string_view text);

}  // namespace frond
