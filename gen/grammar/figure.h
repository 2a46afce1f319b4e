#pragma once

#include "grammar/turtle.h"

namespace frond {

/// What a word draws, in numbers.
struct TurtleStats {
  std::size_t segments = 0, polygons = 0;
  double total_length = 0;
  DVec3 end_position{0}, end_heading{0, 1, 0}, end_left{-1, 0, 0}, end_up{0, 0, 1};
  std::vector<DVec3> end_positions;  ///< of all turtles, where a guide forked; the first is end_position
  DVec3 low{0}, high{0};             ///< box around all that is drawn; the start where nothing is
  int max_stack_depth = 0;
};

TurtleStats stats_of(const Grammar& grammar, const Word& word, Seed seed);

/// The same after so many steps; a number that is not whole gives the shape on its way from one step to the
/// next (between.h). The word is not stored where it need not be.
Result<TurtleStats> stats_of(const Grammar& grammar, double steps, Seed seed, const Limits& limits = {});

/// What is said where a turtle walks beyond what can be drawn.
Errors out_of_range();

/// A filled outline: a leaf, a petal.
struct Outline {
  std::vector<Vec3> points;
  int color = 0;
  std::int32_t node =
      Skeleton::kRoot;   ///< of the skeleton, where it grows; kRoot where nothing was drawn before
  std::uint64_t id = 0;  ///< its number in the figure, or by the name of its module
};

/// A place where a shape belongs: an organ named in the grammar.
struct Site {
  std::string name;
  Vec3 position{0};
  Vec3 heading{0, 1, 0}, left{-1, 0, 0}, up{0, 0, 1};
  Vec3 scale{1};
  int color = 0;
  std::int32_t node = Skeleton::kRoot;
  std::uint64_t id = 0;  ///< its number in the figure, or by the name of its module
};

/// All that a word draws: branches with a colour a node, outlines, organs. A sphere `@O` is an organ named
/// so, scaled to its diameter.
struct Figure {
  Skeleton skeleton;
  std::vector<std::int32_t> color;
  std::vector<Outline> outlines;
  std::vector<Site> sites;
};

/// Whether all of it lies where single precision can measure it; out_of_range() where not.
Errors check_places(const Figure& figure);

Figure figure_of(const Grammar& grammar, const Word& word, Seed seed);

/// The same after so many steps, which need not be whole. The symbols named in `organs` are sites also where
/// no `~` stands before them. With `named`, what is random stays the same as long as a module lives
/// (between.h).
Result<Figure> figure_of(const Grammar& grammar, double steps, Seed seed, const Limits& limits = {},
                         std::span<const std::string> organs = {}, bool named = false);

/// The branches alone. A root where the turtle starts to draw and a node at the end of each segment, in the
/// order of the word; the order of a node is the number of brackets around it. Segments without length are
/// left out.
Result<Skeleton> skeleton_of(const Grammar& grammar, const Word& word, Seed seed);

}  // namespace frond
