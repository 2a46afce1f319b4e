#pragma once

#include <optional>

#include "images/leaf_blade.h"

namespace frond {

/// Veins while they grow, with a grid that finds the nearest.
class VeinTree {
 public:
  explicit VeinTree(const Lamina& blade);

  std::uint32_t add(Vec2 at, std::int32_t parent, std::uint8_t order);
  void join(std::uint32_t a, std::uint32_t b) { veins_.joins.push_back({a, b}); }

  /// The nearest of the points before `end`, within `reach`.
  std::optional<std::uint32_t> nearest(Vec2 p, float reach, std::uint32_t end) const;

  /// Grows veins of an order toward sources that are `apart` from each other and `clear` of all veins.
  void colonize(double apart, double clear, std::uint8_t order, bool loops, Seed seed);

  const Veins& veins() const { return veins_; }
  /// The veins, with widths by the pipe model; that of the first point is given.
  Veins take(double width);

 private:
  struct Source {
    Vec2 at{0};
    float ways = 1e9f;  ///< sum of the ways to it, when that was least
    int count = 0;      ///< of the veins that it attracted then
    int waited = 0;     ///< steps since then
  };
  /// The veins that a source attracts.
  struct Attracted {
    std::array<std::uint32_t, 6> node;
    std::array<float, 6> distance;
    int count = 0;
  };

  std::size_t cell_of(Vec2 p) const;
  template <class Visit>
  void each_in_ring(Vec2 p, int ring, Visit visit) const;
  std::vector<Source> scatter(double apart, double clear, Seed seed) const;
  Attracted attracted(Vec2 source, bool loops) const;
  void arrive(Vec2 source, const Attracted& veins, float kill, std::uint8_t order);
  bool grow_step(float step, std::uint8_t order, Seed seed);

  const Lamina& blade_;
  Veins veins_;
  Vec2 corner_{0};
  float cell_;  // side of one of the grid
  int columns_ = 1, rows_ = 1;
  std::vector<std::int32_t> first_, next_;  // points of each cell, as lists
  std::vector<Vec2> pull_;                  // of each point, by the sources of a step
  std::vector<std::uint32_t> pulled_;       // points with a pull
};

}  // namespace frond
