#pragma once

#include <filesystem>
#include <memory>
#include <span>

#include "core/result.h"
#include "field/blocks.h"
#include "model/surface.h"

namespace frond {

/// How a volume of branches is made.
struct VolumeOptions {
  double voxel = 0.01;      ///< metres, side of a voxel
  double adaptivity = 0.1;  ///< 0: triangles of a voxel's size everywhere .. 1: as few as curvature allows
  double limit = 4e9;       ///< bytes of memory; estimates above it are refused
  double roughness = 0;     ///< of roughen(): 0 the plain mesh of the volume .. 1 the steps of its voxels
};

/// Estimated size of a volume with its mesh.
struct VolumeForecast {
  double blocks = 0;  ///< number of blocks of 512 voxels that the surface crosses
  double bytes = 0;   ///< of memory, with the mesh
};

VolumeForecast estimate_volume(const BranchVolume& boughs, double voxel);

/// Empty, or why the volume is refused: it exceeds the limit (with the figure and a voxel size that would
/// fit), or its voxels are too small for its distance from the origin. Allocates nothing large.
Errors refuse_volume(const BranchVolume& boughs, const VolumeOptions& options);

/// A level set: distances from a surface in a narrow band of three voxels on both sides. Holds an OpenVDB
/// grid.
class Volume {
 public:
  struct Grid;
  explicit Volume(std::shared_ptr<const Grid> grid) : grid_(std::move(grid)) {}

  double voxel() const;
  std::uint64_t active_voxels() const;
  /// Memory of the tree, bytes.
  std::uint64_t bytes() const;
  /// The distance at a voxel, clamped to the band.
  float at(Cell cell) const;

  const Grid& grid() const { return *grid_; }

 private:
  std::shared_ptr<const Grid> grid_;
};

/// The boughs as a level set, voxels in world space. The same bytes at any number of threads.
Result<Volume> volume_of(const BranchVolume& boughs, const VolumeOptions& options);

/// A mesh of fused branches.
struct FusedMesh {
  Surface surface;  ///< closed; every edge between two triangles; normals of the body itself
  std::vector<std::int32_t>
      node;  ///< of each vertex: the node of the skeleton at the end of the nearest segment
};

/// The boughs as a mesh: a level set, its surface by dual contouring (Ju et al. 2002, as in OpenVDB's
/// VolumeToMesh), the vertices then moved onto the exact surface of the boughs.
Result<FusedMesh> fuse(const BranchVolume& boughs, const VolumeOptions& options);

/// Where the nodes of a skeleton are at rest and in a pose: what lies at x near node i at rest is then at
/// posed[i] + turn[i] * (x - rest[i]). Metres, one entry per node.
struct Carriage {
  std::span<const Vec3> rest, posed;
  std::span<const Quat> turn;
};

/// The boughs as a mesh that keeps the steps of the grid. The distances of a level set are limited to a part
/// of a voxel, from 1 at roughness 0, where that makes no difference, to 0.1 at roughness 1, where the mesh
/// has terraces along the grid. Its vertices are at the zero of these distances, linear between the voxels,
/// within a voxel of the smooth surface; where the mesh has edges each face has its own. `boughs` are at
/// rest, and so is the grid; the vertices are carried from there by the branches near them, so that the skin
/// neither slides nor flickers where these move. Adaptivity is not used.
Result<FusedMesh> roughen(const BranchVolume& boughs, const VolumeOptions& options, const Carriage& carriage);

/// The zero surface of a volume as a mesh, normals from its triangles.
Result<Surface> mesh_of(const Volume& volume, double adaptivity);

/// Writes the volume as a .vdb file with one level set grid, "surface"; atomically.
Result<bool> write_vdb(const std::filesystem::path& path, const Volume& volume);

/// Reads the grid "surface" of such a file.
Result<Volume> read_vdb(const std::filesystem::path& path);

}  // namespace frond
