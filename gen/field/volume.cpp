#include "field/volume.h"

#include <fmt/format.h>
#include <openvdb/io/Stream.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/SignedFloodFill.h>
#include <openvdb/tools/VolumeToMesh.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <sstream>

#include "core/figures.h"
#include "core/files.h"
#include "core/parallel.h"
#include "field/settle.h"
#include "field/whole.h"

// The only place that sees OpenVDB.

namespace frond {

struct Volume::Grid {
  openvdb::FloatGrid::Ptr level_set;
};

namespace {

constexpr float kBand = 3;      // voxels to each side of the surface
constexpr float kMeshBand = 2;  // what a mesh needs of them
// Voxels; the radius of branches is no less, or there would be none of them between the voxels' middles.
constexpr float kThinnest = 0.87f;
constexpr const char* kName = "surface";

// Measured over corals of different kinds; see docs/volumes.md.
constexpr double kBytesABlock = 8500;

using Leaf = openvdb::FloatTree::LeafNodeType;

openvdb::Coord coord(Cell cell) { return {cell.i, cell.j, cell.k}; }

void prepare() {
  static std::once_flag once;
  std::call_once(once, [] { openvdb::initialize(); });
}

/// What an exception of the library says.
template <class Work>
auto guarded(const std::string& where, const Work& work) -> decltype(work()) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    return Error{where, "there is not enough memory for the volume"};
  } catch (const std::exception& error) {
    return Error{where, error.what()};
  }
}

/// A filled block: a leaf of the tree, or all inside.
struct Filled {
  std::unique_ptr<Leaf> leaf;
  bool inside = false;
};

Filled leaf_of(const Boughs& boughs, const Blocks& blocks, const FoundBlock& found) {
  std::array<float, kBlockVoxels> distance;
  Filling filling = fill_block(boughs, blocks, found, distance);
  if (filling != Filling::crossed) return {nullptr, filling == Filling::inside};
  auto leaf = std::make_unique<Leaf>(coord(block_origin(found.block->key)), blocks.band, false);
  for (openvdb::Index i = 0; i < kBlockVoxels; ++i) {
    float d = distance[i];
    if (d > -blocks.band && d < blocks.band)
      leaf->setValueOn(i, d);
    else
      leaf->setValueOff(i, d);
  }
  return {std::move(leaf), false};
}

Volume fill_volume(const Boughs& boughs, const Blocks& blocks) {
  prepare();
  auto grid = openvdb::FloatGrid::create(blocks.band);
  grid->setName(kName);
  grid->setGridClass(openvdb::GRID_LEVEL_SET);
  grid->setTransform(openvdb::math::Transform::createLinearTransform(blocks.voxel));
  openvdb::FloatTree& tree = grid->tree();
  for (const BlockList& list : blocks.lists) {
    std::vector<Filled> filled(list.blocks.size());
    parallel_for(filled.size(), [&](std::size_t i) {
      filled[i] = leaf_of(boughs, blocks, {&list, &list.blocks[i]});
    });
    for (std::size_t i = 0; i < filled.size(); ++i) {
      if (filled[i].leaf)
        tree.addLeaf(filled[i].leaf.release());
      else if (filled[i].inside)
        tree.addTile(1, coord(block_origin(list.blocks[i].key)), -blocks.band, false);
    }
  }
  openvdb::tools::signedFloodFill(tree);
  return Volume(std::make_shared<Volume::Grid>(Volume::Grid{grid}));
}

/// Triangles, those with a corner twice left out, and each four corners cut along the shorter diagonal.
Surface contour(const openvdb::FloatGrid& grid, double adaptivity) {
  std::vector<openvdb::Vec3s> points;
  std::vector<openvdb::Vec3I> triangles;
  std::vector<openvdb::Vec4I> quads;
  openvdb::tools::volumeToMesh(grid, points, triangles, quads, 0.0, adaptivity, true);
  Surface surface;
  surface.position.reserve(points.size());
  for (const openvdb::Vec3s& p : points) surface.position.emplace_back(p.x(), p.y(), p.z());
  points = {};
  surface.triangle.reserve(triangles.size() + 2 * quads.size());
  // OpenVDB winds its faces the other way round.
  auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (a != b && b != c && c != a) surface.triangle.push_back({a, c, b});
  };
  for (const openvdb::Vec3I& t : triangles) add(t[0], t[1], t[2]);
  for (const openvdb::Vec4I& q : quads) {
    const auto& p = surface.position;
    if (glm::distance(p[q[0]], p[q[2]]) <= glm::distance(p[q[1]], p[q[3]]))
      add(q[0], q[1], q[2]), add(q[0], q[2], q[3]);
    else
      add(q[0], q[1], q[3]), add(q[1], q[2], q[3]);
  }
  return surface;
}

/// Leaves what is seen from outside.
void keep_outsides(FusedMesh& mesh, const Boughs& boughs) {
  Surface& s = mesh.surface;
  std::vector<bool> outside = outsides(s, mesh.node, boughs), used(s.position.size());
  if (std::find(outside.begin(), outside.end(), false) == outside.end()) return;
  std::size_t count = 0;
  for (std::size_t t = 0; t < s.triangle.size(); ++t)
    if (outside[t]) s.triangle[count++] = s.triangle[t];
  s.triangle.resize(count);
  for (const auto& t : s.triangle)
    for (std::uint32_t v : t) used[v] = true;
  std::vector<std::uint32_t> index(s.position.size());
  std::uint32_t kept = 0;
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (!used[v]) continue;
    s.position[kept] = s.position[v], s.normal[kept] = s.normal[v], mesh.node[kept] = mesh.node[v];
    index[v] = kept++;
  }
  s.position.resize(kept), s.normal.resize(kept), mesh.node.resize(kept);
  for (auto& t : s.triangle)
    for (std::uint32_t& v : t) v = index[v];
}

}  // namespace

VolumeForecast estimate_volume(const Boughs& boughs, double voxel) {
  VolumeForecast forecast;
  forecast.blocks = count_blocks(boughs, voxel, kBand);
  forecast.bytes = forecast.blocks * kBytesABlock;
  return forecast;
}

Errors refuse_volume(const Boughs& boughs, const VolumeOptions& options) {
  VolumeForecast forecast = estimate_volume(boughs, options.voxel);
  if (forecast.bytes > options.limit) {
    double enough = options.voxel * std::sqrt(forecast.bytes / options.limit) * 1.05;
    return {Error{"", fmt::format("the volume would take about {} of memory, more than the limit of {}; "
                                  "a voxel of {:.2g} m would do",
                                  bytes_text(forecast.bytes), bytes_text(options.limit), enough)}};
  }
  if (!fits_grid(boughs, static_cast<float>(options.voxel)))
    return {Error{"", fmt::format("voxels of {:.2g} m are too small for a place so far from the middle",
                                  options.voxel)}};
  return {};
}

double Volume::voxel() const { return grid_->level_set->voxelSize().x(); }
std::uint64_t Volume::active_voxels() const { return grid_->level_set->activeVoxelCount(); }
std::uint64_t Volume::bytes() const { return grid_->level_set->memUsage(); }
float Volume::at(Cell cell) const { return grid_->level_set->tree().getValue(coord(cell)); }

Result<Volume> volume_of(const Boughs& boughs, const VolumeOptions& options) {
  if (Errors errors = refuse_volume(boughs, options); !errors.empty()) return errors;
  return guarded("", [&]() -> Result<Volume> {
    auto voxel = static_cast<float>(options.voxel);
    Boughs held = at_least_as_thick(boughs, kThinnest * voxel);
    return fill_volume(held, gather_blocks(held, voxel, kBand * voxel));
  });
}

Result<Surface> mesh_of(const Volume& volume, double adaptivity) {
  return guarded("", [&]() -> Result<Surface> {
    Surface surface = contour(*volume.grid().level_set, adaptivity);
    set_normals(surface);
    return surface;
  });
}

Result<FusedMesh> fuse(const Boughs& boughs, const VolumeOptions& options) {
  if (Errors errors = refuse_volume(boughs, options); !errors.empty()) return errors;
  return guarded("", [&]() -> Result<FusedMesh> {
    auto voxel = static_cast<float>(options.voxel);
    Boughs held = at_least_as_thick(boughs, kThinnest * voxel);
    Blocks blocks = gather_blocks(held, voxel, kMeshBand * voxel);
    FusedMesh mesh;
    {
      Volume volume = fill_volume(held, blocks);
      mesh.surface = contour(*volume.grid().level_set, options.adaptivity);
    }
    settle(held, blocks, mesh);
    keep_outsides(mesh, held);
    return mesh;
  });
}

Result<bool> write_vdb(const std::filesystem::path& path, const Volume& volume) {
  prepare();
  // The library's own files do not tell whether all of them came to the disk.
  Result<std::string> bytes = guarded(path.string(), [&]() -> Result<std::string> {
    std::ostringstream out(std::ios::binary);
    openvdb::io::Stream(out).write(openvdb::GridCPtrVec{volume.grid().level_set});
    return std::move(out).str();
  });
  return bytes ? write_file(path, *bytes) : Result<bool>(bytes.errors());
}

Result<Volume> read_vdb(const std::filesystem::path& path) {
  prepare();
  return guarded(path.string(), [&]() -> Result<Volume> {
    openvdb::io::File file(path.string());
    file.open();
    auto grid = openvdb::gridPtrCast<openvdb::FloatGrid>(file.readGrid(kName));
    if (!grid) return Error{path.string(), "holds no volume named \"surface\""};
    return Volume(std::make_shared<Volume::Grid>(Volume::Grid{grid}));
  });
}

}  // namespace frond
