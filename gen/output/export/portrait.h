#pragma once

#include <map>
#include <span>
#include <vector>

#include "core/bounds.h"
#include "export/export_scene.h"
#include "images/raster.h"

namespace frond {

/// Straight along a direction, which is across `right` and `up` toward the eye: what lies between two
/// corners.
struct PortraitView {
  Vec3 right{1, 0, 0}, up{0, 1, 0};  ///< of length 1
  Vec2 low{0}, high{1};              ///< metres along these
  int wide = 256, high_pixels = 256;
  int fine = 3;  ///< samples across a pixel
};

/// Rows from the top down.
struct Portrait {
  int wide = 0, high = 0;
  std::vector<float> cover;   ///< the share of each pixel in which something is
  std::vector<Vec3> light;    ///< linear, of what is there
  std::vector<Vec3> normal;   ///< of what is there: to the right, up, to the eye
  std::vector<float> leaves;  ///< the share of each pixel in which a leaf is seen

  /// The share of the whole picture in which something is.
  double covered() const;
};

/// Some triangles of a part, or all of them if none are named.
struct Sitter {
  const ExportPart* part;
  std::vector<std::uint32_t> triangles = {};
};

/// Draws parts of an exported scene in even light, with the pictures that they wear and open where these are.
class Painter {
 public:
  explicit Painter(const ExportScene& exported) : scene_(exported) {}

  /// What one of the scene's pictures shows, in place of its file.
  void wear(std::size_t picture, Raster shown) { pictures_[picture] = std::move(shown); }

  Result<Portrait> portrait(std::span<const Sitter> sitters, const PortraitView& view);

 private:
  Result<const Raster*> picture(std::size_t index);

  const ExportScene& scene_;
  std::map<std::size_t, Raster> pictures_;
};

/// How much parts in a box cover from eight sides, m2, the sum of all.
Result<double> silhouettes(Painter& painter, std::span<const Sitter> sitters, const Bounds& box);

/// A view of a box from the side, so many radians round the vertical.
PortraitView side_view(const Bounds& box, double turn, int pixels);

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
