#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.h"

namespace frond {

/// Who is near: the nodes of all strands in cells, so that looking round costs the same however many there
/// are.
class Crowd {
 public:
  struct Member {
    Vec3 place, normal;
    std::int32_t strand = -1;
    float since = 0;  ///< metres along its strand
  };

  /// Who does not count for the one that looks: the last metres of its own strand, and, while it is young,
  /// the strand that it leaves.
  struct Own {
    std::int32_t strand = -1, parent = -1;
    double since = 0;  ///< metres along the own strand
  };

  struct View {
    double nearest;  ///< metres to the next neighbour; the spacing where none is within it
    DVec3 away{0};   ///< from the neighbours, the nearer the more
  };

  /// `spacing` is what strands keep apart, metres, > 0.
  explicit Crowd(double spacing);
  void add(const Member& member);

  /// Sets `near` to the places within `reach` (metres) of a place, without those on the other side of a wall.
  void gather(const DVec3& place, const DVec3& normal, const Own& own, double reach,
              std::vector<DVec3>& near) const;

  /// What of such places is seen from one among them.
  View view(std::span<const DVec3> near, const DVec3& place) const;

  /// The same, but only how near the next one is.
  double nearest(std::span<const DVec3> near, const DVec3& place) const;

  double spacing() const { return spacing_; }

 private:
  /// 4 x 4 x 4 cells: who looks round finds those beside one another in one place.
  struct Block {
    std::int32_t x = 0, y = 0, z = 0, cells = -1;  // where they begin
    std::uint64_t taken = 0;                       // the cells in which somebody is, a bit each
  };
  /// Places apart from the rest, so that most are refused by a few lines of memory and several at once.
  struct alignas(64) Chunk {
    static constexpr std::int32_t kMost = 7;
    struct Rest {
      std::int32_t strand;
      float since;
      Vec3 normal;
    };
    std::array<std::array<float, 8>, 3> place{};  // x, y and z, endlessly far where nobody is
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
