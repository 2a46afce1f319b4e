#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "core/seed.h"
#include "core/vec.h"
#include "images/raster.h"
#include "images/venation.h"
#include "model/surface.h"

namespace frond {

/// The outline of a leaf: a circle with radii at control points, from the tip (the first) at equal angles to
/// the start of the stalk (the last), interpolated smoothly and equal on both sides.
struct LeafOutline {
  std::vector<double> radii{1, 0.72, 0.58, 0.56, 0.55, 0.50, 0.42};
  double width = 1;     ///< factor of the width
  double teeth = 0;     ///< number along one side of the rim
  double tooth = 0;     ///< their depth as a share of the radius, 0..0.3
  double stalk = 0.18;  ///< length as a share of the whole
  Venation venation = {};
};

/// Outlines of known leaves: birch, beech, oak, maple, ivy, aspen, willow, linden, cherry, ginkgo. Empty
/// radii for any other name.
LeafOutline leaf_outline(std::string_view name);
std::span<const std::string_view> leaf_names();

enum class SprigArrangement { pinnate, digitate };

/// A sprig: leaves along a common stalk, or all from the end of it.
struct Sprig {
  SprigArrangement arrangement = SprigArrangement::pinnate;
  int pairs = 4;                 ///< 0 or more
  bool end_leaf = true;          ///< a single leaf at the tip
  double angle = radians(52.0);  ///< between leaf and stalk; of digitate ones, of the outermost
  double length = 0.42;          ///< of a leaf, as a share of the sprig's
  double shrink = 0.25;          ///< how much smaller the leaves at the tip, or the outermost, are, 0..0.9
  double alternate = 0;          ///< 0 in pairs .. 1 alternating
};

/// Position of a leaf on its sprig, whose stalk begins at the origin.
struct LeafPlace {
  Vec2 foot{0};
  double turn = 0;  ///< to the right, radians
  double size = 1;
};
std::vector<LeafPlace> sprig_places(const Sprig& sprig);

struct LeafPhoto;  // images/leaf_photo.h

/// A leaf or a sprig, and the appearance of its picture.
struct LeafImage {
  LeafOutline outline;
  bool sprig = false;
  Sprig sprigs;
  Color color{0.30f, 0.50f, 0.14f};
  Color veins{0.62f, 0.72f, 0.36f};
  Color rim{0.44f, 0.52f, 0.16f};
  double spots = 0.15;  ///< variation of colour over it, 0..1
  double pleat = 0;     ///< how deeply the mesh of a near leaf is folded along its secondaries, 0..1
  double age = 0;       ///< brown at the rim and in blotches, 0..1
  std::shared_ptr<const LeafPhoto> photo =
      {};  ///< shown where given, tinted by `color`, without veins, rim or spots
};

/// The part of the plane that a picture shows: x of -half..half, y of low..high.
struct PictureFrame {
  double half = 0, low = 0, high = 1;
};

/// The bounds of a whole leaf, or of a sprig with its leaves.
PictureFrame picture_frame(const LeafImage& leaf);

/// The right half of a blade's rim from tip to stalk as `points` (3 or more) that keep its shape best; one
/// unit from the foot of the stalk at the origin to the tip.
std::vector<Vec2> leaf_rim(const LeafOutline& outline, int points);

/// Position of the middle of the blade's circle on the stalk's line; the whole rim is visible from there.
double leaf_middle(const LeafOutline& outline);

/// How a leaf curls as it dries: its lobes bend upward by different angles.
struct LeafCurl {
  double share = 0;  ///< 0..1
  double phase = 0;  ///< radians; selects another variation
};

/// The picture of a leaf, with opacity; colours continue slightly beyond the rim. `height` in pixels.
Raster leaf_picture(const LeafImage& leaf, int height, Seed seed);

/// The leaf of leaf_picture() as a mesh one unit long: the foot at the origin, growing along +y, the upper
/// side toward +z, `uv` of the picture. Each half of each leaf has `points` on its rim: few for far leaves, 3
/// a diamond. `fold` raises the halves, `bend` lowers the tip; radians. A curled leaf has points inside the
/// rim, too.
Surface leaf_mesh(const LeafImage& leaf, int points, double fold, double bend, const LeafCurl& curl = {});

}  // namespace frond
