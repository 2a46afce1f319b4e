#pragma once

#include <cstdint>
#include <vector>

#include "export/portrait.h"

namespace frond {

/// Portraits of equal size side by side, as a picture of colours with opacity and one of normals.
class PictureSheet {
 public:
  /// So many portraits, each in a cell of so many pixels, a margin counted in, that the next one does not
  /// show in it.
  PictureSheet(int cells, int pixels);

  /// Pixels of a portrait.
  int inner() const;
  void put(const Portrait& portrait, int number);

  /// Makes so large a share of what each portrait covers opaque, of leaves and of wood alike: what fills its
  /// pixel first. Where all pixels are full leaves get holes.
  void cut(double share);

  /// Corners of a portrait on the sheet, v upward.
  Vec2 corner(int number, bool high) const;

  /// What is open takes the colours of what is next to it, or edges would be seen dark; gives the mean of
  /// all.
  Color fill();

  const Raster& colors() const { return colors_; }
  const Raster& normals() const { return normals_; }

 private:
  std::size_t nearest(std::size_t i) const;

  int cell_, columns_;
  Raster colors_, normals_;
  std::vector<float> rank_;  // of each pixel, the share from which it is opaque; 0 where nothing is
};

}  // namespace frond
