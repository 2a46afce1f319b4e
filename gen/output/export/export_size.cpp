#include <algorithm>
#include <cmath>
#include <set>

#include "export/export_scene.h"

namespace frond {

namespace {

void count(ExportSize& size, const Surface& surface, double times, bool fresh) {
  auto vertices = static_cast<double>(surface.position.size());
  auto triangles = static_cast<double>(surface.triangle.size());
  if (fresh) size.vertices += vertices, size.triangles += triangles;
  size.all_vertices += vertices * times, size.all_triangles += triangles * times;
}

/// Adds the vertices and triangles of the branches of one organism.
void count_branches(ExportSize& size, const Specimen& b, const ExportOptions& options) {
  double vertices = 0, triangles = 0;
  auto nodes = static_cast<double>(b.model.skeleton.size());
  if (b.style.build == Build::sweeps) {
    double ends = 0;
    for (std::size_t i = 1; i < b.model.skeleton.size(); ++i)
      ends += b.model.skeleton.parent[i] != static_cast<std::int32_t>(i) - 1;
    vertices = (nodes + 4 * ends) * (options.sides + 1);
    triangles = (nodes + 4 * ends) * options.sides * 2;
  } else {
    // A block that the surface passes has about a square of its side in it, and somewhat more aslant.
    double blocks = estimate_volume(boughs_of(b.model.skeleton, 0), b.style.voxel).blocks;
    vertices = blocks * 64, triangles = 2 * vertices;
  }
  size.vertices += vertices, size.triangles += triangles;
  size.all_vertices += vertices, size.all_triangles += triangles;
  size.placements += 1;
}

}  // namespace

ExportSize size_of(const ExportScene& exported) {
  ExportSize size;
  for (const ExportMesh& mesh : exported.meshes) {
    for (const ExportPart& part : mesh.parts) {
      count(size, part.surface, 0, true);
      size.shifts += static_cast<double>(part.shifts.size() * part.surface.position.size());
    }
    for (const auto& parts : mesh.coarser)
      for (const ExportPart& part : parts) count(size, part.surface, 0, true);
  }
  for (const ExportPlacement& p : exported.placements)
    for (const ExportPart& part : exported.meshes[p.mesh].parts) count(size, part.surface, 1, false);
  for (const ExportPicture& picture : exported.pictures)
    size.pictures += static_cast<double>(picture.png.size());
  size.placements = static_cast<double>(exported.placements.size());
  return size;
}

std::vector<double> level_triangles(const ExportScene& exported) {
  std::vector<double> triangles(1, 0);
  for (const ExportPlacement& p : exported.placements) {
    const ExportMesh& mesh = exported.meshes[p.mesh];
    triangles.resize(std::max(triangles.size(), mesh.coarser.size() + 1), 0);
    for (std::size_t level = 0; level <= mesh.coarser.size(); ++level)
      for (const ExportPart& part : level == 0 ? mesh.parts : mesh.coarser[level - 1])
        triangles[level] += static_cast<double>(part.surface.triangle.size());
  }
  return triangles;
}

namespace {

constexpr double kPixelBytes = 3.5;    // of three pictures, for one pixel of the colours
constexpr double kLeafPictures = 0.3;  // what those of a leaf take of those of a bark

/// What all of one organism take without --detail and merging; fused bodies aside.
ExportSize whole(const Specimen& b) {
  ExportSize size;
  std::vector<bool> seen(b.model.prototypes.size());
  for (std::uint16_t which : b.model.organs.prototype) {
    for (const OrganPart& part : b.model.prototypes[which].parts) count(size, part.surface, 1, !seen[which]);
    size.placements += 1;
    seen[which] = true;
  }
  count(size, b.model.blades.surface, 1, true);
  for (const Solid& solid : b.model.solids.shapes) count(size, solid.surface, 0, true);
  for (std::uint16_t which : b.model.solids.shape)
    count(size, b.model.solids.shapes[which].surface, 1, false);
  size.placements += static_cast<double>(b.model.solids.size());
  return size;
}

/// How many times the pictures of a bark those of an organism take; solids share theirs by their matter.
double pictures_of(const Specimen& b) {
  double times = b.look.branches.drawn() && b.model.skeleton.size() > 1 ? 1 : 0;
  std::set<std::uint16_t> used(b.model.organs.prototype.begin(), b.model.organs.prototype.end());
  std::set<std::size_t> colors;
  for (std::uint16_t which : used) colors.insert(b.model.prototypes[which].colors.size());
  for (std::size_t count : colors) times += kLeafPictures * static_cast<double>(count);
  std::set<Matter> matters;
  for (const Solid& solid : b.model.solids.shapes) matters.insert(solid.material.matter);
  return times + static_cast<double>(matters.size());
}

void add(ExportSize& size, const ExportSize& more, double share) {
  size.vertices += share * more.vertices, size.triangles += share * more.triangles;
  size.all_vertices += share * more.all_vertices, size.all_triangles += share * more.all_triangles;
  size.placements += more.placements;
}

}  // namespace

ExportSize estimate_export(const Scene& scene, const ExportOptions& options) {
  ExportSize size;
  double pixels = options.texture * static_cast<double>(options.texture);
  std::set<std::size_t> entries;  // whose pictures are counted
  for (const Specimen& b : scene.specimens) {
    ExportSize own = whole(b);
    if (!options.instances)
      own.vertices = own.all_vertices, own.triangles = own.all_triangles, own.placements = 2;
    bool simpler = b.style.build == Build::sweeps;
    if (simpler && b.look.branches.drawn() && b.model.skeleton.size() > 1) count_branches(own, b, options);
    add(size, own, options.instances ? 1 : std::min(1.0, options.detail / std::max(1.0, own.triangles)));
    if (!simpler && b.look.branches.drawn() && b.model.skeleton.size() > 1) count_branches(size, b, options);
    if (entries.insert(b.entry).second) size.pictures += kPixelBytes * pixels * pictures_of(b);
  }
  double levels = (1 - std::pow(kCoarser, options.levels)) / (1 - kCoarser);
  size.vertices *= levels, size.triangles *= levels;
  size.shifts = size.vertices * static_cast<double>(options.keys.size());
  return size;
}

}  // namespace frond
