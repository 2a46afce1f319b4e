#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/bounds.h"
#include "core/detour.h"
#include "creeping/triangle_surface.h"

namespace frond {

/// Bodies as what limbs bend round, see core/detour.h. Metres; thread-safe.
class Obstacles {
 public:
  Obstacles() = default;  ///< none
  /// Bodies none of whose triangles has an area are no obstacles. An error where Embree can build no tree.
  static Result<Obstacles> build(std::span<const Surface> bodies);

  /// Whether a box comes near to that of a body.
  bool near(const Bounds& box) const;

  /// A Detour. What begins inside a closed body is let out.
  std::optional<Vec3> way(Vec3 from, Vec3 to, float clearance) const;

 private:
  std::shared_ptr<const TriangleSurface> host_;  // of all of them
  std::vector<Bounds> boxes_;                    // of each
};

}  // namespace frond
