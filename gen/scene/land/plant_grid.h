#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/vec.h"

namespace frond {

/// Plants of one layer, indexed by position: a grid for each octave of crown radii, so that every search is
/// short.
class PlantGrid {
 public:
  struct Plant {
    Vec2 at{0};
    float radius = 0, stem = 0;  ///< metres
    std::int32_t next = -1;      ///< in its cell
  };

  /// About the origin; plants beyond `size` metres may be added, too.
  explicit PlantGrid(double size) : size_(size) {}

  void add(Vec2 at, double radius, double stem) {
    Octave& octave = octave_of(radius);
    octave.widest = std::max(octave.widest, radius);
    octave.stoutest = std::max(octave.stoutest, stem);
    std::int32_t& first = octave.first[cell(octave, row(octave, at.x), row(octave, at.y))];
    plants_.push_back({at, static_cast<float>(radius), static_cast<float>(stem), first});
    first = static_cast<std::int32_t>(plants_.size()) - 1;
  }

  /// Whether a crown, or a stem, of that radius there would touch an existing one.
  bool crown_touches(Vec2 at, double radius) const {
    return any(
        at, [&](const Octave& octave) { return radius + octave.widest; },
        [&](const Plant& p) { return glm::distance(at, p.at) < radius + p.radius; });
  }
  bool stem_touches(Vec2 at, double stem) const {
    return any(
        at, [&](const Octave& octave) { return stem + octave.stoutest; },
        [&](const Plant& p) { return glm::distance(at, p.at) < stem + p.stem; });
  }

  /// Calls `visit(plant)` for at least all plants whose crown is not farther than `times` its radius.
  template <class Visit>
  void each_within(Vec2 at, double times, const Visit& visit) const {
    any(
        at, [&](const Octave& octave) { return times * octave.widest; },
        [&](const Plant& p) { return visit(p), false; });
  }

 private:
  struct Octave {
    double cell = 0;                       // metres
    int rows = 0;                          // also number of columns
    double widest = 0, stoutest = 0;       // largest radius and stem of its plants
    std::vector<std::int32_t> first = {};  // plant of each cell, -1: none
  };
  static constexpr int kLowest = -8, kOctaves = 16, kMostRows = 1024;

  Octave& octave_of(double radius) {
    int power = std::clamp(std::ilogb(std::max(radius, 1e-6)), kLowest, kLowest + kOctaves - 1);
    Octave& octave = octaves_[static_cast<std::size_t>(power - kLowest)];
    if (octave.rows == 0) {
      octave.cell = std::max(std::ldexp(1.0, power + 2), size_ / kMostRows);
      octave.rows = static_cast<int>(std::ceil(size_ / octave.cell)) + 1;
      octave.first.assign(static_cast<std::size_t>(octave.rows) * static_cast<std::size_t>(octave.rows), -1);
    }
    return octave;
  }

  /// Clamped to the outermost cells.
  int row(const Octave& octave, double at) const {
    return static_cast<int>(std::clamp((at + size_ / 2) / octave.cell, 0.0, octave.rows - 1.0));
  }
  static std::size_t cell(const Octave& octave, int column, int row) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(octave.rows) +
           static_cast<std::size_t>(column);
  }

  template <class Reach, class Test>
  bool any(Vec2 at, const Reach& reach, const Test& test) const {
    for (const Octave& octave : octaves_) {
      if (octave.rows == 0) continue;
      double away = reach(octave);
      int left = row(octave, at.x - away), right = row(octave, at.x + away);
      int top = row(octave, at.y - away), bottom = row(octave, at.y + away);
      for (int r = top; r <= bottom; ++r)
        for (int c = left; c <= right; ++c)
          for (std::int32_t k = octave.first[cell(octave, c, r)]; k >= 0;) {
            const Plant& plant = plants_[static_cast<std::size_t>(k)];
            if (test(plant)) return true;
            k = plant.next;
          }
    }
    return false;
  }

  double size_;
  std::array<Octave, kOctaves> octaves_;
  std::vector<Plant> plants_;
};

}  // namespace frond
