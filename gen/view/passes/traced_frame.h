#pragma once

#include "draw/draw_list.h"
#include "passes/branch_tubes.h"
#include "passes/mesh_group.h"
#include "passes/traced_film.h"

namespace frond {

/// Something in a place: meshes or branches. Embree's number of its instance is its index.
struct Placed {
  Thing thing;
  std::shared_ptr<const MeshGroup> meshes;
  std::shared_ptr<const BranchTubes> branches = nullptr;
  glm::mat3 axes{1};
  Vec3 at{0};
  bool changes = false;  ///< its meshes are others at another time, with the same triangles

  RTCScene scene() const { return meshes ? meshes->scene() : branches->scene(); }
};
/// A mesh in a place.
Placed placed(Thing thing, std::shared_ptr<const MeshGroup> meshes, const OrganPlace& place,
              bool changes = false);

/// A specimen as it is drawn at a time.
struct DrawnSpecimen {
  std::shared_ptr<const Specimen> now;
  std::unique_ptr<DrawList> list;
};

/// Things in their places, as one scene.
struct PlacedScene {
  PlacedScene() = default;
  explicit PlacedScene(std::vector<Placed> placed);

  std::vector<Placed> things;  // by Thing
  ScenePointer scene;

  /// Null where it is not here.
  const Placed* find(const Thing& thing) const;
};

struct TracedFrame::Parts {
  std::vector<DrawnSpecimen> drawn;  // what `moving` refers to
  PlacedScene moving;
  const PlacedScene* still = nullptr;  // of the film
  Vec3 light{0};                       // toward the main light, or its place
  bool is_lamp = false;

  /// Whether a ray meets nothing.
  bool open(RTCRay ray) const;
};

}  // namespace frond
