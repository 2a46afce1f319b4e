#pragma once

#include <optional>

#include "draw/branches.h"
#include "passes/mesh_group.h"
#include "passes/traced_film.h"

namespace frond {

/// The branches of an organism in a pose, made to be traced: cones with round ends or, where they are fused,
/// rough or of cubes, their body.
class BranchTubes {
 public:
  /// Refers to the branches. An error as of DrawnBranches::body().
  static Result<BranchTubes> of(const DrawnBranches& branches);

  RTCScene scene() const { return scene_.get(); }

  /// The spot where a ray met primitive `face`; `u` is Embree's.
  SurfaceSpot spot(std::uint32_t face, float u, Vec3 at) const;
  Quat turn(std::uint32_t node) const { return branches_->pose.turn[node]; }
  std::optional<PlaceNormal> where(const SurfaceSpot& spot) const;

 private:
  explicit BranchTubes(const DrawnBranches& branches) : branches_(&branches) {}

  void add_cones();
  bool reached(std::uint32_t node) const;
  /// A place on the axis of the segment that ends at a node, with the radius there.
  glm::vec4 on_axis(std::uint32_t node, float along) const;

  const DrawnBranches* branches_;
  std::optional<FusedMesh> body_;
  std::vector<std::uint32_t> node_;  // at which each cone ends
  ScenePointer scene_;
};

}  // namespace frond
