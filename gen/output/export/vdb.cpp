
#include <algorithm>

#include "core/bounds.h"
#include "core/figures.h"
#include "draw/draw_list.h"
#include "export/formats.h"
#include "export/parts.h"
#include "geometry/far.h"

namespace frond {

namespace {

constexpr double kVoxels = 400;       // along a volume that nothing says the voxel of
constexpr double kSegmentBytes = 60;  // of memory, for one of a branch
constexpr double kLeastLimit = 4e9;   // bytes of memory, where no organism says more

/// The branches of a scene as they are put together.
struct Gathered {
  BranchVolume boughs;
  std::int32_t nodes = 0;
  Bounds box;
  VolumeOptions options;
};

void add_branches(Gathered& all, const DrawnBranches& b, bool own_voxel) {
  const Style& style = b.traits.style;
  add_boughs(all.boughs, b.rest(), b.pose.position, b.pose.radius, b.pose.front,
             static_cast<float>(style.blend), all.nodes);
  all.nodes += static_cast<std::int32_t>(b.rest().size());
  for (const Vec3& p : b.pose.position) all.box.extend(p);
  if (own_voxel && style.build != Build::sweeps)
    all.options.voxel = all.options.voxel > 0 ? std::min(all.options.voxel, style.voxel) : style.voxel;
  all.options.limit = std::max(all.options.limit, style.limit);
}

Vec3 at_copy(const ExportPlacement& copy, Vec3 p) { return copy.at + copy.turn * (p * copy.scale); }

/// Adds the copies of what is sown, without branches that are much thinner than a voxel.
Errors add_copies(Gathered& all, const std::vector<SownBranches>& sown) {
  auto voxel = static_cast<float>(all.options.voxel);
  std::vector<Skeleton> shapes;
  double bytes = 0;
  for (const SownBranches& model : sown) {
    shapes.push_back(thinned(model.rest, 0.25f * voxel, 0.25f * voxel));
    bytes += kSegmentBytes * static_cast<double>(shapes.back().size() * model.copies.size());
  }
  if (bytes > all.options.limit)
    return {error_at("",
                     "the branches of all copies would take about {} of memory, more than the limit of {}; a "
                     "larger --voxel leaves more of the thin ones out",
                     bytes_text(bytes), bytes_text(all.options.limit))};
  std::vector<Vec3> position;
  std::vector<float> radius;
  for (std::size_t m = 0; m < sown.size(); ++m)
    for (const ExportPlacement& copy : sown[m].copies) {
      position.clear(), radius.clear();
      for (const Vec3& p : shapes[m].position) position.push_back(at_copy(copy, p));
      for (float r : shapes[m].radius) radius.push_back(r * copy.scale.x);
      add_boughs(all.boughs, shapes[m], position, radius, 2, 1, all.nodes);
      all.nodes += static_cast<std::int32_t>(shapes[m].size());
    }
  return {};
}

}  // namespace

Result<Volume> export_volume(const Scene& scene, double time, const ExportOptions& options) {
  Gathered all;
  all.options = {options.voxel, 0, 0};
  for (const Specimen& organism : scene.specimens) {
    auto now = developed(organism, time);
    if (!now) return now.errors();
    DrawList drawn(**now, time);
    if (drawn.branches && drawn.model.skeleton.size() > 1)
      add_branches(all, *drawn.branches, options.voxel <= 0);
  }
  Result<std::vector<SownBranches>> sown = sown_branches(scene, time);
  if (!sown) return sown.errors();
  for (const SownBranches& model : *sown)
    for (const ExportPlacement& copy : model.copies)
      for (const Vec3& p : model.rest.position) all.box.extend(at_copy(copy, p));
  if (all.boughs.cones.empty() && sown->empty())
    return scene.specimens.empty() ? Error{"", "there are no branches to make a volume of"}
                                   : Error{"", std::string(kNothingYet) +
                                                   "that frame: there are no branches to make a volume of"};
  if (all.options.limit <= 0) all.options.limit = kLeastLimit;
  if (all.options.voxel <= 0) all.options.voxel = all.box.longest() / kVoxels;
  if (Errors errors = add_copies(all, *sown); !errors.empty()) return errors;
  return volume_of(all.boughs, all.options);
}

}  // namespace frond
