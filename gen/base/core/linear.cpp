#include "core/linear.h"

#include <cmath>

namespace frond {

double linear(double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); }

double encoded(double c) { return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055; }

Vec3 linear(const Color& color) { return {linear(color.red), linear(color.green), linear(color.blue)}; }

Color srgb(Vec3 light) {
  return {static_cast<float>(encoded(light.x)), static_cast<float>(encoded(light.y)),
          static_cast<float>(encoded(light.z))};
}

}  // namespace frond
