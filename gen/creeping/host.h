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

/// How high the ground lies at (x, z), metres; empty: there is none.
using GroundHeight = std::function<double(double, double)>;

/// The point of a host that is nearest to some place.
struct Contact {
  DVec3 point{0};
  /// Of length 1, outward, continuous where the place moves over edges: the direction from `point` to the
  /// place, and on the surface itself the normal of the face, the edge or the corner that `point` lies on.
  DVec3 normal{0, 1, 0};
  double distance = 0;  ///< metres, >= 0
  std::uint32_t triangle = 0;
  bool inside = false;  ///< the place lies behind the surface
};

/// Where a way first meets a host.
struct Crossing {
  double share = 0;       ///< 0..1 of the way
  DVec3 normal{0, 1, 0};  ///< of the triangle, of length 1, as the host has it: outward where it is closed
  std::uint32_t triangle = 0;
};

/// What strands creep over: any heap of triangles. Open meshes, flipped faces, vertices that occur twice,
/// triangles without area, corners that are no numbers: all are taken. Faces are turned to agree with their
/// neighbours (by edges that just two faces share), closed parts outward, open parts toward the side from
/// which more ways lead into the open, or, where there is no telling, as most of their area was.
///
/// Answers come from double arithmetic on the triangles; Embree (Wald et al. 2014) only finds which triangles
/// to look at, with room to spare, and among equals the triangle of the lowest index counts. So they do not
/// depend on the instruction set or the number of threads that its tree was built with. May be asked from
/// many threads.
class Host {
 public:
  /// An error, which says `name`, where no triangle is left that has an area.
  static Result<Host> build(const Surface& surface, std::string_view name = "host");
  Host(Host&&) noexcept;
  Host& operator=(Host&&) noexcept;
  ~Host();

  /// The nearest point of the surface, or nothing where it is farther than `within` (metres). A triangle
  /// that is likely to be near, such as the one a step began on, makes the search faster and changes nothing
  /// else.
  std::optional<Contact> closest(const DVec3& place, double within = std::numeric_limits<double>::infinity(),
                                 std::uint32_t likely = kNoTriangle) const;
  static constexpr std::uint32_t kNoTriangle = ~0u;

  /// The first crossing on the way from one place to another, both ends included.
  std::optional<Crossing> crossing(const DVec3& from, const DVec3& to) const;

  /// Whether a place is within the closed parts of the host (which may overlap). Always false where no part
  /// is closed.
  bool inside(const DVec3& place) const;

  bool closed() const { return closed_; }  ///< every part of it is
  DVec3 low() const { return low_; }       ///< of its bounding box
  DVec3 high() const { return high_; }
  double size() const { return glm::distance(low_, high_); }  ///< the diagonal of that box

  /// The triangles that are left, corners counter-clockwise seen from outside.
  const std::vector<std::array<Vec3, 3>>& triangles() const { return corners_; }
  DVec3 face_normal(std::uint32_t triangle) const;

  /// Whether a side of a triangle is the back of an open part: the inner side of a scan, say.
  bool behind(std::uint32_t triangle, const DVec3& normal) const {
    return !solid_[triangle] && glm::dot(face_normal(triangle), normal) < -0.3;
  }

 private:
  struct Tree;
  Host();
  void take(Soup&& soup);
  double openness(std::uint32_t triangle, double side) const;
  DVec3 feature_normal(std::uint32_t triangle, int feature) const;

  std::vector<std::array<Vec3, 3>> corners_;
  std::vector<std::array<std::uint32_t, 3>> vertex_;     // the same corners, once a place
  std::vector<std::array<std::uint32_t, 3>> neighbour_;  // across the edges 01, 12, 20, or kNoTriangle
  std::vector<std::uint8_t> solid_;                      // part of a closed piece
  std::vector<Vec3> vertex_normal_;                      // weighted by angle, not of length 1
  DVec3 low_{0}, high_{0};
  bool closed_ = false;
  std::unique_ptr<Tree> tree_;
};

}  // namespace frond
