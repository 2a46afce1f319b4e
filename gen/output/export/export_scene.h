#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "bake/bake.h"
#include "core/result.h"
#include "field/volume.h"
#include "model/surface.h"
#include "scene/scene.h"

namespace frond {

inline constexpr std::size_t kNoPicture = SIZE_MAX;

/// A picture that materials show.
struct ExportPicture {
  std::string name;  ///< as that of a material
  std::string png;   ///< the bytes of its file
};

/// What a mesh is made of, as far as other programs know of such things.
struct ExportMaterial {
  std::string name;  ///< letters, digits, - and _; no two alike
  Color color;       ///< sRGB; with a picture, about what that shows on average
  Color factor;      ///< sRGB, that a picture's colours are multiplied by
  double gloss = 0;  ///< 0 matt .. 1 polished
  bool metal = false;
  bool leaf = false;        ///< to be seen from both sides
  bool cutout = false;      ///< what its picture leaves open is not there
  double transmission = 0;  ///< share of the light that goes through, 0..1
  /// Pictures: the colour, with opacity where it is cut out; the normals; the roughness as green.
  std::size_t colors = kNoPicture, normals = kNoPicture, roughness = kNoPicture;
};

/// A linear factor of the colour at one vertex, 255 being 1.
using ExportTint = std::array<std::uint8_t, 4>;

/// How far the position and the normal of each vertex differ in another shape of a surface.
struct ExportShift {
  std::vector<Vec3> position, normal;
};

/// A part of a mesh, of one material.
struct ExportPart {
  Surface surface;
  std::size_t material = 0;
  std::vector<ExportTint> tint = {};     ///< of each vertex, or empty
  std::vector<ExportShift> shifts = {};  ///< for each of the scene's keys but the last; none: it stands still
};

struct ExportMesh {
  std::string name;  ///< as that of a material
  std::vector<ExportPart> parts;
  /// The parts in fewer triangles, level by level from 1 on; empty where nothing of the mesh is left or
  /// another mesh of the organism shows it.
  std::vector<std::vector<ExportPart>> coarser = {};

  bool has_level(std::size_t level) const {
    return level == 0 || (level <= coarser.size() && !coarser[level - 1].empty());
  }
  void set_level(std::size_t level, std::vector<ExportPart> level_parts) {
    if (coarser.size() < level) coarser.resize(level);
    coarser[level - 1] = std::move(level_parts);
  }
  bool moves() const { return !parts.empty() && !parts[0].shifts.empty(); }
};

/// A mesh put somewhere: scaled along its own axes, turned, moved.
struct ExportPlacement {
  std::size_t mesh = 0;
  Vec3 at{0};
  Quat turn{1, 0, 0, 0};
  Vec3 scale{1};
  std::size_t group = 0;  ///< what it belongs to
};

/// An organism or a body, or all that is sown of one kind.
struct ExportGroup {
  std::string name;  ///< as that of a material
  Vec3 foot{0};
  bool sown = false;  ///< each of its placements is one plant
};

/// Everything that grows or stands in a scene at one time, as meshes; our world's axes, metres. The groups'
/// placements follow each other.
struct ExportScene {
  std::vector<ExportPicture> pictures;
  std::vector<ExportMaterial> materials;
  std::vector<ExportMesh> meshes;
  std::vector<ExportGroup> groups;
  std::vector<ExportPlacement> placements;
  std::vector<double> keys;         ///< seconds from the first on: when its shapes are reached, if it moves
  std::vector<std::string> absent;  ///< names of organisms of which nothing has grown yet, each once
};

inline constexpr double kCoarser = 0.25;  ///< share of the triangles of a level that the next has

struct ExportOptions {
  int sides = 10;          ///< of the tubes that branches without a picture become
  double voxel = 0;        ///< metres, of a volume; 0: the least of the fused organisms, or 1/400 of all
  double detail = 2.5e5;   ///< triangles of one organism or model, about: what is finer is drawn more simply
  int texture = 512;       ///< pixels, the width of a picture
  bool instances = false;  ///< each organ and body once, and its placements; otherwise all in one mesh
  double pixels = 0;       ///< where not 0, how high an organism is seen: what would be finer is left out
  int levels = 1;          ///< of detail: each mesh also in kCoarser of its triangles, and so on; not with
                           ///< keys or instances
  std::vector<double> keys = {};  ///< seconds, rising: the times whose shapes are wanted
  BakeOptions bake = {};          ///< how materials become pictures
  bool tints = true;              ///< young skin is paler, by colours at the vertices
};

/// The `detail` with which copies in forests are drawn where they are seen so many pixels high.
double detail_seen(double pixels);

/// How large an exported scene is or will be, placements counted as often as they occur in `all_`.
struct ExportSize {
  double vertices = 0, triangles = 0;          ///< of all meshes, each once
  double all_vertices = 0, all_triangles = 0;  ///< of all placements
  double placements = 0;
  double shifts = 0;    ///< of vertices, of all keys
  double pictures = 0;  ///< bytes
};

ExportSize size_of(const ExportScene& exported);

/// Triangles of all placements at each level of detail. Where a mesh has no such level it counts as nothing.
std::vector<double> level_triangles(const ExportScene& exported);

/// About how large what is exported of a scene will be, by its fully grown organisms; what is sown not
/// counted.
ExportSize estimate_export(const Scene& scene, const ExportOptions& options);

/// Makes the meshes of a scene at a time, in seconds. Specimen are tubes, or what their style makes of them;
/// ground, stones and grass are left out. An error where nothing will ever be left; where nothing has grown
/// yet there are no placements. With keys, the last of
/// which is that time, vertices are also carried to where they are at the others: an error where
/// something changes otherwise than by growing and swaying, or nothing moves.
Result<ExportScene> export_scene(const Scene& scene, double time, const ExportOptions& options);

/// All placements of a part as one surface where they stand.
Surface placed(const ExportPart& part, const ExportPlacement& placement);

}  // namespace frond
