#include "grove/shoots.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>

#include "core/parallel.h"

namespace frond {

namespace {

constexpr std::size_t kGrain = 4096;   // metamers that one thread takes at a time
constexpr float kFaintSlope = 0.03f;   // 1/m: shadow slopes weaker than this turn shoots little
constexpr float kLongest = 1.5f;       // of an internode, in units of an ordinary one
constexpr float kAboveGround = 0.25f;  // metres that hanging shoots keep
constexpr float kTrailing = 0.7f;      // metres under which they cease to grow
constexpr float kStored = 3;           // internodes that wood below a cut has stored for a bud
constexpr float kWakingLight = 0.1f;   // in which such a bud sprouts
constexpr float kLater = 0.5f;         // light and tropism turn the rest of a shoot less than its start

struct Shoot {
  std::uint32_t from;
  bool leader;
  int count;
  float length;
  Vec3 to_light{0};
};

template <class Body>
void for_grains(std::size_t n, const Body& body) {
  parallel_for((n + kGrain - 1) / kGrain,
               [&](std::size_t g) { body(g * kGrain, std::min(n, (g + 1) * kGrain)); });
}

Vec3 normalized(Vec3 v, Vec3 otherwise) {
  float length = glm::length(v);
  return length > 1e-6f ? v / length : otherwise;
}

/// `v` turned about a unit axis.
Vec3 turned(Vec3 v, Vec3 axis, double angle) {
  assert(std::abs(glm::length(axis) - 1) < 1e-3f);
  auto c = static_cast<float>(std::cos(angle)), s = static_cast<float>(std::sin(angle));
  return v * c + glm::cross(axis, v) * s + axis * (glm::dot(axis, v) * (1 - c));
}

/// `side` made square to a unit direction.
Vec3 squared(Vec3 side, Vec3 direction) {
  Vec3 other = std::abs(direction.x) < 0.7f ? Vec3(1, 0, 0) : Vec3(0, 0, 1);
  return normalized(side - direction * glm::dot(side, direction),
                    glm::normalize(glm::cross(direction, other)));
}

Vec3 random_vector(Seed seed) {
  return Vec3(seed.child(1).range(-1, 1), seed.child(2).range(-1, 1), seed.child(3).range(-1, 1));
}

/// Whether a metamer hangs so low that nothing can grow on from it.
bool trails(const Metamers& t, std::size_t i) {
  return i > 0 && t.tip[i].y - t.tip[0].y < kTrailing && t.heading(i).y < -0.25f;
}

/// Near its full height a tree lifts water no further (Ryan and Yoder 1997).
float reach(const Metamers& t, const Species& s, std::size_t i) {
  Vec3 offset = t.tip[i] - t.tip[0];
  double out = s.dome * std::sqrt(offset.x * offset.x + offset.z * offset.z);
  double far = std::sqrt(offset.y * offset.y + out * out) / std::max(s.height, 1e-6);
  return static_cast<float>(1 - smooth_step(0.72, 1.0, far));
}

/// The way that a guide leads from a place: to the point `ahead` of the nearest one; none past its end.
std::optional<Vec3> led(std::span<const Vec3> guide, Vec3 place, float ahead) {
  float nearest = std::numeric_limits<float>::max();
  std::size_t at = 0;
  Vec3 on(0);
  for (std::size_t i = 1; i < guide.size(); ++i) {
    Vec3 way = guide[i] - guide[i - 1];
    float length2 = glm::dot(way, way);
    if (length2 <= 0) continue;
    float share = glm::dot(place - guide[i - 1], way) / length2;
    Vec3 point = guide[i - 1] + std::clamp(share, 0.0f, 1.0f) * way;
    // Past the end it is free.
    bool past = i + 1 == guide.size() && share >= 1;
    if (float far = glm::distance(point, place); far < nearest) nearest = far, at = past ? 0 : i, on = point;
  }
  if (at == 0) return std::nullopt;
  for (; at + 1 < guide.size() && glm::distance(on, guide[at]) < ahead; ++at)
    ahead -= glm::distance(on, guide[at]), on = guide[at];
  Vec3 way = guide[at] - on;
  return normalized(on + normalized(way, Vec3(0)) * std::min(ahead, glm::length(way)) - place, Vec3(0, 1, 0));
}

std::vector<Shoot> sprouting(const Metamers& t, const Season& season) {
  const Species& s = season.species;
  std::vector<Shoot> shoots;
  for (std::size_t i = 0; i < t.size(); ++i) {
    if (t.has(i, Metamers::dead) || trails(t, i)) continue;
    for (bool leader : {true, false}) {
      if (!t.has(i, leader ? Metamers::leading : Metamers::bud)) continue;
      bool stem = leader && t.order[i] == 0;
      float v = (leader ? t.to_leader[i] : t.to_side[i]);
      // A stem that is led, even aslant, keeps the lead.
      if (stem && led(season.guide, t.tip[i], 1)) v = std::max(v, static_cast<float>(s.vigour));
      if (!leader && t.has(i, Metamers::woken) && t.light[i] > kWakingLight) v = std::max(v, kStored);
      if (v < 1) continue;
      v *= reach(t, s, i);
      if (v < 1) continue;
      int longest = stem || s.longest_branch_shoot == 0 ? s.longest_shoot : s.longest_branch_shoot;
      int count = std::min(static_cast<int>(v), longest);
      float stretch = std::min(v / static_cast<float>(count), kLongest);
      shoots.push_back(
          {static_cast<std::uint32_t>(i), leader, count, static_cast<float>(s.internode) * stretch});
    }
  }
  for_grains(shoots.size(), [&](std::size_t from, std::size_t to) {
    for (std::size_t k = from; k < to; ++k) {
      Vec3 slope = season.field.gradient(t.tip[shoots[k].from]);
      shoots[k].to_light = -slope / (glm::length(slope) + kFaintSlope);
    }
  });
  return shoots;
}

/// Where a shoot sets out, before light and tropism.
Vec3 own_direction(const Metamers& t, const Species& s, const Shoot& shoot, Vec3 heading, Seed seed) {
  if (shoot.leader) return heading;
  double angle = s.branching_angle + s.angle_jitter * seed.child(9).range(-1, 1);
  return heading * static_cast<float>(std::cos(angle)) +
         t.side[shoot.from] * static_cast<float>(std::sin(angle));
}

void add_shoot(Metamers& t, const Season& season, const Shoot& shoot, std::size_t at, std::uint32_t serial) {
  assert(shoot.from < at && shoot.count > 0 && at + static_cast<std::size_t>(shoot.count) <= t.size());
  assert(shoot.length > 0);
  const Species& s = season.species;
  std::size_t from = shoot.from;
  auto order = static_cast<std::uint8_t>(std::min<int>(t.order[from] + (shoot.leader ? 0 : 1), 255));
  Vec3 heading = t.heading(from);
  Vec3 direction = own_direction(t, s, shoot, heading, season.seed.child(serial));
  // The buds of a branch begin level, so that sprays whose buds stand opposite lie flat.
  Vec3 side = shoot.leader ? t.side[from] : squared(glm::cross(direction, Vec3(0, 1, 0)), direction);
  double lift = order == 0 ? s.tropism : s.branch_tropism - s.droop * (order - 1);
  Vec3 pull = shoot.to_light * static_cast<float>(s.light_pull) + Vec3(0, lift, 0);
  float level = order == 0 ? 1.0f : static_cast<float>(1 - s.spread);
  Vec3 place = t.tip[from];
  const bool anew = !shoot.leader && t.has(from, Metamers::spent);
  for (int k = 0; k < shoot.count; ++k) {
    std::size_t i = at + static_cast<std::size_t>(k);
    Seed own = season.seed.child(serial + static_cast<std::uint32_t>(k));
    Vec3 aim =
        direction + pull * (k == 0 ? 1.0f : kLater) + random_vector(own) * static_cast<float>(s.wander);
    aim.y *= level;
    direction = normalized(aim, direction);
    if (!season.guide.empty() && order == 0 && shoot.leader)
      if (auto way = led(season.guide, place, 2 * shoot.length)) direction = *way;
    if (place.y + direction.y * shoot.length < t.tip[0].y + kAboveGround && direction.y < 0)
      direction = normalized(Vec3(direction.x, 0.02f, direction.z), Vec3(1, 0, 0));
    double turn = order == 0 ? s.phyllotaxis : s.branch_phyllotaxis;
    side = squared(turned(side, direction, turn + 0.1 * own.child(4).range(-1, 1)), direction);
    place += direction * shoot.length * static_cast<float>(own.child(5).range(0.9, 1.1));
    bool last = k + 1 == shoot.count;
    bool sprouts = s.whorl == 0 || order > 0 || shoot.count - k <= s.whorl;
    t.tip[i] = place;
    t.side[i] = side;
    t.parent[i] = static_cast<std::int32_t>(k == 0 ? from : i - 1);
    t.serial[i] = serial + static_cast<std::uint32_t>(k);
    t.born[i] = static_cast<float>(season.year) + static_cast<float>(k + 1) / static_cast<float>(shoot.count);
    t.flags[i] = static_cast<std::uint8_t>((k == 0 && !shoot.leader ? Metamers::side_shoot : 0) |
                                           (k == 0 && anew ? Metamers::regrown : 0) |
                                           (last ? Metamers::leading : 0) | (sprouts ? Metamers::bud : 0));
    t.order[i] = order;
  }
  t.clear(from, shoot.leader ? Metamers::leading : Metamers::bud);
  if (!shoot.leader) t.clear(from, Metamers::woken);
}

}  // namespace

bool bears_leaves(const Metamers& t, const Species& s, std::size_t i, int year) {
  assert(i < t.size());
  if (i == 0 || t.has(i, Metamers::dead)) return false;
  return t.has(i, Metamers::leading) || static_cast<double>(year) - t.born[i] < s.leaf_years - 0.001;
}

void measure_light(Metamers& t, const Season& season, float own) {
  for_grains(t.size(), [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) {
      if (!t.has(i, Metamers::leading) && !t.has(i, Metamers::bud)) continue;
      float spared = bears_leaves(t, season.species, i, season.year) ? own : 0;
      t.light[i] = std::exp(-std::max(season.field.shadow(t.tip[i]) - spared, 0.0f));
    }
  });
}

std::size_t grow_shoots(Metamers& t, const Season& season, std::uint32_t& serial) {
  std::size_t first = t.size(), n = first;
  std::vector<Shoot> shoots = sprouting(t, season);
  for (const Shoot& shoot : shoots) n += static_cast<std::size_t>(shoot.count);
  t.resize(n);
  std::size_t at = first;
  for (const Shoot& shoot : shoots) {
    add_shoot(t, season, shoot, at, serial);
    at += static_cast<std::size_t>(shoot.count);
    serial += static_cast<std::uint32_t>(shoot.count);
  }
  assert(at == n && "the shoots fill what was made for them");
  // Buds that slept too long die.
  for (std::size_t i = 0; i < first; ++i)
    if (t.has(i, Metamers::bud) && !(t.has(i, Metamers::woken) && t.has(i, Metamers::spent)) &&
        static_cast<double>(season.year) - t.born[i] > season.species.bud_years)
      t.clear(i, Metamers::bud);
  return first;
}

}  // namespace frond
