#pragma once

#include <utility>
#include <vector>

#include "draw/sweep.h"
#include "field/volume.h"
#include "geometry/tubes.h"
#include "motion/unfold.h"
#include "world/specimen.h"

// How the branches of an organism are drawn.

namespace frond {

enum class BranchForm {
  none,
  sweeps,  ///< chunks, see cut_chunks()
  coat,    ///< one mesh with a picture, and sweeps where they are too thin for that
  body     ///< fused, rough, or of cubes
};

/// The branches of an organism in a pose. Refers to what it is made from.
struct DrawnBranches {
  const Traits& traits;
  const Model& model;
  const Pose& pose;

  const BranchLook& look() const { return traits.look.branches; }
  const Skeleton& rest() const { return model.skeleton; }
  BranchForm form() const;

  /// How finely chunks are cut.
  ChunkOptions chunk_options() const;
  /// Whether a chunk is a limb thick enough to show a bark that lies along it, and not upright, where it does
  /// so anyway.
  bool slanted(const Chunk& chunk) const;
  /// Whether all branches have one and the same texture in the whole film, which then stands on their union.
  bool one_texture() const;

  /// Those of a tree that wears a bark as a picture, by their pictures; empty while none of it has grown.
  /// Where the eye is near, their furrows are let in. What is finer than a `pixel`, metres, is left out.
  std::vector<std::pair<const BarkCoat*, Surface>> coat_surfaces(Vec3 eye, double pixel) const;
  /// Which nodes they leave out: those of twigs too thin for a picture, and of branches that wear none.
  std::vector<bool> coatless(double pixel) const;

  /// How branches become tubes where a pixel is so many metres; 0: in all detail.
  TubeShape tube_shape(double pixel) const;

  /// Those that growth has reached, as a volume is made from them.
  BranchVolume boughs() const { return boughs_at(pose.position); }
  VolumeOptions volume() const {
    const Style& style = traits.style;
    return {style.voxel, style.adaptivity, style.limit, style.roughness};
  }
  /// All of them as one body, fused, rough or of cubes, and the node of each vertex. An error where the
  /// volume passes the limit of its style.
  Result<FusedMesh> body() const;

 private:
  BranchVolume boughs_at(const std::vector<Vec3>& position) const;
  /// Where the nodes would be if nothing but growth moved them.
  std::vector<Vec3> unmoved() const;
};

/// The colours of branches, for whoever draws them plainly. Refers to them.
class BranchColors {
 public:
  explicit BranchColors(const DrawnBranches& branches);

  /// At node `i`, in the turtle's colour of the branch that goes to node `of`.
  Color at(std::int32_t i, std::int32_t of) const;

 private:
  const DrawnBranches& branches_;
  std::vector<Color> old_, young_;
  float young_length_, longest_;  // metres
};

}  // namespace frond
