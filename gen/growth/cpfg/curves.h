#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "core/vec.h"

namespace frond::cpfg {

// Control points have 32 bits a number, as in cpfg.

/// A function of a view: a clamped uniform cubic B-spline as y of x, for x from 0 to 1.
struct FunctionTable {
  std::vector<Vec3> points;
  std::vector<double> samples;  ///< at equal steps of x, between which it is linear; empty: none are taken

  double operator()(double x) const;
};

/// A curve of a view, measured along itself at equal steps of its parameter.
struct CurveTable {
  std::vector<Vec3> points;
  bool closed = false;
  std::vector<double> length;  ///< from the beginning to each step

  /// The point at a share 0..1 of the length: x, y, z.
  DVec3 operator()(double share) const;
};

/// A contour as its file holds it.
struct ContourFile {
  std::string name;
  std::vector<Vec3> points;  ///< repeated by their multiplicity
  bool closed = false;
};

/// Reads a `.func` file. `samples` of the view's line; a file that says them itself goes before.
Result<FunctionTable> read_function(std::string_view text, int samples);

struct NamedFunction {
  std::string name;
  FunctionTable function;
};
/// Reads a `.fset` file.
Result<std::vector<NamedFunction>> read_function_set(std::string_view text);

/// Reads a `.con` file of any form. Cylinders' contours of version 1.1 are closed unless they say `open`.
Result<ContourFile> read_contour(std::string_view text, bool of_cylinder = false);

/// A contour measured by so many points.
CurveTable measure(const ContourFile& contour, int samples);

}  // namespace frond::cpfg
