#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/assets.h"
#include "core/vec.h"

namespace frond {

/// An axis of the world.
enum class Axis { x, y, z };

/// A picture that scales something over a rectangle of the world: 0 where it is black, none of it, to 1 where
/// it is white, all of it. It is the same at all places along its axis.
struct Mask {
  FileName file;              ///< a PNG; empty: none
  std::optional<Axis> along;  ///< none: y, if what it lies on has no other way of its own
  /// Two opposite corners of what the picture covers, metres: x and z along y, x and y along z, z and y along
  /// x; beyond them its edges go on. The left of the picture is the lower first coordinate; its top is the
  /// higher y, or the lower z. Empty: what it is laid on.
  std::vector<Vec2> area;
  int width = 0, height = 0;                       ///< pixels
  std::shared_ptr<const std::vector<float>> grey;  ///< 0..1, rows from the top down; null: white all over

  bool empty() const { return !grey; }
  /// The name of the picture of this mask that frames use.
  std::string picture_name() const { return "mask_" + file.content + ".png"; }
  /// The value of the mask at shares of its width, from the left, and of its height, from the top, 0..1,
  /// between the middles of pixels; 1 where the mask is empty.
  double at_share(double across, double down) const;
  /// The value of the mask at a place; without an area the mask covers the box from `low` to `high`.
  double at(const DVec3& place, const DVec3& low, const DVec3& high) const;
  /// The value of the mask on land of `side` metres about the origin.
  double on_land(Vec2 at, double side) const;
};

}  // namespace frond
