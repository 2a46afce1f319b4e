#pragma once

#include "cpfg/cpfg.h"
#include "grammar/picture.h"

namespace frond {

/// What the turtle of a model of cpfg draws, for a picture by svg_of(). Surfaces are their triangles.
TurtleDrawing drawing_of(const CpfgFigure& figure);

/// How many lines, polygons and balls that drawing has.
std::size_t pieces_of(const CpfgFigure& figure);

}  // namespace frond
