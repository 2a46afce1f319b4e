#include "organisms/ivy/ivy_rest.h"

#include <algorithm>
#include <utility>

namespace frond {

namespace {

constexpr double kClear = 0.03;   // units that a leaf keeps off where it had to be turned
constexpr double kDeepest = 0.4;  // units that it is moved at once
constexpr int kRounds = 8;

/// A feeler that is too near: its offset from the foot, and how far to move it in which direction, in units.
struct Touch {
  DVec3 arm, direction;
  double need;
};

/// A ball in which nothing is.
struct Free {
  Vec3 middle;
  float radius;
};

/// Whether a leaf that touches no skin is within a body where that overlaps another.
bool swallowed(const Support& under, std::span<const Free> free) {
  for (std::size_t i = 0; i < free.size(); ++i) {
    // Balls that overlap are on the same side of everything.
    bool known = std::ranges::any_of(free.first(i), [&](const Free& other) {
      Vec3 apart = free[i].middle - other.middle;
      float both = 0.99f * (free[i].radius + other.radius);
      return glm::dot(apart, apart) < both * both;
    });
    if (!known && under.host.inside(DVec3(free[i].middle))) return true;
  }
  return false;
}

/// How a leaf touches what is under it; empty where it lies free.
void touches_of(const Support& under, std::span<const Vec3> feelers, float size, const Rest& rest,
                std::vector<Free>& free, std::vector<Touch>& touches) {
  free.clear();
  touches.clear();
  double deepest = kClear;
  std::uint32_t likely = TriangleSurface::kNoTriangle;
  auto feel = [&](const Vec3& at, double clear, const DVec3& direction) {
    clear /= size;
    deepest = std::min(deepest, clear);
    if (clear < kClear)
      touches.push_back(
          {DVec3(at - rest.foot) / double(size), direction, std::min(kClear - clear, kDeepest)});
  };
  for (const Vec3& feeler : feelers) {
    Vec3 at = rest.foot + rest.turn * (feeler * size);
    if (under.ground)
      if (double height = at.y - under.ground(at.x, at.z); height < kClear * size)
        feel(at, height, DVec3(0, 1, 0));
    if (std::ranges::any_of(free, [&](const Free& ball) {
          Vec3 apart = at - ball.middle;
          return glm::dot(apart, apart) < ball.radius * ball.radius;
        }))
      continue;
    std::optional<Contact> near =
        under.host.closest(DVec3(at), std::numeric_limits<double>::infinity(), likely);
    if (!near) continue;
    likely = near->triangle;
    // Slivers of a rough mesh may mislead the sign; its winding does not.
    bool inside = near->inside && (!under.host.closed() || under.host.inside(DVec3(at)));
    double clear = inside ? -near->distance : near->distance;
    feel(at, clear, near->inside == inside ? near->normal : -near->normal);
    if (float room = static_cast<float>(clear - kClear * size); room > 0) free.push_back({at, room});
  }
  if (deepest >= 0) touches.clear();
}

/// Where edges of a leaf whose points lie free go through the host: what is thin or sharp there fits between
/// the points.
void cuts_of(const Support& under, const Feelers& feelers, float size, const Rest& rest,
             std::span<const Free> free, std::vector<Touch>& touches) {
  auto at = [&](const Vec3& p) { return rest.foot + rest.turn * (p * size); };
  auto within = [](const Free& ball, const Vec3& p) {
    Vec3 apart = p - ball.middle;
    return glm::dot(apart, apart) < ball.radius * ball.radius;
  };
  for (const auto& [from, to] : feelers.edges) {
    Vec3 a = at(from), b = at(to);
    if (std::ranges::any_of(free, [&](const Free& ball) { return within(ball, a) && within(ball, b); }))
      continue;
    std::optional<Crossing> cut = under.host.crossing(DVec3(a), DVec3(b));
    if (!cut) continue;
    DVec3 along = DVec3(b) - DVec3(a);
    double rises = glm::dot(along, cut->normal);
    // The end that is behind the triangle is lifted out of it.
    double depth = rises < 0 ? -rises * (1 - cut->share) : rises * cut->share;
    touches.push_back({DVec3((rises < 0 ? b : a) - rest.foot) / double(size), cut->normal,
                       std::min(depth / size + kClear, kDeepest)});
  }
}

}  // namespace

Feelers feelers_of(const Surface& surface, float apart) {
  Feelers made;
  std::vector<Vec3>& feelers = made.points;
  auto add = [&](const Vec3& p) {
    for (const Vec3& other : feelers)
      if (glm::distance(p, other) < apart) return;
    feelers.push_back(p);
  };
  auto blade = [&](std::uint32_t i) { return surface.uv[i].x <= 1; };
  // Corners first: what sticks out is felt exactly.
  for (std::uint32_t i = 0; i < surface.position.size(); ++i)
    if (blade(i)) add(surface.position[i]);
  for (auto [a, b, c] : surface.triangle) {
    if (!blade(a)) continue;
    Vec3 p = surface.position[a], q = surface.position[b], r = surface.position[c];
    int cuts = 1 + static_cast<int>(
                       std::max({glm::distance(p, q), glm::distance(q, r), glm::distance(r, p)}) / apart);
    for (int i = 0; i <= cuts; ++i)
      for (int k = 0; i + k <= cuts; ++k)
        add((p * float(i) + q * float(k) + r * float(cuts - i - k)) / float(cuts));
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (auto [a, b, c] : surface.triangle)
    if (blade(a))
      for (auto [from, to] : {std::pair(a, b), {b, c}, {c, a}})
        edges.emplace_back(std::min(from, to), std::max(from, to));
  std::ranges::sort(edges);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  for (auto [from, to] : edges) made.edges.push_back({surface.position[from], surface.position[to]});
  return made;
}

bool lie_on(const Support& under, const Feelers& feelers, float size, float slide, Vec3 out, Rest& rest) {
  // What a turn (radians) and a slide (units) count in the least squares, beside units that are too near.
  constexpr double kTurnCosts = 0.02, kSlideCosts = 0.1, kNoSlide = 1e6;
  constexpr double kFarther = 1.15;  // than needed, so that few rounds suffice
  constexpr double kMostTurn = 0.6;  // radians at once
  std::vector<Free> free;
  std::vector<Touch> touches;
  DVec3 off(out);
  double slid = 0;
  auto feel = [&] {
    touches_of(under, feelers.points, size, rest, free, touches);
    if (touches.empty()) cuts_of(under, feelers, size, rest, free, touches);
  };
  for (int round = 0; round < kRounds; ++round) {
    feel();
    if (touches.empty()) return !swallowed(under, free);
    // The least turn and slide that clear all of them at once, in the sense of least squares.
    glm::dmat4 squares(kTurnCosts);
    squares[3][3] = slid < slide ? kSlideCosts : kNoSlide;
    glm::dvec4 pull(0);
    for (const Touch& t : touches) {
      glm::dvec4 row(glm::cross(t.arm, t.direction), glm::dot(off, t.direction));
      squares += glm::outerProduct(row, row);
      pull += row * t.need;
    }
    glm::dvec4 move = glm::inverse(squares) * pull * kFarther;
    DVec3 turn(move);
    double angle = std::min(glm::length(turn), kMostTurn);
    if (angle > 1e-9) {
      Quat by = glm::angleAxis(static_cast<float>(angle), Vec3(glm::normalize(turn)));
      rest.turn = glm::normalize(by * rest.turn);
    }
    double along = std::clamp(move.w, -slid, slide - slid);
    slid += along;
    rest.foot += out * static_cast<float>(along * size);
  }
  feel();
  return touches.empty() && !swallowed(under, free);
}

}  // namespace frond
