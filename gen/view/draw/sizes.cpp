#include "draw/sizes.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/bounds.h"
#include "core/printable.h"
#include "draw/draw_list.h"

namespace frond {

namespace {

constexpr float kBreast = 1.3f;  // metres: where foresters measure

/// Twice the largest radius of a branch that passes that height above the lowest root.
double stem_of(const Skeleton& s, const Pose& pose, double height) {
  float foot = s.size() > 0 ? pose.position[0].y : 0;
  for (std::size_t i = 0; i < s.size(); ++i)
    if (s.parent[i] == Skeleton::kRoot) foot = std::min(foot, pose.position[i].y);
  float level = foot + std::min(kBreast, static_cast<float>(0.1 * height)), most = 0;
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (s.parent[i] == Skeleton::kRoot) continue;
    auto parent = static_cast<std::size_t>(s.parent[i]);
    float low = pose.position[parent].y, high = pose.position[i].y;
    if (low <= level && high > level) most = std::max(most, std::min(pose.radius[parent], pose.radius[i]));
  }
  return 2.0 * static_cast<double>(most);
}

/// The box of what is to be seen of an organism.
Bounds box_of(const DrawList& drawn) {
  Bounds box;
  for (std::size_t i = 0; i < drawn.pose.position.size(); ++i)
    if (drawn.pose.radius[i] > 0) box.extend(drawn.pose.position[i], drawn.pose.radius[i]);
  auto extend = [&box](const Surface& surface, const OrganPlace& place) {
    for (const Vec3& p : surface.position) box.extend(place.at + place.turn * (place.scale * p));
  };
  for (const OrganGroup& group : drawn.organs.groups)
    for (const OrganPlace& place : drawn.organs.places(group))
      for (const OrganPart& part : drawn.model.prototypes[group.prototype].parts) extend(part.surface, place);
  for (const DrawnBlades& blades : drawn.blades)
    for (const Vec3& p : blades.surface.position) box.extend(p);
  for (const DrawnBody& body : drawn.bodies)
    for (const OrganPlace& place : body.places) extend(body.surface(), place);
  return box;
}

}  // namespace

Result<std::vector<GrownSize>> sizes_of(const Scene& scene, const Preset& preset, double time) {
  std::vector<GrownSize> sizes(preset.organisms.size());
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const std::string& name = preset.organisms[i].name;
    sizes[i].name = name.empty() ? fmt::format("organism {}", i) : name;
  }
  for (const Specimen& s : scene.specimens) {
    if (s.entry == Traits::kNoEntry) continue;
    Result<std::shared_ptr<const Specimen>> now = developed(s, time);
    if (!now) return now.errors();
    GrownSize& size = sizes[s.entry];
    ++size.count;
    DrawList drawn(**now, time);
    Bounds box = box_of(drawn);
    if (box.empty()) continue;
    double height = box.size().y;
    size.height = std::max(size.height, height);
    size.width = std::max<double>({size.width, box.size().x, box.size().z});
    size.stem = std::max(size.stem, stem_of(drawn.model.skeleton, drawn.pose, height));
  }
  for (const CopySet& set : scene.copy_sets) {
    GrownSize& size = sizes[set.entry];
    size.count = set.copies.size();
    Vec3 scale(0);
    for (std::size_t i = 0; i < set.copies.size(); ++i)
      if (set.copies.there(i, time)) scale = glm::max(scale, set.copies.scale_at(i, time));
    size.height = static_cast<double>(scale.y) * set.tallest();
    size.width = 2.0 * static_cast<double>(std::max(scale.x, scale.z)) * set.organism.sown->where.radius;
  }
  return sizes;
}

std::vector<std::string> sizes_lines(const std::vector<GrownSize>& sizes) {
  auto metres = [](double x) {
    return x < 1 ? fmt::format("{:.2g} cm", 100 * x) : fmt::format("{:.3g} m", x);
  };
  std::vector<std::string> lines;
  for (const GrownSize& s : sizes) {
    if (s.count == 0) continue;
    std::string line = printable(s.name);
    if (s.count > 1) line += fmt::format(", {} of at most", s.count);
    line += s.count > 1 ? " " : ": ";
    if (s.width == 0) {
      lines.push_back(printable(s.name) + ": nothing of it is to be seen yet");
      continue;
    }
    if (s.height > 0) line += metres(s.height) + " high, ";
    line += metres(s.width) + " wide";
    if (s.stem > 0) line += ", stem of " + metres(s.stem);
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace frond
