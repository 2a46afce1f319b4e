#pragma once

#include <string_view>
#include <vector>

#include "core/result.h"
#include "core/vec.h"
#include "images/raster.h"

namespace frond {

/// A plane shape, one unit high, standing on y = 0, with its middle at x = 0.
class Silhouette {
 public:
  /// From closed outlines in any unit, y up; points inside an odd number of them are inside.
  static Result<Silhouette> from_outlines(std::vector<std::vector<Vec2>> outlines);
  /// From a picture: the opaque pixels if it has transparency, else the dark ones.
  static Result<Silhouette> from_picture(const Raster& picture);

  bool inside(Vec2 at) const;
  float width() const { return width_; }

 private:
  std::vector<std::vector<Vec2>> outlines_;
  std::vector<bool> filled_;  // rows from the bottom up, if made from a picture
  int columns_ = 0, rows_ = 0;
  float width_ = 1;
};

/// The outlines of SVG path data (`M L H V C S Q T A Z`, absolute and relative; SVG 1.1, 8.3), curves as line
/// segments, y down as in SVG. Errors name the position in the text.
Result<std::vector<std::vector<Vec2>>> read_svg_path(std::string_view data);

/// The `d` of every path of an SVG file in order. Transforms are not applied.
Result<std::vector<std::vector<Vec2>>> read_svg(std::string_view svg);

}  // namespace frond
