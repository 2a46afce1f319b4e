#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>

#include "core/parallel.h"
#include "light/light.h"

// What is laid into the grids, and how much light goes through it.

namespace frond {

namespace {

constexpr float kQuanta = 4096;  // of fixed point, to a cell's face
constexpr std::size_t kMostCells = 6'000'000;

void sum_up(std::uint32_t& to, std::uint32_t more) {
  std::atomic_ref<std::uint32_t>(to).fetch_add(more, std::memory_order_relaxed);
}

void face(Facing& all, Facing facing) {
  std::atomic_ref<Facing> looks(all);
  if ((looks.load(std::memory_order_relaxed) & facing) != facing)
    looks.fetch_or(facing, std::memory_order_relaxed);
}

}  // namespace

double SoftLight::away(Vec3 at) const {
  double least = 1e30;
  for (const Eye& eye : eyes_) least = std::min<double>(least, glm::distance(eye.at, at));
  return least;
}

std::size_t SoftLight::Level::count() const {
  return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
         static_cast<std::size_t>(size.z);
}

std::size_t SoftLight::Level::index(glm::ivec3 i) const {
  return (static_cast<std::size_t>(i.y) * static_cast<std::size_t>(size.z) + static_cast<std::size_t>(i.z)) *
             static_cast<std::size_t>(size.x) +
         static_cast<std::size_t>(i.x);
}

bool SoftLight::Level::index(Vec3 at, std::size_t& found) const {
  Vec3 p = at / cell - Vec3(low);
  Vec3 end(size);
  if (!(p.x >= 0 && p.y >= 0 && p.z >= 0 && p.x < end.x && p.y < end.y && p.z < end.z)) return false;
  found = index(glm::ivec3(p));
  return true;
}

Vec3 SoftLight::Level::middle(glm::ivec3 of) const { return (Vec3(low + of) + 0.5f) * cell; }

float SoftLight::Level::loose(std::size_t i, float upright) const {
  return glm::mix(std::bit_cast<float>(area[i]), std::bit_cast<float>(thin[i]), upright);
}

float SoftLight::Level::depth(std::size_t i, float upright) const {
  return loose(i, upright) + std::bit_cast<float>(body[i]);
}

Vec3 SoftLight::Level::radiance(std::size_t i) const {
  return {std::bit_cast<float>(color[0][i]), std::bit_cast<float>(color[1][i]),
          std::bit_cast<float>(color[2][i])};
}

SoftLight SoftLight::bare(std::vector<Eye> eyes, const Bounds& bounds, double pixels, double unit) {
  SoftLight grid(std::move(eyes), pixels);
  // Cells cover more pixels where a level would hold too many of them, as for a large picture or a long
  // flight.
  while (!grid.lay_levels(bounds, unit)) grid.pixels_ *= 1.1;
  return grid;
}

SoftLight::SoftLight(std::vector<Eye> eyes, const Bounds& bounds, double pixels, double unit)
    : SoftLight(bare(std::move(eyes), bounds, pixels, unit)) {
  for (Level& level : levels_) {
    level.center = (Vec3(level.low) + 0.5f * Vec3(level.size)) * level.cell;
    level.half = 0.5f * Vec3(level.size) * level.cell;
    for (auto* sums : {&level.area, &level.thin, &level.body}) sums->assign(level.count(), 0);
    for (auto& sums : level.color) sums.assign(level.count(), 0);
    level.facings.assign(level.count(), 0);
  }
}

SoftLight::Size SoftLight::estimate_size(std::vector<Eye> eyes, const Bounds& bounds, double pixels,
                                         double unit, const std::function<float(Vec2)>& height, float tall,
                                         std::span<const Eye> seen_by) {
  constexpr double kAsked = 5000;  // columns of a grid, about
  SoftLight grid = bare(std::move(eyes), bounds, pixels, unit);
  Size size;
  for (std::size_t k = 0; k < grid.levels_.size(); ++k) {
    const Level& level = grid.levels_[k];
    size.cells += static_cast<double>(level.count());
    int step = static_cast<int>(std::ceil(std::sqrt(double(level.size.x) * level.size.z / kAsked)));
    for (int z = step / 2; z < level.size.z; z += step)
      for (int x = step / 2; x < level.size.x; x += step) {
        Vec3 at = level.middle({x, 0, z});
        at.y = height({at.x, at.z});
        if (!grid.wanted(k, at, seen_by)) continue;
        size.land += double(step) * step;
        size.cover += double(step) * step * tall / level.cell;
      }
  }
  return size;
}

bool SoftLight::lay_levels(const Bounds& bounds, double unit) {
  levels_.clear();
  double pixel = 1e30, least = 1e30;
  for (const Eye& eye : eyes_) {
    pixel = std::min(pixel, eye.pixel);
    least = std::min<double>(least, glm::distance(eye.at, glm::clamp(eye.at, bounds.low, bounds.high)));
  }
  double cell = std::exp2(std::floor(std::log2(std::max(least, kNearest) * pixel * pixels_ / unit))) * unit;
  for (;; cell *= 2) {
    // A level reaches as far as cells of its size are wanted, round all eyes.
    auto reach = static_cast<float>(2 * cell / (pixel * pixels_) + 3 * cell);
    Bounds box;
    for (const Eye& eye : eyes_) box.extend(eye.at, reach);
    bool whole = glm::all(glm::lessThanEqual(box.low, bounds.low)) &&
                 glm::all(glm::greaterThanEqual(box.high, bounds.high));
    box.low = glm::max(box.low, bounds.low);
    box.high = glm::min(box.high, bounds.high);
    if (glm::any(glm::greaterThanEqual(box.low, box.high))) continue;
    Level level;
    level.cell = static_cast<float>(cell);
    level.low = glm::ivec3(glm::floor(box.low / level.cell)) - 2;
    level.size = glm::ivec3(glm::floor(box.high / level.cell)) + 3 - level.low;
    if (level.count() > kMostCells) return false;
    levels_.push_back(std::move(level));
    if (whole && levels_.size() > kUnseen) return true;
  }
}

std::size_t SoftLight::level_for(double cell) const {
  std::size_t k = 0;
  while (k + 1 < levels_.size() && levels_[k + 1].cell <= cell) ++k;
  return k;
}

float SoftLight::cell_at(Vec3 at, double within) const {
  return levels_[level_for(fit(away(at) - within))].cell;
}

void SoftLight::add(Vec3 at, float area, Vec3 albedo, Facing facing, float bulk, float wide,
                    CellSizes cells) {
  for (Level& level : levels_) {
    if (level.cell < cells.least || level.cell >= cells.most) continue;
    if (glm::any(glm::greaterThan(glm::abs(at - level.center), level.half + 0.5f * wide))) continue;
    // A thing that is wider than cells is added to all cells that it fills.
    int n = wide < 1.5f * level.cell ? 1 : wide < 2.5f * level.cell ? 2 : 3;
    if (n == 1) {
      level.add(at, area, albedo, facing, bulk);
      continue;
    }
    float step = wide / static_cast<float>(n), part = area / static_cast<float>(n * n * n);
    for (int k = 0; k < n * n * n; ++k)
      level.add(at + step * (Vec3(k % n, k / n % n, k / n / n) - 0.5f * static_cast<float>(n - 1)), part,
                albedo, facing, bulk);
  }
}

void SoftLight::Level::add(Vec3 at, float share, Vec3 albedo, Facing facing, float bulk) {
  std::size_t i = 0;
  if (!index(at, i)) return;
  float quanta = share / (cell * cell) * kQuanta;
  auto sum = static_cast<std::uint32_t>(std::min(quanta, 1e6f) + 0.5f);
  if (sum == 0) return;
  sum_up(area[i], sum);
  if (bulk > 0) sum_up(bulk < cell ? thin[i] : body[i], sum);
  for (int c = 0; c < 3; ++c)
    sum_up(color[c][i], static_cast<std::uint32_t>(static_cast<float>(sum) * albedo[c] + 0.5f));
  face(facings[i], facing);
}

void SoftLight::want(Vec3 at, CellSizes cells) {
  for (Level& level : levels_)
    if (std::size_t i = 0; level.cell >= cells.least && level.cell < cells.most && level.index(at, i))
      face(level.facings[i], kAllFacings);
}

void SoftLight::add_land(const std::function<float(Vec2)>& height, Vec3 albedo, float tall, float area) {
  for (Level& level : levels_) {
    // With a rim of one, for the slopes.
    auto wide = static_cast<std::size_t>(level.size.x) + 2;
    std::vector<float> heights(wide * (static_cast<std::size_t>(level.size.z) + 2));
    parallel_for(heights.size() / wide, [&](std::size_t row) {
      for (std::size_t x = 0; x < wide; ++x) {
        Vec3 at = level.middle({static_cast<int>(x) - 1, 0, static_cast<int>(row) - 1});
        heights[row * wide + x] = height({at.x, at.z});
      }
    });
    parallel_for(static_cast<std::size_t>(level.size.z), [&](std::size_t row) {
      for (int x = 0; x < level.size.x; ++x) {
        const float* here = &heights[(row + 1) * wide + static_cast<std::size_t>(x) + 1];
        float h = *here, d = level.cell;
        Vec3 normal = glm::normalize(Vec3(here[-1] - here[1], 2 * d, *(here - wide) - here[wide]));
        // Solid up to the nearest face of a cell, so that level land throws no shadow on itself. The surface
        // lies in `top`, which is above that or the highest that is solid.
        int solid = static_cast<int>(std::floor(h / d - 0.5f)) - level.low.y;
        int top = static_cast<int>(std::floor(h / d)) - level.low.y;
        int over = tall > 0 ? static_cast<int>(std::floor((h + tall) / d)) - level.low.y : top;
        for (int y = std::max(0, solid - 2); y <= std::min(over, level.size.y - 1); ++y) {
          std::size_t i = level.index({x, y, static_cast<int>(row)});
          float here_area = y <= solid ? 2 : tall > 0 ? area * std::min(1.0f, d / tall) : 0;
          auto sum = static_cast<std::uint32_t>(here_area * kQuanta);
          level.area[i] += sum;
          if (y <= solid) level.body[i] += sum;
          for (int c = 0; c < 3; ++c)
            level.color[c][i] += static_cast<std::uint32_t>(static_cast<float>(sum) * albedo[c]);
          Facing facings = y <= solid ? kLand : 0;
          if (y >= solid && y <= top) facings |= facing(normal);
          if (y >= top && tall > 0) facings |= kAllFacings;
          level.facings[i] = static_cast<Facing>(level.facings[i] | facings);
        }
      }
    });
  }
}

Vec2 SoftLight::merged(std::size_t k, glm::ivec3 of) const {
  const Level& fine = levels_[k - 1];
  glm::ivec3 first = 2 * (levels_[k].low + of) - fine.low;
  if (glm::any(glm::lessThan(first, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(first + 1, fine.size)))
    return Vec2(1e30f);
  float upright = 0, level = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (int c = 0; c < 8; ++c) {
      if (c >> axis & 1) continue;
      float depth = 0;
      for (int both : {c, c | 1 << axis})
        depth += fine.loose(fine.index(first + glm::ivec3(both & 1, both >> 1 & 1, both >> 2)), axis == 1);
      (axis == 1 ? upright : level) += std::exp(-depth);
    }
  }
  return -glm::log(glm::max(Vec2(level / 8, upright / 4), Vec2(1e-6f)));
}

void SoftLight::set_depths() {
  for (std::size_t k = 0; k < levels_.size(); ++k) {
    Level& level = levels_[k];
    parallel_for(static_cast<std::size_t>(level.size.y), [&](std::size_t y) {
      std::size_t i = y * static_cast<std::size_t>(level.size.z) * static_cast<std::size_t>(level.size.x);
      for (int z = 0; z < level.size.z; ++z) {
        for (int x = 0; x < level.size.x; ++x, ++i) {
          auto all = static_cast<float>(level.area[i]) / kQuanta,
               thin = static_cast<float>(level.thin[i]) / kQuanta,
               body = static_cast<float>(level.body[i]) / kQuanta;
          // Leaves that lie every way cover half of their area, round bodies a quarter; one as wide as the
          // cell goes through it as a wall.
          Vec2 loose(0.25f * thin + 0.5f * std::max(0.0f, all - thin - body));
          glm::ivec3 of(x, static_cast<int>(y), z);
          if (k > 0 && loose.x > 0 && level_for(fit(away(level.middle(of)))) < k)
            loose = glm::min(loose, merged(k, of));
          level.area[i] = std::bit_cast<std::uint32_t>(loose.x);
          level.thin[i] = std::bit_cast<std::uint32_t>(loose.y);
          level.body[i] = std::bit_cast<std::uint32_t>(0.25f * body * std::min(1 + 12 * body * body, 30.0f));
          for (auto& color : level.color)
            color[i] =
                std::bit_cast<std::uint32_t>(all > 0 ? static_cast<float>(color[i]) / (all * kQuanta) : 0.0f);
        }
      }
    });
  }
}

}  // namespace frond
