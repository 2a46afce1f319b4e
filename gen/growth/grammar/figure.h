#pragma once

#include "grammar/turtle.h"

namespace frond {

/// Measurements of what a word draws.
struct TurtleStats {
  std::size_t segments = 0, polygons = 0;
  double total_length = 0;
  DVec3 end_position{0}, end_heading{0, 1, 0}, end_left{-1, 0, 0}, end_up{0, 0, 1};
  std::vector<DVec3> end_positions;  ///< of all turtles, if a guide forked; the first is end_position
  DVec3 low{0}, high{0};             ///< bounding box of the drawing; the start if nothing is drawn
  int max_stack_depth = 0;
};

TurtleStats stats_of(const Grammar& grammar, const Word& word, Seed seed);

/// Measurements of what the word after `steps` steps draws; a fractional number gives an interpolated shape
/// (between.h). The word is not stored where that is not needed.
Result<TurtleStats> stats_of(const Grammar& grammar, double steps, Seed seed, const Limits& limits = {});

/// The message for a turtle that leaves the drawable range.
Errors out_of_range();

/// A filled outline: a leaf, a petal.
struct Outline {
  std::vector<Vec3> points;
  int color = 0;
  std::int32_t node = Skeleton::kRoot;  ///< of the skeleton, where it grows; kRoot: nothing was drawn before
  std::uint64_t id = 0;                 ///< its number in the figure, or derived from the name of its module
};

/// A place where a shape belongs: an organ named in the grammar.
struct Site {
  std::string name;
  Vec3 position{0};
  Vec3 heading{0, 1, 0}, left{-1, 0, 0}, up{0, 0, 1};
  Vec3 scale{1};
  int color = 0;
  std::int32_t node = Skeleton::kRoot;
  std::uint64_t id = 0;  ///< its number in the figure, or derived from the name of its module
  double stage = 1;      ///< of a flower: the parameter after the scale, if there is one
};

/// Everything that a word draws: branches with a colour per node, outlines, organs. A sphere `@O` is an organ
/// of that name, scaled to its diameter.
struct Figure {
  Skeleton skeleton;
  std::vector<std::int32_t> color;
  std::vector<Outline> outlines;
  std::vector<Site> sites;
};

/// Empty where all places of a figure lie within the range of single precision; else out_of_range().
Errors check_places(const Figure& figure);

Figure figure_of(const Grammar& grammar, const Word& word, Seed seed);

/// What the word after `steps` steps draws; `steps` may be fractional (between.h). The symbols named in
/// `organs` are sites even without `~` before them. With `named`, random values stay while a module lives.
Result<Figure> figure_of(const Grammar& grammar, double steps, Seed seed, const Limits& limits = {},
                         std::span<const std::string> organs = {}, bool named = false);

/// The branches alone: a root where the turtle starts to draw and a node at the end of each segment, in the
/// order of the word; the order of a node is its depth of brackets. Segments without length are skipped.
Result<Skeleton> skeleton_of(const Grammar& grammar, const Word& word, Seed seed);

}  // namespace frond
