#pragma once

#include <cstdint>
#include <vector>

#include "core/vec.h"

namespace frond {

/// Who is near: nodes of strands in cells of the size of their spacing, so that looking round costs the same
/// however many there are.
class Crowd {
 public:
  struct Member {
    Vec3 place, normal;
    std::int32_t strand;
    float since;  ///< metres along its strand
    std::int32_t next = -1;
  };

  /// Who does not count for the one that looks: the last metres of its own strand, and, while it is young,
  /// the strand that it leaves.
  struct Own {
    std::int32_t strand = -1, parent = -1;
    double since = 0;  ///< metres along the own strand
  };

  struct View {
    double nearest;  ///< metres to the next neighbour; `spacing` where there is none
    DVec3 away{0};   ///< from the neighbours, the nearer the more
  };

  explicit Crowd(double spacing);
  void add(const Member& member);
  View look(const DVec3& place, const DVec3& normal, const Own& own) const;
  double spacing() const { return spacing_; }

 private:
  struct Cell {
    std::int32_t x = 0, y = 0, z = 0, first = -1;
  };
  std::size_t slot(std::int32_t x, std::int32_t y, std::int32_t z) const;
  void grow();

  double spacing_;
  std::vector<Cell> cells_;  // hashed, open addressing
  std::size_t used_ = 0;
  std::vector<Member> members_;
};

}  // namespace frond
