#pragma once

#include <array>
#include <vector>

#include "draw/branches.h"
#include "light/light.h"
#include "scene/scene.h"

// The polyps of corals: placements of one shape, of those that are large enough to be seen.

namespace frond {

/// A place of a triangle, by the shares that its corners have in it.
struct SurfacePoint {
  std::array<std::uint32_t, 3> corner;
  Vec3 share;

  template <class T>
  T of(const std::vector<T>& v) const {
    return share.x * v[corner[0]] + share.y * v[corner[1]] + share.z * v[corner[2]];
  }
};

/// Where polyps stand on each of an organism's solids, all its life.
using PolypPlaces = std::vector<std::vector<SurfacePoint>>;
PolypPlaces polyp_places(const Solids& solids);

/// The polyps of one skin at a time. Those that face away, or that are too small to be seen from `eye`, are
/// left out.
struct DrawnPolyps {
  const Polyps* polyps;
  Color color;  ///< sRGB, of the skin
  Eye eye;
  std::vector<glm::mat3> frames = {};  ///< turn and size of each, the shape being 1 wide along +y
  std::vector<Vec3> positions = {};    ///< metres

  /// The share `grown`, 0..1, of polyp number n.
  void add(std::size_t n, Vec3 at, Vec3 normal, double grown);
};

/// Those of living bodies, each on a place of its own, which the skin carries along as it grows.
std::vector<DrawnPolyps> drawn_polyps(const Solids& solids, const PolypPlaces& places, const Growth& growth,
                                      double time, const Eye& eye);

/// Those of branches with a skin: all round them by the golden angle, and one on each tip.
DrawnPolyps drawn_polyps(const DrawnBranches& branches, const Eye& eye);

}  // namespace frond
