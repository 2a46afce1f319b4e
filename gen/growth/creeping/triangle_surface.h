#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "model/surface.h"

namespace frond {

struct Soup;

/// Height of the ground at (x, z), metres; empty: there is no ground.
using GroundHeight = std::function<double(double, double)>;

/// The point of a host nearest to a given place.
struct Contact {
  DVec3 point{0};
  /// A vector of length 1, outward, continuous as the place moves over edges: the direction from `point` to
  /// the place, or on the surface itself the normal of the face, edge or corner that `point` lies on.
  DVec3 normal{0, 1, 0};
  double distance = 0;  ///< metres, >= 0
  std::uint32_t triangle = 0;
  bool inside = false;  ///< the place is behind the surface
};

/// Where a segment first meets a host.
struct Crossing {
  double share = 0;       ///< position along the segment, 0..1
  DVec3 normal{0, 1, 0};  ///< of the triangle, of length 1; outward where the host is closed
  std::uint32_t triangle = 0;
};

/// What strands creep over: any set of triangles. Open meshes, flipped faces, duplicate vertices, triangles
/// without area and NaN corners are all accepted. Faces are turned to agree with their neighbours (across
/// edges that exactly two faces share): closed parts outward, open parts toward the side from which more rays
/// reach the open, or, in case of a tie, as most of their area was.
///
/// Answers are computed in double precision on the triangles; Embree (Wald et al. 2014) only finds candidate
/// triangles, with a margin, and among equals the lowest index wins. So answers do not depend on the
/// instruction set or the number of threads. Thread-safe.
class TriangleSurface {
 public:
  /// An error, which names `name`, where no triangle with an area is left.
  static Result<TriangleSurface> build(const Surface& surface, std::string_view name = "host");
  TriangleSurface(TriangleSurface&&) noexcept;
  TriangleSurface& operator=(TriangleSurface&&) noexcept;
  ~TriangleSurface();

  /// The nearest point of the surface, or nothing where it is farther than `within` metres. `likely`, a
  /// triangle that is probably near, such as the one of the last step, only makes the search faster.
  std::optional<Contact> closest(const DVec3& place, double within = std::numeric_limits<double>::infinity(),
                                 std::uint32_t likely = kNoTriangle) const;
  static constexpr std::uint32_t kNoTriangle = ~0u;

  /// The first crossing on the segment between two points, ends included.
  std::optional<Crossing> crossing(const DVec3& from, const DVec3& to) const;

  /// Whether a point is inside closed parts of the host (which may overlap). False where no part is closed.
  bool inside(const DVec3& place) const;

  bool closed() const { return closed_; }  ///< every part is closed
  DVec3 low() const { return low_; }       ///< of its bounding box
  DVec3 high() const { return high_; }
  double size() const { return glm::distance(low_, high_); }  ///< the diagonal of that box

  /// The remaining triangles, corners counter-clockwise seen from outside.
  const std::vector<std::array<Vec3, 3>>& triangles() const { return corners_; }
  DVec3 face_normal(std::uint32_t triangle) const;

  /// The paint of the surface (model/surface.h) at a point of a triangle, between that of its corners.
  Vec3 paint(std::uint32_t triangle, const DVec3& point) const;
  /// Whether some corner has texture coordinates, or a grey.
  bool has_texture() const { return has_paint(0); }
  bool has_grey() const { return has_paint(2); }

  /// Whether a side of a triangle is the back of an open part, such as the inner side of a scan.
  bool behind(std::uint32_t triangle, const DVec3& normal) const {
    return !solid_[triangle] && glm::dot(face_normal(triangle), normal) < -0.3;
  }

 private:
  struct Tree;
  TriangleSurface();
  void adopt(Soup&& soup);
  bool has_paint(int channel) const;
  double openness(std::uint32_t triangle, double side) const;
  DVec3 feature_normal(std::uint32_t triangle, int feature) const;

  std::vector<std::array<Vec3, 3>> corners_;
  std::vector<std::array<std::uint32_t, 3>> vertex_;  // the same corners as indices, one index per position
  std::vector<std::array<std::uint32_t, 3>> neighbour_;  // across the edges 01, 12, 20, or kNoTriangle
  std::vector<std::uint8_t> solid_;                      // part of a closed piece
  std::vector<Vec3> vertex_normal_;                      // weighted by angle, not of length 1
  std::vector<std::array<Vec3, 3>> paint_;               // of each triangle's corners; may be empty
  DVec3 low_{0}, high_{0};
  bool closed_ = false;
  std::unique_ptr<Tree> tree_;
};

}  // namespace frond
