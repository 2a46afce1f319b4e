#include "scene/sizes.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/bounds.h"
#include "core/printable.h"
#include "scene/fit.h"

namespace frond {

namespace {

constexpr float kBreast = 1.3f;  // metres: where foresters measure

/// Twice the largest radius of a branch that passes that height above the lowest root.
double stem_of(const Skeleton& s, double height) {
  float foot = s.size() > 0 ? s.position[0].y : 0;
  for (std::size_t i = 0; i < s.size(); ++i)
    if (s.parent[i] == Skeleton::kRoot) foot = std::min(foot, s.position[i].y);
  float level = foot + std::min(kBreast, static_cast<float>(0.1 * height)), most = 0;
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (s.parent[i] == Skeleton::kRoot) continue;
    auto parent = static_cast<std::size_t>(s.parent[i]);
    float low = s.position[parent].y, high = s.position[i].y;
    if (low <= level && high > level) most = std::max(most, std::min(s.radius[parent], s.radius[i]));
  }
  return 2.0 * static_cast<double>(most);
}

}  // namespace

std::vector<GrownSize> sizes_of(const Scene& scene, const Preset& preset) {
  std::vector<GrownSize> sizes(preset.organisms.size());
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const std::string& name = preset.organisms[i].name;
    sizes[i].name = name.empty() ? fmt::format("organism {}", i) : name;
  }
  for (const Specimen& s : scene.specimens) {
    if (s.entry == Traits::kNoEntry) continue;
    Bounds box = bounds_of(outside_of(s.model));
    if (box.empty()) continue;
    GrownSize& size = sizes[s.entry];
    ++size.count;
    double height = box.size().y;
    size.height = std::max(size.height, height);
    size.width = std::max<double>({size.width, box.size().x, box.size().z});
    size.stem = std::max(size.stem, stem_of(s.model.skeleton, height));
  }
  for (const SownStand& stand : scene.stands) {
    GrownSize& size = sizes[stand.entry];
    size.count = stand.copies.size();
    float scale = 0;
    for (float s : stand.copies.scale) scale = std::max(scale, s);
    size.height = static_cast<double>(scale) * stand.tallest();
    size.width = 2.0 * static_cast<double>(scale) * stand.organism.sown->where.radius;
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
    if (s.height > 0) line += metres(s.height) + " high, ";
    line += metres(s.width) + " wide";
    if (s.stem > 0) line += ", stem of " + metres(s.stem);
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace frond
