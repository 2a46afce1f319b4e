#pragma once

#include <functional>

#include "accretion/margin.h"
#include "model/surface.h"

namespace frond {

/// How a sheet becomes a body.
struct SheetSkin {
  /// Metres from the sheet to its upper and to its lower side at a vertex, by its age 0..1: the share of all
  /// rows that were laid after it.
  std::function<float(std::uint32_t vertex, float age)> upper, lower;
  bool plumb = false;  ///< the sides lie above and below the sheet, not along its normals
  double lines = 0;    ///< metres, height of its growth lines
  double line = 0.01;  ///< metres from one growth line to the next
  double sprout = 0;   ///< share of growth in which the whole grows from size 0, for bodies with a stalk
};

/// A body made from a sheet.
struct SheetBody {
  Surface surface;                      ///< closed; u of `uv` is the growth line, v the time of birth, 0..1
  std::vector<std::vector<Vec3>> past;  ///< see Solid::past
  std::uint32_t sides = 0;  ///< vertices of one side: vertex v of the sheet is v on top and v + sides below
};

SheetBody body_of(const Sheet& sheet, const SheetSkin& skin);

/// The vertices of a sheet after `rows` rows; those not laid yet lie where they will appear.
std::vector<Vec3> sheet_at(const Sheet& sheet, float row);

inline constexpr int kSheetSteps = 16;  ///< steps of the past

}  // namespace frond
