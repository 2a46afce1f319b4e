#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/assets.h"
#include "core/result.h"
#include "core/vec.h"

namespace frond {

struct TurtleState;

/// A target point of a guided turtle, in the turtle's units and axes, and values that it takes on there.
struct GuidePoint {
  static constexpr std::int32_t kRoot = -1;

  DVec3 at{0};
  std::int32_t parent = kRoot;  ///< the point before it
  /// Handles of Bézier curves, from the point; one that is missing is opposite to the other.
  std::optional<DVec3> in = {}, out = {};
  /// The turtle's drawing values from here on. The radius is approached gradually.
  std::optional<double> radius = {};
  std::optional<double> angle = {};  ///< degrees, of turns without a parameter
  std::optional<double> elasticity = {};
  std::optional<DVec3> tropism = {};
};

/// Lines between numbered places: the `l` elements of an OBJ file.
struct GuideLines {
  std::vector<DVec3> place;
  std::vector<std::array<std::uint32_t, 2>> line;
};

/// A guide as its author writes it: points, a curve, or a file of lines.
struct GuideText {
  std::vector<GuidePoint> points;
  std::vector<int> parent;    ///< if not empty: the predecessor of each point, -1 for a first one
  std::vector<DVec3> bezier;  ///< control points of a curve of any degree
  int samples = 24;           ///< pieces that the curve is cut into
  FileName file;              ///< of lines; the caller reads it into `lines`
  GuideLines lines;
  double tolerance = 0.1;   ///< distance within which a point counts as reached
  double leniency = 0.5;    ///< length of a step as a share of the distance to the point
  bool reach_ends = false;  ///< whether points without children must be reached as well

  bool empty() const { return points.empty() && bezier.empty() && file.empty() && lines.line.empty(); }
};

/// A guide ready to use: trees of points, parents before children.
struct Guide {
  std::vector<GuidePoint> points;
  std::vector<std::uint32_t> first_child;  ///< of each point in `child`, and one more
  std::vector<std::int32_t> child;
  std::vector<std::int32_t> roots;
  double tolerance = 0.1, leniency = 0.5;
  bool reach_ends = false;

  std::span<const std::int32_t> children(std::int32_t point) const {
    auto i = static_cast<std::size_t>(point);
    return std::span(child).subspan(first_child[i], first_child[i + 1] - first_child[i]);
  }
  std::size_t leaves() const;
};

/// Sorts the points of a guide, samples its curves, connects its lines. Missing parents, cycles of points and
/// curves of one point are errors.
Result<Guide> guide_of(const GuideText& text);

/// The point of a Bézier curve of any degree at t in 0..1, by de Casteljau's halving of its polygon.
DVec3 bezier_point(std::span<const DVec3> control, double t);

/// The trees of points made from lines: each connected part has the first point of its first line as root.
/// Equal positions are one point; a line that would close a cycle is dropped.
std::vector<GuidePoint> points_of(const GuideLines& lines);

/// The action of `?`: the turtle turns to its target and steps by `leniency` of the distance to it. Within
/// `tolerance` of the target it returns the target's children; the turtle continues to each of them, see
/// lead(). Without children it goes on with the step length that it had before it was led; with `reach_ends`
/// only once it is there.
std::span<const std::int32_t> follow(const Guide& guide, TurtleState& turtle);

/// Sets the target of a turtle and turns it there.
void lead(const Guide& guide, TurtleState& turtle, std::int32_t target);

}  // namespace frond
