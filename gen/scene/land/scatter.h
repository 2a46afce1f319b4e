#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/seed.h"
#include "core/vec.h"

namespace frond {

/// A position with the radius that it needs free.
struct Spot {
  Vec2 at{0};
  float radius = 0;
  std::uint32_t attempt = 0;  ///< of scatter(): which of its attempts found it
};

/// Occupied spots by position, in an adaptive quadtree, so that neither the size of the land nor of the spots
/// matters.
class TakenSpots {
 public:
  void add(const Spot& spot);
  /// Whether no spot is nearer to that place than the sum of the radii.
  bool free(Vec2 at, float radius) const { return square_.empty() || !touched(0, at, radius); }
  const std::vector<Spot>& list() const { return spot_; }

 private:
  struct Square {
    Vec2 low{0}, high{0};     // bounds of the positions in it
    float widest = 0;         // largest radius
    std::int32_t child = -1;  // first of its four children, or -1: its spots are a list
    std::int32_t first = -1;  // first spot of that list
    int count = 0;            // spots put into that list so far; widen() reads it after quarter(), too

    /// Before the spot is put into it.
    void widen(const Spot& spot) {
      low = count == 0 ? spot.at : glm::min(low, spot.at);
      high = count == 0 ? spot.at : glm::max(high, spot.at);
      widest = std::max(widest, spot.radius);
    }
  };
  void put(std::size_t square, std::int32_t spot);
  void quarter(std::size_t square, Vec2 middle);
  bool touched(std::size_t square, Vec2 at, float radius) const;

  std::vector<Spot> spot_;
  std::vector<std::int32_t> next_;  // next spot in the list of its square
  std::vector<Square> square_;
};

/// Up to `count` positions in the ring of `inner` to `outer` metres about `centre`, none nearer to another or
/// to an occupied one than the sum of their radii (Poisson disk by dart throwing); they are then added to the
/// occupied ones. Fewer if there is no room: stops after 1000 failed attempts in a row.
std::vector<Spot> scatter(Vec2 centre, double inner, double outer, float radius, int count, TakenSpots& taken,
                          Seed seed);

}  // namespace frond
