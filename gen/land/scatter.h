#pragma once

#include <cstdint>
#include <vector>

#include "core/seed.h"
#include "core/vec.h"

namespace frond {

/// A place with the room that it needs round it.
struct Spot {
  Vec2 at{0};
  float radius = 0;
};

/// Spots that are taken, found by place: a tree of squares that are quartered where many stand, so that it
/// makes no difference how large the land or the spots are.
class TakenSpots {
 public:
  void take(const Spot& spot);
  /// Whether none is nearer to that place than its radius and this one together.
  bool free(Vec2 at, float radius) const { return square_.empty() || !touched(0, at, radius); }
  const std::vector<Spot>& list() const { return spot_; }

 private:
  struct Square {
    Vec2 low{0}, high{0};     // of the places in it
    float widest = 0;         // radius
    std::int32_t child = -1;  // the first of four, or -1: its spots are a list
    std::int32_t first = -1;  // of that list
    int count = 0;            // in that list
  };
  void put(std::size_t square, std::int32_t spot);
  void quarter(std::size_t square, Vec2 middle);
  bool touched(std::size_t square, Vec2 at, float radius) const;

  std::vector<Spot> spot_;
  std::vector<std::int32_t> next_;  // in the list of its square
  std::vector<Square> square_;
};

/// Up to `count` places in the ring of `inner` to `outer` metres about `centre`, none nearer to another, or
/// to one that is taken, than the sum of their radii (Poisson disk by throwing darts); then they are taken,
/// too. Where the room runs out there are fewer: after 1000 in a row that found none it is given up.
std::vector<Spot> scatter(Vec2 centre, double inner, double outer, float radius, int count, TakenSpots& taken,
                          Seed seed);

}  // namespace frond
