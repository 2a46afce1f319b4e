#pragma once

#include <variant>
#include <vector>

#include "core/seed.h"
#include "crown/silhouette.h"
#include "model/surface.h"

namespace frond {

/// An ellipsoid, by its half-axes, metres.
struct EllipsoidCrown {
  Vec3 middle{0, 4, 0}, half{2};
};
/// An upright cone or frustum.
struct ConeCrown {
  Vec3 foot{0, 1, 0};
  double height = 4, low = 2, high = 0;  ///< metres; radii at the foot and at the top
};
/// The inside of a closed mesh, by the number of crossings of an upward ray.
struct MeshCrown {
  Surface surface;
};
/// A silhouette with its lowest point at `foot`, `height` metres high; either turned about the vertical
/// through its middle (using its right half) or given a thickness from front to back.
struct SilhouetteCrown {
  Silhouette outline;
  Vec3 foot{0, 1, 0};
  double height = 4;
  double depth = 0;  ///< metres; 0: turned about the vertical
};

using EnvelopeShape = std::variant<EllipsoidCrown, ConeCrown, MeshCrown, SilhouetteCrown>;

/// A volume that branches fill, prepared for queries.
class Envelope {
 public:
  explicit Envelope(EnvelopeShape shape);

  bool inside(Vec3 at) const;
  Vec3 low() const { return low_; }
  Vec3 high() const { return high_; }

  /// Up to `count` uniformly random points inside; fewer where the volume is a tiny part of its box.
  std::vector<Vec3> sample(int count, Seed seed) const;

 private:
  bool inside_mesh(const MeshCrown& mesh, Vec3 at) const;

  EnvelopeShape shape_;
  Vec3 low_{0}, high_{0};
  int columns_ = 1;                                // of the grid of triangles over x and z
  std::vector<std::vector<std::uint32_t>> cells_;  // triangles above each cell
};

}  // namespace frond
