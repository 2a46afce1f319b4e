#include "core/linear.h"

#include <cmath>

namespace frond {

double linear(double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); }

Vec3 linear(const Color& color) { return {linear(color.red), linear(color.green), linear(color.blue)}; }

}  // namespace frond
