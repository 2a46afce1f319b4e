#include "images/tiling_noise.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/vec.h"

namespace frond {

namespace {

int wrap(int i, int period) { return ((i % period) + period) % period; }

Seed corner(Seed seed, int x, int y, int across, int along) {
  return seed.child(static_cast<std::uint64_t>(wrap(y, along)) * static_cast<std::uint64_t>(across) +
                    static_cast<std::uint64_t>(wrap(x, across)));
}

double slope(Seed seed, double dx, double dy) {
  // Sixteen directions, evenly round.
  static const auto kDirections = [] {
    std::array<std::array<double, 2>, 16> list{};
    for (std::size_t i = 0; i < 16; ++i)
      list[i] = {std::cos(kPi / 8 * static_cast<double>(i)), std::sin(kPi / 8 * static_cast<double>(i))};
    return list;
  }();
  const auto& d = kDirections[seed.bits() & 15];
  return d[0] * dx + d[1] * dy;
}

double fade(double t) { return t * t * t * (t * (t * 6 - 15) + 10); }

}  // namespace

double tiling_noise(double x, double y, int across, int along, Seed seed) {
  double floor_x = std::floor(x), floor_y = std::floor(y), dx = x - floor_x, dy = y - floor_y;
  int i = static_cast<int>(floor_x), j = static_cast<int>(floor_y);
  auto at = [&](int a, int b) { return slope(corner(seed, i + a, j + b, across, along), dx - a, dy - b); };
  double u = fade(dx), v = fade(dy);
  double low = at(0, 0) + u * (at(1, 0) - at(0, 0)), high = at(0, 1) + u * (at(1, 1) - at(0, 1));
  return (low + v * (high - low)) * 1.4;
}

double tiling_fractal(double x, double y, int across, int along, int octaves, double gain, Seed seed) {
  double sum = 0, strength = 1, whole = 0;
  for (int i = 0; i < octaves; ++i) {
    sum += strength * tiling_noise(x, y, across, along, seed.child(i));
    whole += strength;
    strength *= gain;
    x *= 2, y *= 2, across *= 2, along *= 2;
  }
  return sum / whole;
}

Cells tiling_cells(double x, double y, int across, int along, Seed seed) {
  int i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
  Cells found{9, 9, 0};
  for (int b = -1; b <= 1; ++b) {
    for (int a = -1; a <= 1; ++a) {
      Seed own = corner(seed, i + a, j + b, across, along);
      double d = std::hypot(i + a + own.child(0).unit() - x, j + b + own.child(1).unit() - y);
      if (d < found.nearest)
        found = {d, found.nearest, own.child(2).unit()};
      else
        found.second = std::min(found.second, d);
    }
  }
  return found;
}

}  // namespace frond
