#include "light/light.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>

#include "core/parallel.h"

namespace frond {

namespace {

constexpr double kNearest = 0.3;  // metres from the eye from where on cells do not become smaller
constexpr float kQuanta = 4096;   // of fixed point, to a cell's face
constexpr Facing kSolid = 64;     // bit: something in the cell lets no light through
constexpr Facing kLand = 128;     // and that the land is in it
constexpr std::size_t kMostCells = 6'000'000;
constexpr int kUnseen = 2;       // levels that what no eye sees is coarser
constexpr float kDark = 0.02f;   // of light: what is behind is left out
constexpr float kOpaque = 0.7f;  // optical depth across a cell from which on it is a body

constexpr Vec3 axis_of(int bit) {
  Vec3 axis(0);
  axis[bit / 2] = bit % 2 == 0 ? 1.0f : -1.0f;
  return axis;
}

/// Directions all over the sphere, evenly: a spiral of golden angles.
const std::vector<Vec3>& ways_all_round() {
  static const std::vector<Vec3> ways = [] {
    constexpr int kCount = 64;
    std::vector<Vec3> list;
    for (int i = 0; i < kCount; ++i) {
      double y = 1 - (2 * i + 1.0) / kCount, r = std::sqrt(1 - y * y), turn = kGoldenAngle * i;
      list.emplace_back(r * std::cos(turn), y, r * std::sin(turn));
    }
    return list;
  }();
  return ways;
}

void sum_up(std::uint32_t& to, std::uint32_t more) {
  std::atomic_ref<std::uint32_t>(to).fetch_add(more, std::memory_order_relaxed);
}

Vec3 sky(const Ambience& ambience, Vec3 way) {
  if (way.y >= 0) return glm::mix(ambience.horizon, ambience.zenith, way.y);
  return glm::mix(ambience.horizon, ambience.below, std::min(1.0f, -6 * way.y));
}

double away(std::span<const Eye> eyes, Vec3 at) {
  double least = 1e30;
  for (const Eye& eye : eyes) least = std::min<double>(least, glm::distance(eye.at, at));
  return least;
}

}  // namespace

Eye eye_toward(Vec3 at, Vec3 toward, double broad, double tall, double pixel) {
  Vec3 ahead = glm::normalize(toward - at);
  Vec3 sky = std::abs(ahead.y) > 0.999f ? Vec3(0, 0, -1) : Vec3(0, 1, 0);
  return {at, ahead, glm::normalize(sky - ahead * glm::dot(sky, ahead)), broad, tall, pixel};
}

bool in_view(const Eye& eye, Vec3 at, double radius) {
  Vec3 way = at - eye.at;
  double deep = glm::dot(way, eye.ahead), high = std::abs(glm::dot(way, eye.up)),
         aside = std::abs(glm::dot(way, glm::cross(eye.ahead, eye.up)));
  // How far outside of each of the planes that bound the view.
  return deep > -radius && aside - deep * eye.broad < radius * std::hypot(1, eye.broad) &&
         high - deep * eye.tall < radius * std::hypot(1, eye.tall);
}

Facing facing(Vec3 normal) {
  Facing bits = 0;
  for (int axis = 0; axis < 6; ++axis)
    if (glm::dot(axis_of(axis), normal) > 0.3f) bits = static_cast<Facing>(bits | 1 << axis);
  return bits;
}

std::size_t SoftLight::Level::index(glm::ivec3 i) const {
  return (static_cast<std::size_t>(i.y) * static_cast<std::size_t>(size.z) + static_cast<std::size_t>(i.z)) *
             static_cast<std::size_t>(size.x) +
         static_cast<std::size_t>(i.x);
}

bool SoftLight::Level::index(Vec3 at, std::size_t& found) const {
  Vec3 p = at / cell - Vec3(low);
  if (!(p.x >= 0 && p.y >= 0 && p.z >= 0)) return false;
  auto i = glm::ivec3(p);
  if (i.x >= size.x || i.y >= size.y || i.z >= size.z) return false;
  found = index(i);
  return true;
}

Vec3 SoftLight::Level::middle(glm::ivec3 of) const { return (Vec3(low + of) + 0.5f) * cell; }

float SoftLight::Level::depth(std::size_t i) const { return std::bit_cast<float>(area[i]); }

Vec3 SoftLight::Level::radiance(std::size_t i) const {
  return {std::bit_cast<float>(color[0][i]), std::bit_cast<float>(color[1][i]),
          std::bit_cast<float>(color[2][i])};
}

SoftLight::SoftLight(std::vector<Eye> eyes, const Bounds& bounds, double pixels, double unit)
    : eyes_(std::move(eyes)), pixels_(pixels) {
  double pixel = 1e30;
  for (const Eye& eye : eyes_) pixel = std::min(pixel, eye.pixel);
  double least = 1e30;
  for (const Eye& eye : eyes_)
    least = std::min<double>(least, glm::distance(eye.at, glm::clamp(eye.at, bounds.low, bounds.high)));
  double cell = std::exp2(std::floor(std::log2(std::max(least, kNearest) * pixel * pixels / unit))) * unit;
  for (;; cell *= 2) {
    // As far as cells of that size are wanted, round all eyes.
    auto reach = static_cast<float>(2 * cell / (pixel * pixels) + 3 * cell);
    Bounds box;
    for (const Eye& eye : eyes_) box.take(eye.at, reach);
    bool whole = glm::all(glm::lessThanEqual(box.low, bounds.low)) &&
                 glm::all(glm::greaterThanEqual(box.high, bounds.high));
    box.low = glm::max(box.low, bounds.low);
    box.high = glm::min(box.high, bounds.high);
    if (glm::any(glm::greaterThanEqual(box.low, box.high))) continue;
    Level level;
    level.cell = static_cast<float>(cell);
    level.low = glm::ivec3(glm::floor(box.low / level.cell)) - 2;
    level.size = glm::ivec3(glm::floor(box.high / level.cell)) + 3 - level.low;
    std::size_t cells = static_cast<std::size_t>(level.size.x) * static_cast<std::size_t>(level.size.y) *
                        static_cast<std::size_t>(level.size.z);
    if (cells > kMostCells) continue;
    level.area.assign(cells, 0);
    for (auto& sums : level.color) sums.assign(cells, 0);
    level.ways.assign(cells, 0);
    levels_.push_back(std::move(level));
    if (whole && levels_.size() > kUnseen) break;
  }
}

std::size_t SoftLight::level_for(double cell) const {
  std::size_t k = 0;
  while (k + 1 < levels_.size() && levels_[k + 1].cell <= cell) ++k;
  return k;
}

float SoftLight::cell_at(Vec3 at) const {
  return levels_[level_for(std::max(away(eyes_, at), kNearest) * eyes_[0].pixel * pixels_)].cell;
}

void SoftLight::add(Vec3 at, float area, Vec3 albedo, Facing facing, bool solid) {
  std::size_t i = 0;
  for (Level& level : levels_) {
    if (!level.index(at, i)) continue;
    float quanta = area / (level.cell * level.cell) * kQuanta;
    auto sum = static_cast<std::uint32_t>(std::min(quanta, 1e6f) + 0.5f);
    if (sum == 0) continue;
    sum_up(level.area[i], sum);
    for (int c = 0; c < 3; ++c)
      sum_up(level.color[static_cast<std::size_t>(c)][i],
             static_cast<std::uint32_t>(static_cast<float>(sum) * albedo[c] + 0.5f));
    std::atomic_ref<Facing>(level.ways[i])
        .fetch_or(static_cast<Facing>(facing | (solid ? kSolid : 0)), std::memory_order_relaxed);
  }
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
          for (int c = 0; c < 3; ++c)
            level.color[static_cast<std::size_t>(c)][i] +=
                static_cast<std::uint32_t>(static_cast<float>(sum) * albedo[c]);
          Facing ways = y <= solid ? kSolid | kLand : 0;
          if (y >= solid && y <= top) ways |= facing(normal);
          if (y >= top && tall > 0) ways |= kAllWays;
          level.ways[i] = static_cast<Facing>(level.ways[i] | ways);
        }
      }
    });
  }
}

Vec3 SoftLight::arriving(std::size_t k, Vec3 at, Vec3 way, float from, float spread, const Ambience& ambience,
                         float& open) const {
  Vec3 sum(0), origin(0), ahead(0), size(0);
  float left = 1;
  auto enter = [&] {  // the cells of a level
    const Level& level = levels_[k];
    origin = at / level.cell - Vec3(level.low);
    ahead = way / level.cell;
    size = Vec3(level.size);
  };
  enter();
  for (float t = from; left > kDark; t += levels_[k].cell) {
    while (k + 1 < levels_.size() && levels_[k + 1].cell < spread * t) ++k, enter();
    Vec3 p = origin + t * ahead;
    while (!(p.x >= 0 && p.y >= 0 && p.z >= 0 && p.x < size.x && p.y < size.y && p.z < size.z)) {
      if (++k == levels_.size()) break;
      enter();
      p = origin + t * ahead;
    }
    if (k == levels_.size()) break;
    const Level& level = levels_[k];
    std::size_t i = level.index(glm::ivec3(p));
    float depth = level.depth(i);
    if (depth <= 0) continue;
    float through = std::exp(-depth);
    sum += left * (1 - through) * level.radiance(i);
    left *= through;
  }
  open = left > kDark ? left : 0;
  return sum + open * sky(ambience, way);
}

void SoftLight::light(const Ambience& ambience) {
  for (Level& level : levels_) {
    parallel_for(static_cast<std::size_t>(level.size.y), [&](std::size_t slab) {
      std::size_t per = level.area.size() / static_cast<std::size_t>(level.size.y);
      for (std::size_t i = slab * per; i < (slab + 1) * per; ++i) {
        auto sum = static_cast<float>(level.area[i]);
        // Leaves that lie every way cover half of their area, round bodies a quarter; a wall that goes
        // through the cell all of it.
        float a = sum / kQuanta;
        level.area[i] = std::bit_cast<std::uint32_t>(
            level.ways[i] & kSolid ? 0.25f * a * std::min(1 + 12 * a * a, 30.0f) : 0.5f * a);
        for (auto& color : level.color)
          color[i] = std::bit_cast<std::uint32_t>(sum > 0 ? static_cast<float>(color[i]) / sum : 0.0f);
      }
    });
  }
  // Only how open the ways to sun and sky are is asked here, not what cells show; so their order is of no
  // matter.
  for (std::size_t k = 0; k < levels_.size(); ++k) {
    Level& level = levels_[k];
    std::vector<Vec3> shown(level.area.size(), Vec3(0));
    parallel_for(static_cast<std::size_t>(level.size.y), [&](std::size_t y) {
      std::size_t i = y * static_cast<std::size_t>(level.size.z) * static_cast<std::size_t>(level.size.x);
      for (int z = 0; z < level.size.z; ++z) {
        for (int x = 0; x < level.size.x; ++x, ++i) {
          if (level.depth(i) <= 0) continue;
          Vec3 at = level.middle({x, static_cast<int>(y), z});
          bool flat = level.ways[i] & kLand;
          float sunny = 0, open = 0;
          arriving(k, at, ambience.sun, 1.2f * level.cell, 0.15f, ambience, sunny);
          arriving(k, at, Vec3(0, 1, 0), 1.2f * level.cell, 0.6f, ambience, open);
          Vec3 light = ambience.sunlight * (sunny * (flat ? std::max(0.0f, ambience.sun.y) : 0.35f)) +
                       (0.5f * ambience.zenith + 0.5f * ambience.horizon) * (0.2f + 0.8f * open) *
                           (flat ? 1.0f : 0.6f);
          shown[i] = level.radiance(i) * light;
        }
      }
    });
    for (std::size_t i = 0; i < shown.size(); ++i)
      for (int c = 0; c < 3; ++c)
        level.color[static_cast<std::size_t>(c)][i] = std::bit_cast<std::uint32_t>(shown[i][c]);
  }
}

void SoftLight::gather(std::size_t k, Vec3 at, Facing facing, const Ambience& ambience,
                       std::array<Vec3, 6>& sum) const {
  if (facing == 0) return;
  // A half of all directions, each weighted by how it faces: 32 of them have that sum.
  constexpr float kShare = 1.0f / 16;
  for (const Vec3& way : ways_all_round()) {
    bool wanted = false;
    for (int axis = 0; axis < 6; ++axis)
      wanted = wanted || (facing & 1 << axis && glm::dot(way, axis_of(axis)) > 0);
    if (!wanted) continue;
    float open = 0;
    Vec3 light = kShare * arriving(k, at, way, 0.6f * levels_[k].cell, 0.7f, ambience, open);
    for (int axis = 0; axis < 6; ++axis)
      if (facing & 1 << axis)
        sum[static_cast<std::size_t>(axis)] += std::max(0.0f, glm::dot(way, axis_of(axis))) * light;
  }
}

std::vector<Probe> SoftLight::probes_of(std::size_t k, const Ambience& ambience,
                                        std::span<const Eye> seen_by) const {
  const Level& level = levels_[k];
  bool last = k + 1 == levels_.size();
  // Whether cells of this level are wanted at a place: its own, or the next ones where what stands there has
  // another.
  auto wanted = [&](Vec3 at) {
    double far = away(eyes_, at), margin = 2.0 * level.cell, scale = eyes_[0].pixel * pixels_;
    std::size_t from = level_for(std::max(far - margin, kNearest) * scale),
                to = level_for((std::max(far, kNearest) + margin) * scale);
    bool sure = false, maybe = false;  // whether it is in view
    for (const Eye& eye : seen_by) {
      maybe = maybe || in_view(eye, at, 3 * level.cell);
      sure = sure || in_view(eye, at, 0);
    }
    std::size_t top = levels_.size() - 1;
    bool fine = maybe && from <= k && k <= to;
    bool coarse = !sure && std::min(from + kUnseen, top) <= k && k <= std::min(to + kUnseen, top);
    return fine || coarse || (last && to >= k);
  };
  std::vector<std::vector<Probe>> slabs(static_cast<std::size_t>(level.size.y));
  parallel_for(slabs.size(), [&](std::size_t slab) {
    int y = static_cast<int>(slab);
    auto row = static_cast<std::size_t>(level.size.x), plane = row * static_cast<std::size_t>(level.size.z);
    if (y == 0 || y + 1 == level.size.y) return;
    for (int z = 1; z + 1 < level.size.z; ++z) {
      for (int x = 1; x + 1 < level.size.x; ++x) {
        // Light is wanted where something stands, or stands next ahead, that looks the same way.
        std::size_t here = slab * plane + static_cast<std::size_t>(z) * row + static_cast<std::size_t>(x);
        Facing need = level.ways[here] & kAllWays;
        const std::size_t step[] = {1, plane, row};
        for (int axis = 0; axis < 6; ++axis) {
          std::size_t ahead = axis % 2 == 0 ? here + step[axis / 2] : here - step[axis / 2];
          need = static_cast<Facing>(need | (level.ways[ahead] & 1 << axis));
        }
        if (need == 0) continue;
        Vec3 at = level.middle({x, y, z});
        if (!wanted(at)) continue;
        // Within a body it is the light on its outside; of directions that are in the open, all rays serve
        // all.
        std::array<Vec3, 6> sum{};
        Facing in_open = 0;
        for (int axis = 0; axis < 6; ++axis) {
          if (!(need & 1 << axis)) continue;
          Vec3 normal = axis_of(axis), out = at;
          std::size_t i = 0;
          auto behind = [&](Vec3 there) {
            return level.index(there, i) && level.depth(i) > kOpaque && (level.ways[i] & 1 << axis);
          };
          if (!behind(out) && behind(out + normal * level.cell)) out += normal * level.cell;
          for (int steps = 0; steps < 3 && behind(out); ++steps) out += normal * level.cell;
          if (out == at)
            in_open = static_cast<Facing>(in_open | 1 << axis);
          else
            gather(k, out, static_cast<Facing>(1 << axis), ambience, sum);
        }
        gather(k, at, in_open, ambience, sum);
        for (int axis = 0; axis < 6; ++axis)
          if (need & 1 << axis)
            slabs[slab].push_back({at, axis, level.cell, sum[static_cast<std::size_t>(axis)]});
      }
    }
  });
  std::vector<Probe> list;
  for (const auto& part : slabs) list.insert(list.end(), part.begin(), part.end());
  return list;
}

std::vector<Probe> SoftLight::probes(const Ambience& ambience, std::span<const Eye> seen_by) {
  light(ambience);
  std::vector<Probe> list;
  for (std::size_t k = 0; k < levels_.size(); ++k) {
    std::vector<Probe> more = probes_of(k, ambience, seen_by);
    list.insert(list.end(), more.begin(), more.end());
  }
  return list;
}

}  // namespace frond
