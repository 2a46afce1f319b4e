#include "land/puddles.h"

#include <algorithm>
#include <cstdint>

namespace frond {

namespace {

constexpr float kLeastHollow = 0.002f;  // metres: what is less deep is no hollow
constexpr double kDeepestPuddle = 0.04, kGathered = 4;

/// The points of the hollow that a point lies in.
std::vector<std::size_t> hollow_at(const GroundGrid& ground, const std::vector<float>& full, std::size_t from,
                                   std::vector<bool>& seen) {
  std::vector<std::size_t> points{from};
  seen[from] = true;
  for (std::size_t i = 0; i < points.size(); ++i)
    each_beside(ground, points[i], [&](std::size_t k) {
      if (seen[k] || full[k] - ground.height[k] <= 0) return;
      seen[k] = true;
      points.push_back(k);
    });
  return points;
}

/// Faces of that height over all cells of which a corner is lower, among the points of a hollow.
void append_level(Surface& water, const GroundGrid& ground, const std::vector<std::size_t>& hollow,
                  float level, std::vector<std::uint32_t>& vertex) {
  std::vector<std::size_t> cells;  // by the point of their lowest column and row
  for (std::size_t k : hollow) {
    if (ground.height[k] >= level) continue;
    auto side = static_cast<std::size_t>(ground.side);
    for (std::size_t cell : {k, k - 1, k - side, k - side - 1}) cells.push_back(cell);
  }
  std::ranges::sort(cells);
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  std::vector<std::size_t> used;
  auto corner = [&](std::size_t k) {
    if (vertex[k] == 0) {
      Vec2 at = ground.place(k);
      water.position.push_back({at.x, level, at.y});
      vertex[k] = static_cast<std::uint32_t>(water.position.size());
      used.push_back(k);
    }
    return vertex[k] - 1;
  };
  for (std::size_t k : cells) {
    auto side = static_cast<std::size_t>(ground.side);
    std::uint32_t a = corner(k), b = corner(k + 1), c = corner(k + side), d = corner(k + side + 1);
    water.triangle.push_back({a, c, b});
    water.triangle.push_back({b, c, d});
  }
  for (std::size_t k : used) vertex[k] = 0;
}

}  // namespace

Surface puddles(const GroundGrid& ground, const std::vector<float>& full, double depth) {
  std::vector<bool> seen(full.size());
  std::vector<std::uint32_t> vertex(full.size());
  Surface water;
  for (std::size_t k = 0; k < full.size(); ++k) {
    if (seen[k] || full[k] - ground.height[k] <= kLeastHollow) continue;
    std::vector<std::size_t> hollow = hollow_at(ground, full, k, seen);
    float low = full[k];
    for (std::size_t i : hollow) low = std::min(low, ground.height[i]);
    append_level(water, ground, hollow, std::min(full[k] - kLeastHollow / 2, low + static_cast<float>(depth)),
                 vertex);
  }
  water.normal.assign(water.position.size(), Vec3(0, 1, 0));
  return water;
}

double puddle_depth(double fallen) { return std::min(kDeepestPuddle, kGathered * fallen / 1000); }

}  // namespace frond
