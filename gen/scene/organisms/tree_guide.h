#pragma once

#include "crown/axes.h"
#include "organisms/describe_grammar.h"

namespace frond {

/// A guide of a tree: places that its stem is led through, and where it forks.
struct TreeGuide : GuideText {};

template <class Visitor>
void describe(Visitor& v, TreeGuide& g) {
  v.custom("points", g.points, read_guide_line, kGuideLineSchema,
           "A line of points [x, y, z] in metres from the foot, y up; {at, in, out} has handles of a Bézier "
           "curve, and one that forks is {at, children}, children being lines of points that start there");
  describe_line(v, g);
}

/// Its axes; none of an empty guide. An error where points carry more than places.
Result<GuideAxes> axes_of_guide(const TreeGuide& guide);

/// What is wrong with it, below `/guide`.
Errors check_guide(const TreeGuide& guide);

}  // namespace frond
