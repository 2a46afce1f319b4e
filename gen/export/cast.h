#pragma once

#include <string>
#include <vector>

#include "core/result.h"
#include "field/volume.h"
#include "model/surface.h"
#include "scene/scene.h"

namespace frond {

/// What a mesh is made of, as far as other programs know of such things.
struct CastMaterial {
  std::string name;  ///< letters, digits, - and _; no two alike
  Color color;       ///< sRGB
  double gloss = 0;  ///< 0 matt .. 1 polished
  bool metal = false;
  bool leaf = false;  ///< to be seen from both sides
};

struct CastMesh {
  std::string name;
  Surface surface;
  std::size_t material = 0;
};

/// A mesh put somewhere: scaled along its own axes, turned, moved.
struct CastPlacement {
  std::size_t mesh = 0;
  Vec3 at{0};
  Quat turn{1, 0, 0, 0};
  Vec3 scale{1};
};

/// Everything that grows or stands in a scene at one time, as meshes; our world's axes, metres.
struct Cast {
  std::vector<CastMaterial> materials;
  std::vector<CastMesh> meshes;
  std::vector<CastPlacement> placements;
};

struct CastOptions {
  int sides = 10;    ///< of the tubes that branches become
  double voxel = 0;  ///< metres, of a volume; 0: the least of the fused organisms, or 1/400 of all
};

/// How large a cast is or will be, placements counted as often as they occur in `all_`.
struct CastSize {
  double vertices = 0, triangles = 0;          ///< of all meshes, each once
  double all_vertices = 0, all_triangles = 0;  ///< of all placements
  double placements = 0;
};

CastSize size_of(const Cast& cast);

/// About how large the cast of a scene will be, by its fully grown organisms; what is sown not counted.
CastSize foresee_cast(const Scene& scene, const CastOptions& options);

/// Makes the meshes of a scene at a time, in seconds. Specimen are tubes, or what their style makes of them;
/// ground, stones and grass are left out. An error where nothing is left.
Result<Cast> cast_scene(const Scene& scene, double time, const CastOptions& options);

/// Branches that are built of cubes or have grown into one, as their style says; corners that belong to one
/// node each.
Result<FusedMesh> body_mesh(const Specimen& specimen, const Pose& pose);

/// All placements of a mesh as one surface where they stand.
Surface placed(const CastMesh& mesh, const CastPlacement& placement);

}  // namespace frond
