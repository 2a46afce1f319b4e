#pragma once

#include <variant>
#include <vector>

#include "core/seed.h"
#include "crown/silhouette.h"
#include "model/surface.h"

namespace frond {

/// A ball pressed to half-axes, metres.
struct EllipsoidCrown {
  Vec3 middle{0, 4, 0}, half{2};
};
/// A cone or a frustum that stands upright.
struct ConeCrown {
  Vec3 foot{0, 1, 0};
  double height = 4, low = 2, high = 0;  ///< metres; radius at the foot and at the top
};
/// The inside of a closed mesh, by how often a ray upward crosses it.
struct MeshCrown {
  Surface surface;
};
/// A silhouette, put up with its lowest point at `foot`, `height` metres high; turned about the vertical
/// through its middle (its right half counts), or with a thickness from front to back.
struct SilhouetteCrown {
  Silhouette outline;
  Vec3 foot{0, 1, 0};
  double height = 4;
  double depth = 0;  ///< metres; 0: turned
};

using EnvelopeShape = std::variant<EllipsoidCrown, ConeCrown, MeshCrown, SilhouetteCrown>;

/// A room that branches fill, ready to be asked.
class Envelope {
 public:
  explicit Envelope(EnvelopeShape shape);

  bool inside(Vec3 at) const;
  Vec3 low() const { return low_; }
  Vec3 high() const { return high_; }

  /// Up to `count` places inside, evenly at random; fewer where the room is a tiny part of its box.
  std::vector<Vec3> sample(int count, Seed seed) const;

 private:
  bool inside_mesh(const MeshCrown& mesh, Vec3 at) const;

  EnvelopeShape shape_;
  Vec3 low_{0}, high_{0};
  int columns_ = 1;                                // of the grid of triangles over x and z
  std::vector<std::vector<std::uint32_t>> cells_;  // triangles above each cell
};

}  // namespace frond
