#include "field/volume.h"

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
#include "field/solid.h"
#include "field/whole.h"
#include "geometry/crease.h"

// The only place that sees OpenVDB.

namespace frond {

struct Volume::Grid {
  openvdb::FloatGrid::Ptr level_set;
};

namespace {

constexpr float kBand = 3;               // voxels to each side of the surface
constexpr float kMeshBand = 2;           // what a mesh needs of them
constexpr float kRoughest = 0.1f;        // voxels to which distances are limited at roughness 1
constexpr double kEdge = radians(30.0);  // between faces of a rough skin, from which there is an edge
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

/// Of the block at `first`, whose voxels within `band` are active; no distance is above `most`. Metres.
Filled leaf_of(Cell first, const BlockFiller& fill, float band, float most) {
  std::array<float, kBlockVoxels> distance;
  Filling filling = fill(first, distance);
  if (filling != Filling::crossed) return {nullptr, filling == Filling::inside};
  auto leaf = std::make_unique<Leaf>(coord(first), most, false);
  for (openvdb::Index i = 0; i < kBlockVoxels; ++i) {
    float d = distance[i], value = std::clamp(d, -most, most);
    if (d > -band && d < band)
      leaf->setValueOn(i, value);
    else
      leaf->setValueOff(i, value);
  }
  return {std::move(leaf), false};
}

/// A level set without a voxel; metres.
openvdb::FloatGrid::Ptr empty_grid(float voxel, float most) {
  prepare();
  auto grid = openvdb::FloatGrid::create(most);
  grid->setName(kName);
  grid->setGridClass(openvdb::GRID_LEVEL_SET);
  grid->setTransform(openvdb::math::Transform::createLinearTransform(voxel));
  return grid;
}

/// Puts a block into a level set.
void put(openvdb::FloatTree& tree, Cell first, Filled&& filled, float most) {
  if (filled.leaf)
    tree.addLeaf(filled.leaf.release());
  else if (filled.inside)
    tree.addTile(1, coord(first), -most, false);
}

/// The distances of the blocks, none of them above `most` to either side; metres.
Volume fill_volume(const BranchVolume& boughs, const Blocks& blocks, float most) {
  auto grid = empty_grid(blocks.voxel, most);
  for (const BlockList& list : blocks.lists) {
    std::vector<Filled> filled(list.blocks.size());
    parallel_for(filled.size(), [&](std::size_t i) {
      FoundBlock found{&list, &list.blocks[i]};
      auto fill = [&](Cell, std::span<float, kBlockVoxels> distance) {
        return fill_block(boughs, blocks, found, distance);
      };
      filled[i] = leaf_of(block_origin(found.block->key), fill, blocks.band, most);
    });
    for (std::size_t i = 0; i < filled.size(); ++i)
      put(grid->tree(), block_origin(list.blocks[i].key), std::move(filled[i]), most);
  }
  openvdb::tools::signedFloodFill(grid->tree());
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

/// The distance at a place in voxels, linear between their middles, and its slope.
float between(const openvdb::FloatGrid::ConstAccessor& read, Vec3 at, Vec3& slope) {
  Vec3 low = glm::floor(at), share = at - low;
  openvdb::Coord first(static_cast<int>(low.x), static_cast<int>(low.y), static_cast<int>(low.z));
  float sum = 0;
  slope = Vec3(0);
  for (int c = 0; c < 8; ++c) {
    openvdb::Coord corner(c & 1, c >> 1 & 1, c >> 2);
    float value = read.getValue(first + corner);
    Vec3 part, sign;
    for (int a = 0; a < 3; ++a) {
      part[a] = corner[a] ? share[a] : 1 - share[a];
      sign[a] = corner[a] ? 1.0f : -1.0f;
    }
    sum += value * part.x * part.y * part.z;
    slope += value * sign * Vec3(part.y * part.z, part.x * part.z, part.x * part.y);
  }
  return sum;
}

/// Moves the vertices of a mesh onto the surface where the distances, linear between voxels, are 0: that
/// changes as steadily as they do, whatever the triangles are.
void settle_between(const openvdb::FloatGrid& grid, Surface& surface) {
  constexpr std::size_t kPart = 8000;  // vertices
  constexpr int kSteps = 3;
  constexpr float kMost = 0.5f;  // voxels that a vertex is moved at most
  auto voxel = static_cast<float>(grid.voxelSize().x());
  std::size_t count = surface.position.size(), parts = count / kPart + 1;
  parallel_for(parts, [&](std::size_t p) {
    openvdb::FloatGrid::ConstAccessor read = grid.getConstAccessor();
    for (std::size_t v = count * p / parts; v < count * (p + 1) / parts; ++v) {
      Vec3 start = surface.position[v] / voxel, shift(0), slope;
      for (int step = 0; step < kSteps; ++step) {
        float value = between(read, start + shift, slope), steep = glm::dot(slope, slope);
        if (steep <= 0) break;
        shift -= slope * (value / steep);
        if (float length = glm::length(shift); length > kMost) shift *= kMost / length;
      }
      surface.position[v] = (start + shift) * voxel;
    }
  });
}

/// Leaves what is seen from outside.
void keep_outsides(FusedMesh& mesh, const BranchVolume& boughs) {
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

VolumeForecast estimate_volume(const BranchVolume& boughs, double voxel) {
  VolumeForecast forecast;
  forecast.blocks = count_blocks(boughs, voxel, kBand);
  forecast.bytes = forecast.blocks * kBytesABlock;
  return forecast;
}

Errors refuse_volume(const BranchVolume& boughs, const VolumeOptions& options) {
  VolumeForecast forecast = estimate_volume(boughs, options.voxel);
  if (forecast.bytes > options.limit) {
    double enough = options.voxel * std::sqrt(forecast.bytes / options.limit) * 1.05;
    return {error_at(
        "",
        "the volume would take about {} of memory, more than the limit of {}; a voxel of {:.2g} m would do",
        bytes_text(forecast.bytes), bytes_text(options.limit), enough)};
  }
  if (!fits_grid(boughs, static_cast<float>(options.voxel)))
    return {
        error_at("", "voxels of {:.2g} m are too small for a place so far from the middle", options.voxel)};
  return {};
}

double Volume::voxel() const { return grid_->level_set->voxelSize().x(); }
std::uint64_t Volume::active_voxels() const { return grid_->level_set->activeVoxelCount(); }
std::uint64_t Volume::bytes() const { return grid_->level_set->memUsage(); }
float Volume::at(Cell cell) const { return grid_->level_set->tree().getValue(coord(cell)); }

Result<Volume> volume_of(const BranchVolume& boughs, const VolumeOptions& options) {
  if (Errors errors = refuse_volume(boughs, options); !errors.empty()) return errors;
  return guarded("", [&]() -> Result<Volume> {
    auto voxel = static_cast<float>(options.voxel);
    BranchVolume held = at_least_as_thick(boughs, kThinnest * voxel);
    return fill_volume(held, gather_blocks(held, voxel, kBand * voxel), kBand * voxel);
  });
}

Result<Surface> mesh_of(const Volume& volume, double adaptivity) {
  return guarded("", [&]() -> Result<Surface> {
    Surface surface = contour(*volume.grid().level_set, adaptivity);
    set_normals(surface);
    return surface;
  });
}

Result<Surface> solid_surface(const Box& box, double voxel, const BlockFiller& fill) {
  return guarded("", [&]() -> Result<Surface> {
    auto side = static_cast<float>(voxel), band = kMeshBand * side;
    Cell low = block_origin(block_key(voxel_at(Vec3(box.low), side))), high = voxel_at(Vec3(box.high), side);
    std::vector<Cell> blocks;
    for (Cell c = low; c.i <= high.i; c.i += kBlockSide)
      for (c.j = low.j; c.j <= high.j; c.j += kBlockSide)
        for (c.k = low.k; c.k <= high.k; c.k += kBlockSide) blocks.push_back(c);
    std::vector<Filled> filled(blocks.size());
    parallel_for(filled.size(), [&](std::size_t i) { filled[i] = leaf_of(blocks[i], fill, band, band); });
    auto grid = empty_grid(side, band);
    for (std::size_t i = 0; i < filled.size(); ++i) put(grid->tree(), blocks[i], std::move(filled[i]), band);
    openvdb::tools::signedFloodFill(grid->tree());
    Surface surface = contour(*grid, 0);
    set_normals(surface);
    return surface;
  });
}

Result<FusedMesh> fuse(const BranchVolume& boughs, const VolumeOptions& options) {
  if (Errors errors = refuse_volume(boughs, options); !errors.empty()) return errors;
  return guarded("", [&]() -> Result<FusedMesh> {
    auto voxel = static_cast<float>(options.voxel);
    BranchVolume held = at_least_as_thick(boughs, kThinnest * voxel);
    Blocks blocks = gather_blocks(held, voxel, kMeshBand * voxel);
    FusedMesh mesh;
    {
      Volume volume = fill_volume(held, blocks, blocks.band);
      mesh.surface = contour(*volume.grid().level_set, options.adaptivity);
    }
    settle(held, blocks, mesh);
    keep_outsides(mesh, held);
    return mesh;
  });
}

Result<FusedMesh> roughen(const BranchVolume& boughs, const VolumeOptions& options,
                          const Carriage& carriage) {
  if (Errors errors = refuse_volume(boughs, options); !errors.empty()) return errors;
  return guarded("", [&]() -> Result<FusedMesh> {
    auto voxel = static_cast<float>(options.voxel);
    BranchVolume held = at_least_as_thick(boughs, kThinnest * voxel);
    Blocks blocks = gather_blocks(held, voxel, kMeshBand * voxel);
    float most = voxel * glm::mix(1.0f, kRoughest, static_cast<float>(options.roughness));
    FusedMesh mesh;
    {
      Volume volume = fill_volume(held, blocks, most);
      mesh.surface = contour(*volume.grid().level_set, 0);
      settle_between(*volume.grid().level_set, mesh.surface);
    }
    // What is left out and where there are edges is decided at rest; until then normals hold the way.
    mesh.surface.normal = carried_by(held, blocks, carriage, mesh);
    keep_outsides(mesh, held);
    std::vector<std::uint32_t> source;
    FusedMesh carried{creased(mesh.surface, kEdge, &source), {}};
    for (std::size_t v = 0; v < source.size(); ++v) {
      carried.node.push_back(mesh.node[source[v]]);
      carried.surface.position[v] += mesh.surface.normal[source[v]];
      Vec3& normal = carried.surface.normal[v];
      normal = carriage.turn[carried.node[v]] * normal;
    }
    return carried;
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
