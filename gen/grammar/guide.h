#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/result.h"
#include "core/vec.h"

namespace frond {

struct TurtleState;

/// A place that a guided turtle is led to, in the turtle's units and axes, and what it takes on there.
struct GuidePoint {
  static constexpr std::int32_t kRoot = -1;

  DVec3 at{0};
  std::int32_t parent = kRoot;  ///< the point before it
  /// What the turtle draws with from here on. The radius is approached on the way.
  std::optional<double> radius = {};
  std::optional<double> angle = {};  ///< degrees, of bare turns
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
  std::vector<int> parent;    ///< where not empty: the point before each point, -1 for a first one
  std::vector<DVec3> bezier;  ///< control points of a curve of any degree
  int samples = 24;           ///< pieces that the curve is cut into
  std::string file;           ///< of lines; who reads it fills `lines`
  GuideLines lines;
  double tolerance = 0.1;   ///< how near to a point counts as there
  double leniency = 0.5;    ///< a step is this share of the way to the point
  bool reach_ends = false;  ///< whether a point without children must be come to as well

  bool empty() const { return points.empty() && bezier.empty() && file.empty() && lines.line.empty(); }
};

/// A guide ready to be followed: trees of points, parents before children.
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

/// Sorts the points of a guide, samples its curve, strings its lines together. What cannot be followed (a
/// parent that is not there, points in a circle, a curve of one point) is an error.
Result<Guide> guide_of(const GuideText& text);

/// The point of a Bézier curve of any degree at t in 0..1, by de Casteljau's halving of its polygon.
DVec3 bezier_point(std::span<const DVec3> control, double t);

/// The trees of points that lines make: each connected part hangs from the first place of the first line in
/// it. Places that coincide are one; a line that would close a circle is left out.
std::vector<GuidePoint> points_of(const GuideLines& lines);

/// What a turtle does at `?`: it turns to its target
/// and makes its step `leniency` of the way to it. Within `tolerance` of the target the result is the
/// target's children: a turtle is to go on to each of them, see lead(). Where there are no children it goes
/// on as usual, with the step that it had before it was led; with `reach_ends` only once it is there.
std::span<const std::int32_t> follow(const Guide& guide, TurtleState& turtle);

/// Gives a turtle a target, and turns it there.
void lead(const Guide& guide, TurtleState& turtle, std::int32_t target);

}  // namespace frond
