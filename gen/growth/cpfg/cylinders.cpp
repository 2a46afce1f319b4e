#include "cpfg/cylinders.h"

#include <algorithm>

namespace frond::cpfg {

namespace {

DVec3 direction(DVec3 v, DVec3 otherwise) {
  double length = std::sqrt(glm::dot(v, v));
  return length > 1e-12 && std::isfinite(length) ? v / length : otherwise;
}

/// Takes the frame of a ring over to another heading by the shortest turn.
void carry_frame(const CylinderRing& from, CylinderRing& to) {
  DVec3 axis = glm::cross(from.heading, to.heading);
  double sine = std::sqrt(glm::dot(axis, axis));
  DVec3 left = from.left;
  if (sine > 1e-12) left = turned(left, axis / sine, std::atan2(sine, glm::dot(from.heading, to.heading)));
  to.left = direction(left - to.heading * glm::dot(left, to.heading), from.left);
  to.up = glm::cross(to.left, to.heading);
}

/// Hermite's cubic and its slope, from values and slopes at both ends.
template <class V>
V hermite(double t, V from, V slope_from, V to, V slope_to) {
  double t2 = t * t, t3 = t2 * t;
  return from * (2 * t3 - 3 * t2 + 1) + slope_from * (t3 - 2 * t2 + t) + to * (3 * t2 - 2 * t3) +
         slope_to * (t3 - t2);
}

DVec3 hermite_slope(double t, DVec3 from, DVec3 slope_from, DVec3 to, DVec3 slope_to) {
  double t2 = t * t;
  return (from - to) * (6 * t2 - 6 * t) + slope_from * (3 * t2 - 4 * t + 1) + slope_to * (3 * t2 - 2 * t);
}

CylinderRing first_ring(const ControlPlace& place) {
  return {place.position, place.heading, place.left, place.up,   place.radius,
          place.contour,  place.contour, 0,          place.color};
}

/// How the radius changes from a place to the next: a Hermite curve of the share of the way and the radius.
class RadiusCurve {
 public:
  RadiusCurve(const ControlPlace& from, const ControlPlace& to, double distance)
      : from_(from.radius), change_(to.radius - from.radius) {
    double factor = to.rises_by_length ? distance : 1;
    auto tangent = [&](std::array<double, 2> rise) {
      bool none = rise[0] == 0 && rise[1] == 0;
      return none ? std::array{1.0, change_} : std::array{rise[0], rise[1] * factor};
    };
    start_ = tangent(from.rise_leaving), end_ = tangent(to.rise_arriving);
  }
  double share(double r) const { return hermite(r, 0.0, start_[0], 1.0, end_[0]); }
  double radius(double r) const { return hermite(r, from_, start_[1], from_ + change_, end_[1]); }

 private:
  double from_, change_;
  std::array<double, 2> start_, end_;
};

/// The points of a contour in its plane, evenly along it: x along up, y against left, z along the heading.
std::vector<DVec3> contour_points(int number, const std::map<int, CurveTable>& contours, int count,
                                  bool closed) {
  std::vector<DVec3> points;
  auto found = contours.find(number);
  double x = 1, y = 0, whole = 1;
  if (found != contours.end()) {
    const CurveTable& curve = found->second;
    // Closed ones are turned to begin along up; of open ones cpfg leaves out the last tenth of a span.
    DVec3 first = curve(0);
    double length = std::hypot(first.x, first.y);
    if (curve.closed && length > 3e-5) x = first.x / length, y = first.y / length;
    if (!curve.closed && curve.length.size() > 2 && curve.length.back() > 0)
      whole = curve.length[curve.length.size() - 2] / curve.length.back();
  }
  for (int i = 0; i < count; ++i) {
    double t = static_cast<double>(i) / (closed ? count : count - 1);
    DVec3 p(std::cos(2 * kPi * t), std::sin(2 * kPi * t), 0);
    if (found != contours.end()) p = found->second(t * whole);
    points.emplace_back(p.x * x + p.y * y, p.y * x - p.x * y, p.z);
  }
  return points;
}

bool is_closed(int number, const std::map<int, CurveTable>& contours) {
  auto found = contours.find(number);
  return found == contours.end() || found->second.closed;
}

void add_ring(Surface& skin, const CylinderRing& ring, std::span<const DVec3> from,
              std::span<const DVec3> to) {
  for (std::size_t i = 0; i < from.size(); ++i) {
    DVec3 p = (from[i] + (to[i] - from[i]) * ring.share) * ring.radius;
    skin.position.emplace_back(ring.position + ring.up * p.x - ring.left * p.y + ring.heading * p.z);
  }
}

}  // namespace

std::vector<CylinderRing> piece_rings(const ControlPlace& from, const ControlPlace& to, int strips,
                                      bool twisted) {
  double distance = glm::length(to.position - from.position);
  DVec3 out = from.heading * (from.leaving * distance), in = to.heading * (to.arriving * distance);
  RadiusCurve curve(from, to, distance);
  std::vector<CylinderRing> rings{first_ring(from)};
  for (int i = 1; i <= strips; ++i) {
    double r = static_cast<double>(i) / strips, t = curve.share(r);
    CylinderRing ring = rings.front();
    ring.position = hermite(t, from.position, out, to.position, in);
    ring.heading = direction(hermite_slope(t, from.position, out, to.position, in), rings.back().heading);
    ring.radius = std::max(curve.radius(r), 0.0);
    ring.to = to.contour, ring.share = t;
    ring.color = i == 1 ? from.color : to.color;
    carry_frame(rings.front(), ring);
    rings.push_back(ring);
  }
  rings.front().to = to.contour;
  CylinderRing& last = rings.back();
  double roll = std::atan2(glm::dot(last.up, to.left), glm::dot(last.left, to.left));
  for (std::size_t i = 0; twisted && i < rings.size(); ++i) {
    double angle = roll * rings[i].share;
    DVec3 left = rings[i].left;
    rings[i].left = left * std::cos(angle) + rings[i].up * std::sin(angle);
    rings[i].up = rings[i].up * std::cos(angle) - left * std::sin(angle);
  }
  return rings;
}

std::vector<CylinderRing> spline_rings(std::span<const ControlPlace> places, bool closed, int strips) {
  std::vector<CylinderRing> rings;
  std::size_t count = places.size();
  if (count < (closed ? 3u : 4u)) return rings;
  auto place = [&](std::size_t i) -> const ControlPlace& { return places[i % count]; };
  for (std::size_t span = 0, spans = closed ? count : count - 3; span < spans; ++span) {
    const ControlPlace &from = place(span + 1), &to = place(span + 2);
    RadiusCurve curve(from, to, glm::length(to.position - from.position));
    int own = place(span + 3).strips > 0 ? place(span + 3).strips : strips;
    for (int i = span == 0 ? 0 : 1; i <= own; ++i) {
      double r = static_cast<double>(i) / own, t = curve.share(r), s = 1 - t;
      double weight[] = {s * s * s / 6, (3 * t * t * t - 6 * t * t + 4) / 6,
                         (-3 * t * t * t + 3 * t * t + 3 * t + 1) / 6, t * t * t / 6};
      double slope[] = {-s * s / 2, (3 * t * t - 4 * t) / 2, (-3 * t * t + 2 * t + 1) / 2, t * t / 2};
      CylinderRing ring = first_ring(from);
      DVec3 position{0}, heading{0};
      for (std::size_t k = 0; k < 4; ++k) {
        position += place(span + k).position * weight[k];
        heading += place(span + k).position * slope[k];
      }
      ring.position = position, ring.radius = std::max(curve.radius(r), 0.0);
      ring.heading = direction(heading, rings.empty() ? ring.heading : rings.back().heading);
      ring.to = to.contour, ring.share = t;
      ring.color = i <= 1 ? from.color : to.color;
      carry_frame(rings.empty() ? first_ring(from) : rings.back(), ring);
      rings.push_back(ring);
    }
  }
  return rings;
}

bool is_round(std::span<const CylinderRing> rings, const std::map<int, CurveTable>& contours) {
  return std::ranges::all_of(rings, [&](const CylinderRing& ring) {
    return !contours.contains(ring.from) && !contours.contains(ring.to);
  });
}

Surface skin_of(std::span<const CylinderRing> rings, const std::map<int, CurveTable>& contours, int sides) {
  Surface skin;
  bool closed = std::ranges::all_of(rings, [&](const CylinderRing& ring) {
    return is_closed(ring.from, contours) && is_closed(ring.to, contours);
  });
  auto across = static_cast<std::uint32_t>(closed ? sides : sides + 1);
  std::map<int, std::vector<DVec3>> shapes;
  auto shape = [&](int number) -> const std::vector<DVec3>& {
    auto [found, fresh] = shapes.try_emplace(number);
    if (fresh) found->second = contour_points(number, contours, static_cast<int>(across), closed);
    return found->second;
  };
  double length = 0;
  for (std::size_t i = 1; i < rings.size(); ++i)
    length += glm::distance(rings[i].position, rings[i - 1].position);
  double way = 0;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    if (i > 0) way += glm::distance(rings[i].position, rings[i - 1].position);
    add_ring(skin, rings[i], shape(rings[i].from), shape(rings[i].to));
    for (std::uint32_t k = 0; k < across; ++k)
      skin.uv.emplace_back(length > 0 ? way / length : 0, static_cast<double>(k) / sides);
    auto row = static_cast<std::uint32_t>(i) * across;
    for (std::uint32_t k = 0; i > 0 && k < static_cast<std::uint32_t>(sides); ++k) {
      std::uint32_t next = (k + 1) % across, below = row - across;
      skin.triangle.push_back({below + k, below + next, row + next});
      skin.triangle.push_back({below + k, row + next, row + k});
    }
  }
  set_normals(skin);
  return skin;
}

}  // namespace frond::cpfg
