#pragma once

#include <array>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "core/vec.h"
#include "cpfg/curves.h"
#include "cpfg/view.h"
#include "model/surface.h"

// What the turtle draws with: surfaces, contours and colours from the files of a model.

namespace frond::cpfg {

/// A surface of a view at its own scale, in the axes that the turtle lays on itself: x along its left, y
/// along its heading, z along its up.
struct TurtleSurface {
  Surface mesh;
  DVec3 end{0};  ///< where the turtle goes on
};

/// How lines are drawn.
enum class LineStyle { pixel, polygon, cylinder };

/// What a model draws with.
struct Shapes {
  std::map<char, TurtleSurface> surfaces;
  std::map<int, CurveTable> contours;  ///< of generalized cylinders, by number
  std::vector<Color> colors;           ///< 256, or as many more as there are maps
  LineStyle lines = LineStyle::pixel;
  bool tapered = true;             ///< lines end with the width that is set after them
  bool twisted = false;            ///< cylinders follow the turtle where it rolls
  int sides = 8;                   ///< of cylinders
  std::vector<std::string> notes;  ///< surfaces that are not there
  std::optional<Error> missing;    ///< the first of its files that could not be read: it cannot be drawn then
};

Shapes read_shapes(ModelFolder& folder, const std::vector<CpfgViewLine>& view,
                   const std::vector<std::filesystem::path>& colors);

/// A `.s` file: bicubic Bézier patches, `scale` times as large as the file's SIZE says. `pieces`: how many
/// each patch has down its rows and along them; 0: as the file says.
Result<TurtleSurface> read_patches(std::string_view text, double scale, std::array<int, 2> pieces = {});

/// A file of triangles: `triangle`, and three lines of x y z.
Result<TurtleSurface> read_triangles(std::string_view text, double scale);

}  // namespace frond::cpfg
