#pragma once

#include <functional>

#include "accretion/margin.h"
#include "model/surface.h"

namespace frond {

/// How a sheet becomes a body.
struct SheetSkin {
  /// Metres from the sheet to its upper and to its lower side at a vertex, as a share 0..1 of its age: of all
  /// rows, those that have been laid before it since.
  std::function<float(std::uint32_t vertex, float age)> upper, lower;
  bool plumb = false;  ///< its sides lie above and below it, not to its left and right
  double lines = 0;    ///< metres, height of its growth lines
  double line = 0.01;  ///< metres from one growth line to the next
  double sprout = 0;   ///< share of growth in which the whole swells from nothing, as what has a stalk does
};

/// A body that has grown from a margin.
struct SheetBody {
  Surface surface;                      ///< closed; u of `uv` is the growth line, v the time of birth, 0..1
  std::vector<std::vector<Vec3>> past;  ///< see Solid::past
  std::uint32_t sides = 0;  ///< vertices of a side: vertex v of the sheet is v on top, v + sides below
};

SheetBody body_of(const Sheet& sheet, const SheetSkin& skin);

/// Where a sheet's vertices were after so many rows; those that are not yet there lie where they come up.
std::vector<Vec3> sheet_at(const Sheet& sheet, float row);

inline constexpr int kSheetSteps = 16;  ///< steps of the past

}  // namespace frond
