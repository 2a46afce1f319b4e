#include "masonry/vessel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "core/bezier.h"

namespace frond {

namespace {

constexpr double kSpare = 0.95;     // share of the least radius of curvature that a wall may use
constexpr double kNeck = 0.8;       // share of a neck's radius that a wall may use
constexpr double kWallStep = 0.85;  // factor by which a wall is made thinner until it crosses itself nowhere
constexpr int kWallTries = 40;      // how often that is tried
constexpr int kArc = 10;            // parts of the lip

/// A point of the outside with what its offset needs.
struct Station {
  glm::dvec2 at{0}, inward{0};
  double bend = 0;  // curvature, positive toward the inside
  double t = 0;     // of the curve
};

std::vector<Station> stations(const VesselShape& shape, double scale, double raise) {
  std::vector<Station> list;
  double base = shape.profile.front().y;
  for (int i = 0; i <= shape.rings; ++i) {
    auto jet = bezier_jet(shape.profile, static_cast<double>(i) / shape.rings);
    glm::dvec2 slope = jet.slope * scale, bend = jet.bend * scale;
    double speed = glm::length(slope);
    if (speed < 1e-12) continue;  // a point of the curve that stands still has no direction
    Station s;
    s.t = static_cast<double>(i) / shape.rings;
    s.at = glm::dvec2(std::max(0.0, jet.at.x * scale), (jet.at.y - base) * scale + raise);
    s.inward = glm::dvec2(-slope.y, slope.x) / speed;
    s.bend = (slope.x * bend.y - slope.y * bend.x) / (speed * speed * speed);
    list.push_back(s);
  }
  return list;
}

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

/// Whether two pieces of a line cross properly.
bool cross_over(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 d) {
  if (std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x) ||
      std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y))
    return false;
  return cross(b - a, c - a) * cross(b - a, d - a) < 0 && cross(d - c, a - c) * cross(d - c, b - c) < 0;
}

bool crosses_itself(const std::vector<glm::dvec2>& line) {
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
    for (std::size_t k = i + 2; k + 1 < line.size(); ++k)
      if (cross_over(line[i], line[i + 1], line[k], line[k + 1])) return true;
  return false;
}

/// The thickest wall whose inside does not fold over itself, nor meets itself in a neck.
double thickest_wall(const std::vector<Station>& outside) {
  double most = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < outside.size(); ++i) {
    const Station& s = outside[i];
    if (s.bend > 1e-9) most = std::min(most, kSpare / s.bend);
    bool neck =
        i > 0 && outside[i - 1].at.x >= s.at.x && (i + 1 == outside.size() || outside[i + 1].at.x > s.at.x);
    if (neck && s.inward.x < 0) most = std::min(most, kNeck * s.at.x / -s.inward.x);
  }
  return std::min(most, kNeck * outside.back().at.x);
}

/// The ring it stands on, hollow below: from the axis to where the outside begins. Returns that station's
/// index.
std::size_t add_foot(const VesselShape& shape, const std::vector<Station>& outside, double wall,
                     std::vector<glm::dvec2>& line) {
  // By eye.
  constexpr double kNarrow = 0.15;        // of the widest radius: a narrower foot of the curve is no ring
  constexpr double kMostOfWidest = 0.98;  // radius of the ring, at most
  constexpr double kMostOfRadius = 0.5;   // thickness of the ring and depth of its hollow, at most
  constexpr double kRingThick = 1.6;      // of the wall's thickness
  constexpr double kDeep = 0.8, kDeepThin = 0.3;     // depth of the hollow: of the foot's height; of the wall
  constexpr double kMostOfStart = 0.7;               // depth of the hollow: of where the outside begins
  constexpr double kRound = 0.45, kRoundThin = 0.3;  // of edges: of those two; of the ring's thickness
  double widest = 0;
  for (const Station& s : outside) widest = std::max(widest, s.at.x);
  double radius = shape.foot_radius;
  if (radius <= 0) radius = outside[0].at.x > kNarrow * widest ? outside[0].at.x : widest / 3;
  radius = std::min(radius, kMostOfWidest * widest);
  std::size_t first = 0;
  while (first + 1 < outside.size() && outside[first].at.x < radius * 0.999) ++first;
  double start =
      outside[first].at.y;  // a ring wider than the curve's foot reaches up to where it meets the curve
  double ring = std::min(kRingThick * wall, kMostOfRadius * radius);
  double hollow = std::min(
      {kMostOfStart * start, std::max(kDeep * shape.foot, kDeepThin * wall), kMostOfRadius * radius});
  hollow = std::min(hollow, kDeep * outside[0].at.y + kDeepThin * wall);
  double round = std::min({kRoundThin * ring, kRound * hollow, kRound * start});
  line.push_back({0, hollow});
  if (round > 1e-9) {
    line.push_back({radius - ring, hollow});
    line.push_back({radius - ring, round});
    line.push_back({radius - ring + round, 0});
    line.push_back({radius - round, 0});
    line.push_back({radius - 0.3 * round, 0.3 * round});
    line.push_back({radius, round});
  } else {
    line.push_back({radius, 0});
  }
  if (outside[first].at.y - line.back().y < 1e-9) ++first;
  return first;
}

/// A half circle, or more of one where the lip is thicker than the wall, from outside to inside. Takes from
/// both lines what lies in it.
std::vector<glm::dvec2> round_lip(std::vector<glm::dvec2>& outer, std::vector<glm::dvec2>& inner,
                                  double radius) {
  glm::dvec2 centre = (outer.back() + inner.front()) * 0.5;
  auto within = [&](glm::dvec2 p) { return glm::distance(p, centre) < radius * 1.0001; };
  while (outer.size() > 2 && within(outer.back())) outer.pop_back();
  std::size_t gone = 0;
  while (gone + 2 < inner.size() && within(inner[gone])) ++gone;
  inner.erase(inner.begin(), inner.begin() + static_cast<std::ptrdiff_t>(gone));
  glm::dvec2 from = glm::normalize(outer.back() - centre), to = glm::normalize(inner.front() - centre);
  double start = std::atan2(from.y, from.x), end = std::atan2(to.y, to.x);
  while (end <= start) end += 2 * kPi;
  std::vector<glm::dvec2> arc;
  for (int i = 0; i <= kArc; ++i) {
    double angle = start + (end - start) * i / kArc;
    arc.push_back(centre + glm::dvec2(std::cos(angle), std::sin(angle)) * radius);
  }
  return arc;
}

/// The inside from the lip down to the floor, which it meets in a hollow curve.
std::vector<glm::dvec2> inside_line(const std::vector<Station>& outside, double wall, double floor) {
  constexpr double kRoundWalls = 2.5, kMostRound = 0.4;  // radius at the floor: of the wall, of the inside's
  constexpr double kMostWider = 1.2;  // at the floor the inside is at most so much wider than its last point
  std::vector<glm::dvec2> line;
  for (auto s = outside.rbegin(); s != outside.rend(); ++s) {
    glm::dvec2 at = s->at + s->inward * wall;
    if (at.x <= 0.02 * wall || at.y <= floor) break;
    line.push_back(at);
  }
  double round = line.empty() ? 0 : std::min(kRoundWalls * wall, kMostRound * line.back().x);
  while (line.size() > 2 && line.back().y < floor + round && line.back().x > 2 * round) {
    line.pop_back();
    round = std::min(round, kMostRound * line.back().x);
  }
  if (line.empty()) return line;
  // Along the wall's own slope down to the floor, then inward.
  glm::dvec2 from = line.back(), corner(from.x, floor);
  if (line.size() > 1) {
    glm::dvec2 down = from - line[line.size() - 2];
    if (down.y < -1e-9)
      corner.x = std::clamp(from.x + down.x * (floor - from.y) / down.y, 0.0, kMostWider * from.x);
  }
  glm::dvec2 to(std::max(0.0, corner.x - std::max(round, from.y - floor)), floor);
  std::array<glm::dvec2, 3> bow{{from, corner, to}};
  for (int i = 1; i <= 8; ++i) line.push_back(bezier_jet(bow, i / 8.0).at);
  if (line.back().x > 1e-9) line.push_back({0, floor});
  line.back().x = 0;
  return line;
}

/// The whole line for one thickness of the wall; empty where there is none.
VesselProfile profile_of(const VesselShape& shape, const std::vector<Station>& outside, double wall) {
  VesselProfile profile;
  profile.wall = wall;
  profile.floor = outside[0].at.y + wall;
  std::vector<glm::dvec2> outer, inner = inside_line(outside, wall, profile.floor);
  if (inner.size() < 4) return {};
  std::size_t first = add_foot(shape, outside, wall, outer);
  std::size_t foot = outer.size();
  for (std::size_t i = first; i < outside.size(); ++i) outer.push_back(outside[i].at);
  std::vector<glm::dvec2> arc = round_lip(outer, inner, wall / 2 * std::max(1.0, shape.lip));
  profile.outline = outer;
  profile.outline.insert(profile.outline.end(), arc.begin(), arc.end());
  profile.inside = outer.size() + arc.size() / 2;
  profile.outline.insert(profile.outline.end(), inner.begin(), inner.end());
  for (const glm::dvec2& p : profile.outline) profile.rim = std::max(profile.rim, p.y);
  // Points on top of each other would leave triangles without area.
  VesselProfile clean = profile;
  clean.outline.clear();
  for (std::size_t i = 0; i < profile.outline.size(); ++i) {
    bool same =
        !clean.outline.empty() && glm::distance(clean.outline.back(), profile.outline[i]) < 1e-4 * wall;
    if (same && i + 1 == profile.outline.size()) clean.outline.back() = profile.outline[i];
    if (i == profile.inside) clean.inside = clean.outline.size() - (same ? 1 : 0);
    if (same) continue;
    clean.outline.push_back(profile.outline[i]);
    clean.curve.push_back(i >= foot && i < outer.size() ? outside[first + i - foot].t : -1);
  }
  return clean;
}

/// How far up each point is, foot to lip and down again.
void set_along(VesselProfile& profile) {
  for (std::size_t i = 0; i < profile.outline.size(); ++i) {
    double up = profile.outline[i].y / profile.rim;
    profile.along.push_back(i < profile.inside ? up : 2 - up);
  }
}

Errors refuse_profile(const VesselShape& shape) {
  Errors errors;
  const auto& points = shape.profile;
  if (points.size() < 2 || points.size() > 21)
    return {error_at("", "the profile has {} points; expected 2 to 21", points.size())};
  for (const glm::dvec2& p : points)
    if (p.x < 0) errors.push_back(error_at("", "the profile has the radius {}; expected 0 or more", p.x));
  if (points.back().x <= 0)
    errors.push_back({"", "the profile ends on the axis; expected a lip with a radius above 0"});
  if (points.back().y <= points.front().y)
    errors.push_back({"", "the profile's lip is not higher than its foot"});
  return errors;
}

}  // namespace

Result<VesselProfile> vessel_profile(const VesselShape& shape) {
  if (Errors errors = refuse_profile(shape); !errors.empty()) return errors;
  double rise = shape.profile.back().y - shape.profile.front().y,
         scale = shape.height > 0 ? shape.height / rise : 1;
  std::vector<Station> outside = stations(shape, scale, shape.foot);
  std::vector<glm::dvec2> line;
  for (const Station& s : outside) {
    if (s.at.y < outside[0].at.y - 1e-9) return Error{"", "the profile dips below its foot"};
    line.push_back(s.at);
  }
  if (outside.size() < 4) return Error{"", "the profile has no length"};
  if (crosses_itself(line)) return Error{"", "the profile crosses itself"};

  double wall = std::min(shape.wall, thickest_wall(outside));
  for (int i = 0; i < kWallTries; ++i, wall *= kWallStep) {
    VesselProfile profile = profile_of(shape, outside, wall);
    if (profile.outline.empty() || crosses_itself(profile.outline)) continue;
    set_along(profile);
    if (wall < shape.wall)
      profile.note = fmt::format(
          "the wall is {:.2g} m thick, not {:.2g}: thicker than the curve bends or its neck is wide", wall,
          shape.wall);
    return profile;
  }
  return Error{"", "the profile leaves no room for a wall"};
}

Surface vessel_surface(const VesselProfile& profile, int sides) {
  Surface surface;
  const auto& line = profile.outline;
  std::vector<std::uint32_t> first;  // of each ring; a point on the axis is a ring of one
  for (std::size_t i = 0; i < line.size(); ++i) {
    first.push_back(static_cast<std::uint32_t>(surface.position.size()));
    bool pole = i == 0 || i + 1 == line.size();
    for (int k = 0; k <= (pole ? 0 : sides); ++k) {
      double turn = static_cast<double>(k) / sides, angle = 2 * kPi * (k % sides) / sides;
      surface.position.push_back(Vec3(line[i].x * std::cos(angle), line[i].y, -line[i].x * std::sin(angle)));
      surface.uv.push_back(Vec2(pole ? 0.5 : turn, profile.along[i]));
    }
  }
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
    for (std::uint32_t k = 0; k < static_cast<std::uint32_t>(sides); ++k) {
      bool from_pole = i == 0, to_pole = i + 2 == line.size();
      std::uint32_t a = first[i] + (from_pole ? 0 : k), b = first[i] + (from_pole ? 0 : k + 1);
      std::uint32_t c = first[i + 1] + (to_pole ? 0 : k + 1), d = first[i + 1] + (to_pole ? 0 : k);
      if (!from_pole) surface.triangle.push_back({a, b, c});
      if (!to_pole) surface.triangle.push_back({a, c, d});
    }
  set_normals(surface);
  // Both sides of the seam are one.
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    std::uint32_t from = first[i], to = first[i] + static_cast<std::uint32_t>(sides);
    surface.normal[from] = surface.normal[to] = glm::normalize(surface.normal[from] + surface.normal[to]);
  }
  return surface;
}

}  // namespace frond
