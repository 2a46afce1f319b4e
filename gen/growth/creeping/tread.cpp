#include "creeping/tread.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace frond {

namespace {

const double kEdge = std::cos(radians(30.0));    // of a stride's normals: over an edge
const double kSharp = std::cos(radians(100.0));  // over an edge so sharp that it is neared in shorter strides
constexpr double kGroove = 0.5;                  // cosine, of 60 degrees: out of a groove
constexpr int kHalvings = 12;
// Shares of the lift:
constexpr double kOnSurface = 1e-3;  // nearer than this there is no direction off the surface
constexpr double kToSurface = 1.01;  // from a tread down to where it surely meets what it is on
constexpr double kMostCut = 0.7;     // how deep the line of a stride may cut through an edge
constexpr double kLifted = 0.999;    // from here on the surface bends away below a tread
constexpr double kOffCourse = 0.3;   // a stride that ends so far from where it led may have cut through

/// Some direction at right angles to one of length 1.
DVec3 across(const DVec3& n) {
  DVec3 axis = std::abs(n.x) < 0.6 ? DVec3(1, 0, 0) : DVec3(0, 0, 1);
  return glm::normalize(glm::cross(n, axis));
}

/// A heading carried along as the normal turns from one direction to another by the shortest way.
DVec3 carried_along(const DVec3& heading, const DVec3& from, const DVec3& to) {
  double c = glm::dot(from, to);
  if (c < -0.999999) return tangent(-heading, to);
  DVec3 axis = glm::cross(from, to);
  DVec3 turned = heading * c + glm::cross(axis, heading) + axis * (glm::dot(axis, heading) / (1 + c));
  return tangent(turned, to);
}

/// Whether the straight line between two treads cuts through the surface deeper than may be.
bool cuts(const TriangleSurface& host, const DVec3& from, const DVec3& to, double turn, double lift) {
  std::optional<Crossing> in = host.crossing(from, to);
  if (!in) return false;
  // Through a thin wall, not over an edge.
  if (turn <= 0) return true;
  std::optional<Crossing> out = host.crossing(to, from);
  if (!out) return true;
  DVec3 entry = from + (to - from) * in->share, exit = to + (from - to) * out->share;
  if (glm::distance(entry, exit) < 1e-9 * host.size()) return true;
  for (double share : {0.5, 0.25, 0.75})
    if (!host.closest(entry + (exit - entry) * share, kMostCut * lift)) return true;
  return false;
}

/// Up to the wall that a stride runs into; from there it climbs.
Stride climb(const TriangleSurface& host, const Tread& from, const Crossing& wall, double length,
             double lift) {
  DVec3 face = glm::dot(wall.normal, from.heading) > 0 ? -wall.normal : wall.normal;
  double steep = std::max(-glm::dot(face, from.heading), 1e-3);
  double run = std::max(wall.share * length - lift / steep, 0.0);
  Stride s{from, run, Footing::held};
  Tread& t = s.tread;
  t.place += from.heading * run;
  t.normal = face;
  if (std::optional<Crossing> foot = host.crossing(t.place, t.place - face * (kToSurface * lift))) {
    t.contact = t.place - face * (kToSurface * lift * foot->share);
    t.triangle = foot->triangle;
  } else if (std::optional<Contact> near = host.closest(t.place); near->distance > kOnSurface * lift) {
    // The wall was only grazed: its plane goes on where it does not.
    t.contact = near->point;
    t.triangle = near->triangle;
    t.normal = (t.place - near->point) / near->distance;
    t.place = t.contact + t.normal * std::min(near->distance, lift);
  }
  t.heading = carried_along(from.heading, from.normal, t.normal);
  return s;
}

/// The stride as it is asked for; nothing where it must be shorter.
std::optional<Stride> attempt(const TriangleSurface& host, const Tread& from, double length, double lift) {
  DVec3 ahead = from.place + from.heading * length;
  if (std::optional<Crossing> wall = host.crossing(from.place, ahead))
    return climb(host, from, *wall, length, lift);
  std::optional<Contact> under = host.closest(ahead, 2 * (length + lift), from.triangle);
  if (!under) return std::nullopt;
  Stride s{from, 0, Footing::held};
  DVec3 offset = ahead - under->point;
  DVec3 normal = under->distance > kOnSurface * lift ? offset / under->distance : from.normal;
  double turn = glm::dot(normal, from.normal);
  s.tread.contact = under->point;
  s.tread.triangle = under->triangle;
  bool convex = under->distance >= kLifted * lift;
  if (convex && turn < kSharp && length > lift) return std::nullopt;
  if (!convex && turn < kGroove && glm::dot(from.heading, normal) >= 0) {
    // Out of a groove: the other side of it is nearer than the one that is walked on.
    if (std::optional<Crossing> floor = host.crossing(ahead, ahead - from.normal * (2 * lift))) {
      normal = from.normal;
      turn = 1;
      s.tread.contact = ahead - from.normal * (2 * lift * floor->share);
      s.tread.triangle = floor->triangle;
    }
  }
  s.tread.normal = normal;
  s.tread.place = s.tread.contact + normal * lift;
  s.tread.heading = carried_along(from.heading, from.normal, normal);
  s.length = glm::distance(s.tread.place, from.place);
  if (convex && turn < kEdge) s.footing = Footing::edge;
  if (glm::distance(s.tread.place, ahead) > kOffCourse * lift &&
      cuts(host, from.place, s.tread.place, turn, lift))
    return std::nullopt;
  return s;
}

}  // namespace

DVec3 tangent(const DVec3& direction, const DVec3& normal) {
  assert(std::abs(glm::length(normal) - 1) < 1e-6);
  DVec3 v = direction - normal * glm::dot(direction, normal);  // = N x (v x N)
  double length = glm::length(v);
  return length > 1e-9 * glm::length(direction) && length > 0 ? v / length : across(normal);
}

DVec3 turned(const DVec3& heading, const DVec3& normal, double angle) {
  assert(std::abs(glm::dot(heading, normal)) < 1e-6 && "a heading lies along the surface");
  return heading * std::cos(angle) + glm::cross(normal, heading) * std::sin(angle);
}

DVec3 leaning(const DVec3& heading, const DVec3& normal, const DVec3& direction, double share) {
  double length = glm::length(direction);
  if (share <= 0 || length <= 0) return heading;
  DVec3 goal = direction / length;
  DVec3 axis = glm::cross(heading, goal);
  double sine = glm::length(axis);
  double angle = std::atan2(sine, glm::dot(heading, goal));
  DVec3 about = sine > 1e-6 ? axis / sine : normal;
  DVec3 leant =
      share >= 1 ? goal
                 : heading * std::cos(share * angle) + glm::cross(about, heading) * std::sin(share * angle);
  DVec3 flat = leant - normal * glm::dot(leant, normal);
  double rest = glm::length(flat);
  return rest > 1e-6 ? flat / rest : heading;
}

Stride stride(const TriangleSurface& host, const Tread& from, double length, double lift) {
  assert(length > 0 && lift > 0);
  assert(std::abs(glm::length(from.heading) - 1) < 1e-6 && std::abs(glm::length(from.normal) - 1) < 1e-6);
  for (int halving = 0; halving < kHalvings; ++halving, length *= 0.5)
    if (std::optional<Stride> s = attempt(host, from, length, lift)) return *s;
  return {from, 0, Footing::stuck};
}

std::optional<Tread> tread_at(const TriangleSurface& host, const DVec3& place, const DVec3& heading,
                              double lift, double within) {
  std::optional<Contact> under = host.closest(place, within);
  if (!under) return std::nullopt;
  Tread t;
  t.contact = under->point;
  t.triangle = under->triangle;
  t.normal = under->distance > 0.01 * lift && !under->inside ? (place - under->point) / under->distance
                                                             : host.face_normal(under->triangle);
  t.place = t.contact + t.normal * lift;
  t.heading = tangent(glm::length(heading) > 0 ? heading : DVec3(0, 1, 0), t.normal);
  return t;
}

}  // namespace frond
