#include "light/light.h"

#include <bit>
#include <cmath>

#include "core/parallel.h"

namespace frond {

namespace {

constexpr float kDark = 0.02f;   // of light: what is behind is left out
constexpr float kOpaque = 0.7f;  // optical depth across a cell from which on it is a body

constexpr Vec3 axis_of(int bit) {
  Vec3 axis(0);
  axis[bit / 2] = bit % 2 == 0 ? 1.0f : -1.0f;
  return axis;
}

/// Directions all over the sphere, evenly: a spiral of golden angles.
const std::vector<Vec3>& directions_all_round() {
  static const std::vector<Vec3> directions = [] {
    constexpr int kCount = 64;
    std::vector<Vec3> list;
    for (int i = 0; i < kCount; ++i) {
      double y = 1 - (2 * i + 1.0) / kCount, r = std::sqrt(1 - y * y), turn = kGoldenAngle * i;
      list.emplace_back(r * std::cos(turn), y, r * std::sin(turn));
    }
    return list;
  }();
  return directions;
}

Vec3 sky(const Ambience& ambience, Vec3 direction) {
  if (direction.y >= 0) return glm::mix(ambience.horizon, ambience.zenith, direction.y);
  return glm::mix(ambience.horizon, ambience.below, std::min(1.0f, -6 * direction.y));
}

}  // namespace

Eye eye_toward(Vec3 at, Vec3 toward, double broad, double tall, double pixel) {
  Vec3 ahead = glm::normalize(toward - at);
  Vec3 sky = sky_axis(ahead);
  return {at, ahead, glm::normalize(sky - ahead * glm::dot(sky, ahead)), broad, tall, pixel};
}

bool in_view(const Eye& eye, Vec3 at, double radius) {
  Vec3 offset = at - eye.at;
  double deep = glm::dot(offset, eye.ahead), high = std::abs(glm::dot(offset, eye.up)),
         aside = std::abs(glm::dot(offset, glm::cross(eye.ahead, eye.up)));
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

Vec3 SoftLight::arriving(std::size_t k, Vec3 at, Vec3 direction, float spread, const Ambience& ambience,
                         float& open) const {
  Vec3 sum(0), origin(0), ahead(0), size(0);
  float left = 1, upright = direction.y * direction.y;
  auto enter = [&] {  // the cells of a level
    const Level& level = levels_[k];
    origin = at / level.cell - Vec3(level.low);
    ahead = direction / level.cell;
    size = Vec3(level.size);
  };
  enter();
  // In the cell that the ray sets out from, leaves and twigs are in the way as far as the face of the cell.
  if (std::size_t i = 0; levels_[k].index(at, i)) {
    left = std::exp(-0.5f * levels_[k].loose(i, upright));
    sum = (1 - left) * levels_[k].radiance(i);
  }
  // Each part of the ray counts once, whatever the cells before it were.
  for (float t = 0.5f * levels_[k].cell; left > kDark; t += levels_[k].cell) {
    while (k + 1 < levels_.size() && levels_[k + 1].cell < spread * t) ++k, enter();
    auto middle = [&] { return origin + (t + 0.5f * levels_[k].cell) * ahead; };
    Vec3 p = middle();
    while (!(p.x >= 0 && p.y >= 0 && p.z >= 0 && p.x < size.x && p.y < size.y && p.z < size.z)) {
      if (++k == levels_.size()) break;
      enter();
      p = middle();
    }
    if (k == levels_.size()) break;
    const Level& level = levels_[k];
    std::size_t i = level.index(glm::ivec3(p));
    float depth = level.depth(i, upright);
    if (depth <= 0) continue;
    float through = std::exp(-depth);
    sum += left * (1 - through) * level.radiance(i);
    left *= through;
  }
  open = left > kDark ? left : 0;
  return sum + open * sky(ambience, direction);
}

void SoftLight::light(const Ambience& ambience) {
  set_depths();
  // Only how open the rays to sun and sky are is asked here, not what cells show; so their order does not
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
          bool flat = level.facings[i] & kLand;
          float sunny = 0, open = 0;
          arriving(k, at, ambience.sun, 0.15f, ambience, sunny);
          arriving(k, at, Vec3(0, 1, 0), 0.6f, ambience, open);
          Vec3 light = ambience.sunlight * (sunny * (flat ? std::max(0.0f, ambience.sun.y) : 0.35f)) +
                       (0.5f * ambience.zenith + 0.5f * ambience.horizon) * (open * (flat ? 1.0f : 0.6f));
          shown[i] = level.radiance(i) * light;
        }
      }
    });
    for (std::size_t i = 0; i < shown.size(); ++i)
      for (int c = 0; c < 3; ++c) level.color[c][i] = std::bit_cast<std::uint32_t>(shown[i][c]);
  }
}

void SoftLight::gather(std::size_t k, Vec3 at, Facing facing, const Ambience& ambience,
                       std::array<Vec3, 6>& sum) const {
  if (facing == 0) return;
  // A half of all directions, each weighted by how it faces: 32 of them have that sum.
  constexpr float kShare = 1.0f / 16;
  for (const Vec3& direction : directions_all_round()) {
    bool wanted = false;
    for (int axis = 0; axis < 6; ++axis)
      wanted = wanted || (facing & 1 << axis && glm::dot(direction, axis_of(axis)) > 0);
    if (!wanted) continue;
    float open = 0;
    Vec3 light = kShare * arriving(k, at, direction, 0.7f, ambience, open);
    for (int axis = 0; axis < 6; ++axis)
      if (facing & 1 << axis) sum[axis] += std::max(0.0f, glm::dot(direction, axis_of(axis))) * light;
  }
}

bool SoftLight::wanted(std::size_t k, Vec3 at, std::span<const Eye> seen_by) const {
  float cell = levels_[k].cell;
  double far = away(at), margin = 2.0 * cell;
  std::size_t from = level_for(fit(far - margin)), to = level_for(fit(std::max(far, kNearest) + margin));
  bool sure = false, maybe = false;  // whether it is in view
  for (const Eye& eye : seen_by) {
    maybe = maybe || in_view(eye, at, 3 * cell);
    sure = sure || in_view(eye, at, 1.6 * cell);
  }
  std::size_t top = levels_.size() - 1;
  bool fine = maybe && from <= k && k <= to;
  bool coarse = !sure && std::min(from + kUnseen, top) <= k && k <= std::min(to + kUnseen, top);
  return fine || coarse || (k == top && to >= k);
}

std::vector<Probe> SoftLight::probes_of(std::size_t k, const Ambience& ambience,
                                        std::span<const Eye> seen_by) const {
  const Level& level = levels_[k];
  std::vector<std::vector<Probe>> slabs(static_cast<std::size_t>(level.size.y));
  parallel_for(slabs.size(), [&](std::size_t slab) {
    int y = static_cast<int>(slab);
    auto row = static_cast<std::size_t>(level.size.x), plane = row * static_cast<std::size_t>(level.size.z);
    if (y == 0 || y + 1 == level.size.y) return;
    for (int z = 1; z + 1 < level.size.z; ++z) {
      for (int x = 1; x + 1 < level.size.x; ++x) {
        // Light is wanted where something stands, or stands next ahead, that looks the same way.
        std::size_t here = slab * plane + static_cast<std::size_t>(z) * row + static_cast<std::size_t>(x);
        Facing need = level.facings[here] & kAllFacings;
        const std::size_t step[] = {1, plane, row};
        for (int axis = 0; axis < 6; ++axis) {
          std::size_t ahead = axis % 2 == 0 ? here + step[axis / 2] : here - step[axis / 2];
          need = static_cast<Facing>(need | (level.facings[ahead] & 1 << axis));
        }
        if (need == 0) continue;
        Vec3 at = level.middle({x, y, z});
        if (!wanted(k, at, seen_by)) continue;
        // Within a body it is the light on its outside; of directions that are in the open, all rays serve
        // all.
        std::array<Vec3, 6> sum{};
        Facing in_open = 0;
        for (int axis = 0; axis < 6; ++axis) {
          if (!(need & 1 << axis)) continue;
          Vec3 normal = axis_of(axis), out = at;
          std::size_t i = 0;
          auto behind = [&](Vec3 there) {
            return level.index(there, i) && level.depth(i) > kOpaque && (level.facings[i] & 1 << axis);
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
          if (need & 1 << axis) slabs[slab].push_back({at, axis, level.cell, sum[axis]});
      }
    }
  });
  return joined(slabs);
}

std::vector<Probe> SoftLight::probes(const Ambience& ambience, std::span<const Eye> seen_by) {
  light(ambience);
  std::vector<std::vector<Probe>> lists;
  for (std::size_t k = 0; k < levels_.size(); ++k) lists.push_back(probes_of(k, ambience, seen_by));
  return joined(lists);
}

}  // namespace frond
