#include "images/caustics.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/loop.h"
#include "core/parallel.h"
#include "core/seed.h"
#include "core/vec.h"

namespace frond {

namespace {

constexpr int kWaves = 12;

struct WaveTrain {
  double x = 0, z = 0;  // radians a side of the square
  double power = 0, phase = 0;
};

std::array<WaveTrain, kWaves> waves_of(const Caustics& caustics) {
  std::array<WaveTrain, kWaves> waves;
  for (int i = 0; i < kWaves; ++i) {
    Seed seed = Seed{71}.child("wave", i);
    double length = 2.6 + 7.4 * i / (kWaves - 1);  // crests along a side
    double heading = 2 * kPi * (i * 0.381966 + 0.1 * seed.child("heading").unit());
    // Whole numbers of crests, so that the square fits on itself.
    double a = std::floor(length * std::cos(heading) + 0.5), b = std::floor(length * std::sin(heading) + 0.5);
    double crests = std::hypot(a, b);
    double speed = looping_rate(1.1 * std::sqrt(crests) / (2 * kPi), caustics.loop);  // turns a second
    WaveTrain& wave = waves[i];
    wave.x = 2 * kPi * a;
    wave.z = 2 * kPi * b;
    wave.power = caustics.focus * std::sqrt(3 / crests) / (4 * kPi * kPi * crests * crests);
    wave.phase = 2 * kPi * (seed.child("phase").unit() - speed * caustics.time);
  }
  return waves;
}

}  // namespace

Raster caustics_picture(const Caustics& caustics) {
  std::array<WaveTrain, kWaves> waves = waves_of(caustics);
  Raster picture(caustics.pixels, caustics.pixels, 1);
  parallel_for(static_cast<std::size_t>(caustics.pixels), [&](std::size_t row) {
    for (int column = 0; column < caustics.pixels; ++column) {
      double x = (column + 0.5) / caustics.pixels, z = 1 - (static_cast<double>(row) + 0.5) / caustics.pixels;
      double u = x, v = z;
      for (int step = 0; step < 3; ++step) {
        double along = x, across = z;
        for (const WaveTrain& w : waves) {
          double slope = w.power * std::sin(w.x * u + w.z * v + w.phase);
          along += w.x * slope;
          across += w.z * slope;
        }
        u = along, v = across;
      }
      double xx = 0, zz = 0, xz = 0;
      for (const WaveTrain& w : waves) {
        double bend = w.power * std::cos(w.x * u + w.z * v + w.phase);
        xx += w.x * w.x * bend;
        zz += w.z * w.z * bend;
        xz += w.x * w.z * bend;
      }
      double light = std::min(1.0, 0.125 / (std::abs((1 - xx) * (1 - zz) - xz * xz) + 0.13));
      picture.data[picture.index(column, static_cast<int>(row))] =
          static_cast<std::uint8_t>(255 * std::sqrt(light) + 0.5);
    }
  });
  return picture;
}

}  // namespace frond
