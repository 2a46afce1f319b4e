#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.h"

namespace frond {

/// The nodes of all strands in a grid of cells, so that a search for neighbours takes the same time however
/// many nodes there are.
class SpatialHash {
 public:
  struct Member {
    Vec3 place, normal;
    std::int32_t strand = -1;
    float since = 0;  ///< metres along its strand
  };

  /// The nodes that a search ignores: the last metres of the searching strand itself and, while it is young,
  /// the strand that it branches off.
  struct Own {
    std::int32_t strand = -1, parent = -1;
    double since = 0;  ///< metres along the own strand
  };

  struct View {
    double nearest;  ///< metres to the nearest neighbour; the spacing where none is within it
    DVec3 away{0};   ///< direction away from the neighbours, weighted by nearness
  };

  /// `spacing`: metres that strands keep apart, > 0.
  explicit SpatialHash(double spacing);
  void add(const Member& member);

  /// Sets `near` to the nodes within `reach` metres of a point, without those on the other side of a wall.
  void gather(const DVec3& place, const DVec3& normal, const Own& own, double reach,
              std::vector<DVec3>& near) const;

  /// The neighbours as seen from a point, given the nodes that gather() found.
  View view(std::span<const DVec3> near, const DVec3& place) const;

  /// Metres from a point to the nearest of the nodes that gather() found; at most the spacing.
  double nearest(std::span<const DVec3> near, const DVec3& place) const;

  double spacing() const { return spacing_; }

 private:
  /// 4 x 4 x 4 cells, stored together because a search reads cells beside each other.
  struct Block {
    std::int32_t x = 0, y = 0, z = 0, cells = -1;  // position of its first cell
    std::uint64_t taken = 0;                       // the cells that are not empty, one bit each
  };
  /// Positions stored apart from the rest, so that most are rejected quickly, several at once.
  struct alignas(64) Chunk {
    static constexpr std::int32_t kMost = 7;
    struct Rest {
      std::int32_t strand;
      float since;
      Vec3 normal;
    };
    std::array<std::array<float, 8>, 3> place{};  // x, y and z, infinitely far where unused
    std::int32_t count = 0, before = -1;
    std::array<Rest, kMost> rest{};
  };
  std::size_t slot(std::int32_t x, std::int32_t y, std::int32_t z) const;
  void grow();

  double spacing_, size_;            // of a cell
  std::vector<Block> blocks_;        // hashed, open addressing
  std::vector<std::int32_t> cells_;  // the last chunk of each, or -1
  std::size_t used_ = 0;
  std::vector<Chunk> chunks_;
};

}  // namespace frond
