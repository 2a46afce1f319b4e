#include "land/suitability.h"

#include "core/noise.h"

namespace frond {

namespace {

constexpr int kGridCells = 160;      // of the grid that darts are thrown by, along each side
constexpr double kClumpSoft = 0.08;  // of the noise on either side of a clump's edge

/// 1 within from..to, falling to 0 at the ends over a part of it; not at an end that lies beyond
/// least..most, which is all there is.
double window(double x, Vec2 range, double least, double most, double soft) {
  double from = range.x, to = range.y;
  if (x < from || x > to) return 0;
  soft = std::min(soft, (std::min(to, most) - std::max(from, least)) / 4);
  double share = 1;
  if (from > least) share *= smooth_step(from, from + soft, x);
  if (to < most) share *= 1 - smooth_step(to - soft, to, x);
  return share;
}

}  // namespace

Suitability::Suitability(const SowRules& rules, const Land& land, std::span<const PlantGrid> above, Seed seed)
    : rules_(rules), land_(land), above_(above), seed_(seed) {
  Vec2 half(static_cast<float>(land.size / 2)), high = half;
  low_ = -half;
  if (rules.reach > 0) {
    Vec2 reach(static_cast<float>(rules.reach));
    low_ = glm::max(low_, rules.center - reach);
    high = glm::min(high, rules.center + reach);
  }
  if (low_.x >= high.x || low_.y >= high.y) return;
  step_ = (high - low_) / static_cast<float>(kGridCells);

  constexpr std::size_t kCorners = kGridCells + 1;
  std::vector<double> liked(kCorners * kCorners), noise;
  if (rules.patch > 0 && rules.cover < 1) {
    for (std::size_t i = 0; i < liked.size(); ++i) noise.push_back(clumps(corner(i)));
    std::sort(noise.begin(), noise.end());
    clump_edge_ = noise[static_cast<std::size_t>((1 - rules.cover) * static_cast<double>(noise.size() - 1))];
  }
  if (land.altitude)
    for (int row = 0; row <= 64; ++row)
      for (int column = 0; column <= 64; ++column)
        relief_ = std::max(relief_, land.altitude(Vec2(-half) + 2.0f * half * Vec2(column, row) / 64.0f));
  for (std::size_t i = 0; i < liked.size(); ++i) liked[i] = (*this)(corner(i));
  for (std::size_t row = 0; row < kGridCells; ++row)
    for (std::size_t column = 0; column < kGridCells; ++column) {
      std::size_t a = row * kCorners + column;
      best_.push_back(std::max({liked[a], liked[a + 1], liked[a + kCorners], liked[a + kCorners + 1]}));
      lots_.add(best_.back());
    }
}

Vec2 Suitability::corner(std::size_t i) const {
  return low_ + step_ * Vec2(i % (kGridCells + 1), i / (kGridCells + 1));
}

double Suitability::clumps(Vec2 at) const {
  Vec2 p = at * static_cast<float>(1.2 / rules_.patch);
  auto level = static_cast<float>(seed_.child("clumps").range(0, 999));
  return noise(Vec3(p.x, level, p.y)) + 0.35 * noise(Vec3(2.3f * p.x, level + 9, 2.3f * p.y));
}

double Suitability::shade(Vec2 at) const {
  double open = 1;
  for (const PlantGrid& bed : above_)
    bed.each_within(at, 2.2, [&](const PlantGrid::Plant& plant) {
      open *= 1 - hidden_sky(glm::distance(at, plant.at), plant.radius);
    });
  return 1 - open;
}

double Suitability::operator()(Vec2 at) const {
  if (rules_.reach > 0 && glm::distance(at, rules_.center) > rules_.reach) return 0;
  double share = 1;
  if (rules_.patch > 0 && rules_.cover < 1)
    share *= smooth_step(clump_edge_ - kClumpSoft, clump_edge_ + kClumpSoft, clumps(at));
  if (rules_.cover <= 0) return 0;
  share *= rules_.map.on_land(at, land_.size);
  if (share <= 0) return 0;
  if (land_.path && land_.path(at) < rules_.clear) return 0;
  if (land_.slope) {
    double slope = land_.slope(at);
    if (slope > rules_.slope) return 0;
    share *= 1 - smooth_step(0.75 * rules_.slope, rules_.slope, slope);
  }
  if (land_.altitude) share *= window(land_.altitude(at), rules_.altitude, 0, relief_, relief_ / 10);
  if (rules_.warmth && land_.altitude) share *= warm_share(*rules_.warmth, land_.altitude(at));
  if (share > 0 && (rules_.shade.x > 0 || rules_.shade.y < 1) && !above_.empty())
    share *= window(shade(at), rules_.shade, 0, 1, 0.1);
  return share;
}

Suitability::Dart Suitability::dart(Seed seed) const {
  std::size_t cell = lots_.drawn(seed.child(0).unit());
  Vec2 in(static_cast<float>(cell % kGridCells) + static_cast<float>(seed.child(1).unit()),
          static_cast<float>(cell / kGridCells) + static_cast<float>(seed.child(2).unit()));
  return {low_ + step_ * in, best_[cell]};
}

}  // namespace frond
