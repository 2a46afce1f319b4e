#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/vec.h"

namespace frond {

/// Position and drawing values of the turtle. Right-handed: heading x left = up.
struct TurtleState {
  /// Value of `target` without a guide point: not led yet, or led to the end.
  static constexpr std::int32_t kNotLed = -1, kFree = -2;

  DVec3 position{0, 0, 0};
  DVec3 heading{0, 1, 0}, left{-1, 0, 0}, up{0, 0, 1};
  double length = 1, width = 0.1, angle = 45, elasticity = 0;
  int color = 0;
  int depth = 0;           ///< number of open brackets
  double grown = 1;        ///< 0..1: growth of the current module between two steps
  std::int32_t mark = -1;  ///< used by the sink: saved and restored by brackets; -1 after a move
  std::int32_t tube = -1;  ///< used by the sink: the last point of a generalized cylinder, -1 outside of one
  std::int32_t base = -1;  ///< used by the sink: as mark, but unchanged by a move
  std::int32_t target = kNotLed;  ///< the guide point it goes to
  std::int32_t pull = -1;         ///< guide point whose tropism counts; -1: the grammar's
  double own_length = 1;          ///< its step before it was led
  double width_here = -1;         ///< the width where it stands, if it is led to another one; else -1

  /// The width with which a segment begins here; from now on it is that of all others.
  double consume_width() {
    double here = width_here < 0 ? width : width_here;
    width_here = -1;
    return here;
  }
};

/// A line that the turtle drew, before it moves on; widths are diameters.
struct Segment {
  DVec3 from, to;
  double width_from, width_to;
};

/// A module between two steps, changing from its parent's form to its own.
struct Unfolding {
  double age = 1;      ///< 0..1: growth of turns, widths and organs
  double stretch = 1;  ///< factor of lengths
  double from = 0;     ///< initial value of its first parameter, if `has_from`
  bool has_from = false;
};

/// The colour index given by a parameter. Colours are used modulo their number, so the index used beyond the
/// range of int hardly matters.
inline int color_index(double value) {
  return std::isfinite(value) ? static_cast<int>(std::clamp(value, -1e9, 1e9)) : 0;
}

/// Bends the heading toward a pull (ABOP 2.3.3): turned by e|H x T| about H x T.
inline void bend(TurtleState& turtle, DVec3 pull, double elasticity) {
  DVec3 axis = glm::cross(turtle.heading, pull);
  double strength = glm::length(axis);
  if (!(strength > 0)) return;
  axis /= strength;
  double angle = elasticity * strength, c = std::cos(angle), s = std::sin(angle);
  for (DVec3* v : {&turtle.heading, &turtle.left, &turtle.up})
    *v = *v * c + glm::cross(axis, *v) * s + axis * (glm::dot(axis, *v) * (1 - c));
}

/// Turns the heading to a direction by the shortest rotation.
inline void head_for(TurtleState& turtle, DVec3 direction) {
  double length = glm::length(direction);
  if (!(length > 0)) return;
  direction /= length;
  DVec3 axis = glm::cross(turtle.heading, direction);
  double s = glm::length(axis), c = glm::dot(turtle.heading, direction);
  axis = s > 1e-12 ? axis / s : turtle.up;
  if (s <= 1e-12) s = 0, c = c < 0 ? -1 : 1;
  for (DVec3* v : {&turtle.left, &turtle.up})
    *v = *v * c + glm::cross(axis, *v) * s + axis * (glm::dot(axis, *v) * (1 - c));
  turtle.heading = direction;
}

/// Rolls until the left vector is horizontal and up points up, or a share of that roll; a vertical heading
/// stays as it is.
inline void level(TurtleState& turtle, double share) {
  DVec3 left = glm::cross(DVec3(0, 1, 0), turtle.heading);
  double length = glm::length(left);
  if (length < 1e-9) return;
  left /= length;
  if (share < 1) {
    double roll = std::atan2(glm::dot(left, turtle.up), glm::dot(left, turtle.left)) * share;
    left = turtle.left * std::cos(roll) + turtle.up * std::sin(roll);
  }
  turtle.left = left;
  turtle.up = glm::cross(turtle.heading, turtle.left);
}

}  // namespace frond
