#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/bezier.h"
#include "core/noise.h"
#include "core/polyline.h"
#include "masonry/vessel.h"

namespace frond {

namespace {

glm::dvec2 on_span(const std::array<glm::dvec2, 4>& s, double t) {
  double u = 1 - t;
  return s[0] * (u * u * u) + s[1] * (3 * u * u * t) + s[2] * (3 * u * t * t) + s[3] * (t * t * t);
}

double off_line(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
  glm::dvec2 segment = b - a;
  double t = std::clamp(glm::dot(p - a, segment) / std::max(glm::dot(segment, segment), 1e-300), 0.0, 1.0);
  return glm::distance(p, a + segment * t);
}

/// Where the outline turns sharply, so that no curve may round it off.
bool corner(const std::vector<glm::dvec2>& line, std::size_t i) {
  if (i == 0 || i + 1 == line.size()) return true;
  glm::dvec2 in = glm::normalize(line[i] - line[i - 1]), out = glm::normalize(line[i + 1] - line[i]);
  return glm::dot(in, out) < 0.85;
}

/// The direction of the outline at a point, seen from its left or its right.
glm::dvec2 heading(const std::vector<glm::dvec2>& line, std::size_t i, bool after) {
  if (corner(line, i)) {
    std::size_t from = after ? i : i - 1;
    return glm::normalize(line[from + 1] - line[from]);
  }
  // The circle through three points (Barry and Goldman 1988).
  glm::dvec2 in = line[i] - line[i - 1], out = line[i + 1] - line[i];
  double a = glm::length(in), b = glm::length(out);
  return glm::normalize(in / a * b + out / b * a);
}

/// A cubic with the outline's directions at both ends and the handles that fit it best.
std::array<glm::dvec2, 4> fit(const std::vector<glm::dvec2>& line, std::size_t from, std::size_t to,
                              double& error) {
  glm::dvec2 a = line[from], b = line[to], out = heading(line, from, true), in = heading(line, to, false);
  double length = polyline_length(std::span(line).subspan(from, to - from + 1));
  std::array<glm::dvec2, 4> best{};
  error = 1e300;
  for (double handle : {0.30, 0.32, 1.0 / 3, 0.345, 0.36, 0.38}) {
    std::array<glm::dvec2, 4> span{{a, a + out * (handle * length), b - in * (handle * length), b}};
    double worst = 0;
    for (int k = 1; k < 16; ++k) {
      glm::dvec2 p = on_span(span, k / 16.0);
      double nearest = 1e300;
      for (std::size_t i = from; i < to; ++i) nearest = std::min(nearest, off_line(p, line[i], line[i + 1]));
      worst = std::max(worst, nearest);
    }
    if (worst < error) error = worst, best = span;
  }
  return best;
}

/// The part of the shape's curve, of degree 3 or less, between two parameters, laid so that it ends at the
/// given points.
std::array<glm::dvec2, 4> piece_of_curve(const VesselShape& shape, double from, double to, glm::dvec2 start,
                                         glm::dvec2 end) {
  std::vector<glm::dvec2> control = shape.profile;
  while (control.size() < 4) control = bezier_raised(control);
  auto a = bezier_jet(control, from), b = bezier_jet(control, to);
  double scale = (end.y - start.y) / (b.at.y - a.at.y), handle = scale * (to - from) / 3;
  return {start, start + a.slope * handle, end - b.slope * handle, end};
}

/// How wide the inside is at a height, where it is filled from below.
double inner_radius(const VesselProfile& profile, double y) {
  for (std::size_t i = profile.outline.size() - 1; i > profile.inside; --i) {
    glm::dvec2 low = profile.outline[i], high = profile.outline[i - 1];
    if (low.y <= y && high.y > y) return low.x + (high.x - low.x) * (y - low.y) / (high.y - low.y);
  }
  return profile.outline[profile.inside].x;
}

}  // namespace

std::vector<std::array<glm::dvec2, 4>> vessel_spans(const VesselShape& shape, const VesselProfile& profile,
                                                    double tolerance) {
  const auto& line = profile.outline;
  std::vector<std::array<glm::dvec2, 4>> spans;
  for (std::size_t from = 0; from + 1 < line.size();) {
    std::size_t to = from + 1;
    if (shape.profile.size() <= 4 && profile.curve[from] >= 0 && profile.curve[to] >= 0) {
      while (to + 1 < line.size() && profile.curve[to + 1] >= 0) ++to;
      spans.push_back(piece_of_curve(shape, profile.curve[from], profile.curve[to], line[from], line[to]));
      from = to;
      continue;
    }
    // The longest stretch that one cubic follows.
    double error = 0;
    std::array<glm::dvec2, 4> best = fit(line, from, to, error);
    if (error > tolerance) {
      glm::dvec2 third = (line[to] - line[from]) / 3.0;
      best = {line[from], line[from] + third, line[to] - third, line[to]};
    }
    while (to + 1 < line.size() && !corner(line, to)) {
      std::array<glm::dvec2, 4> longer = fit(line, from, to + 1, error);
      if (error > tolerance) break;
      best = longer, ++to;
    }
    spans.push_back(best);
    from = to;
  }
  return spans;
}

Soil vessel_soil(const VesselProfile& profile, double share, int sides, Seed seed) {
  constexpr int kRings = 14;
  Soil soil;
  double top = profile.floor + std::clamp(share, 0.02, 1.0) * (profile.rim - profile.wall - profile.floor);
  double wide = inner_radius(profile, top), into = profile.wall / 3, grain = std::max(0.012, 0.16 * wide);
  double heap = 0.05 * wide;
  soil.height = top;
  Vec3 shift(seed.child("x").range(-99, 99), 0, seed.child("z").range(-99, 99));
  // Upper side from the middle outward, wall down, lower side.
  std::vector<glm::dvec2> line{{0, top}};
  for (int i = 1; i <= kRings; ++i) line.push_back({(wide + into) * i / kRings, top});
  for (std::size_t i = profile.inside; i < profile.outline.size(); ++i) {
    glm::dvec2 p = profile.outline[i];
    if (p.y > top - 0.2 * profile.wall) continue;
    if (p.x > 3 * into) line.push_back({p.x + 0.5 * into, p.y - 0.5 * into});
  }
  line.push_back({0, profile.floor - into});
  std::vector<std::uint32_t> first;
  Surface& s = soil.surface;
  for (std::size_t i = 0; i < line.size(); ++i) {
    first.push_back(static_cast<std::uint32_t>(s.position.size()));
    bool pole = i == 0 || i + 1 == line.size();
    for (int k = 0; k < (pole ? 1 : sides); ++k) {
      double angle = 2 * kPi * k / sides, r = line[i].x, y = line[i].y;
      Vec3 p(r * std::cos(angle), y, -r * std::sin(angle));
      if (i <= kRings) {
        double in = 1 - r / (wide + into);
        y += heap * in * (2 - in) * 0.6 +
             0.12 * grain * fractal_noise(p / static_cast<float>(grain) + shift, 3) * std::min(1.0, 6 * in);
        p.y = static_cast<float>(y);
        if (i == 0) soil.height = y;
      }
      s.position.push_back(p);
    }
  }
  auto at = [&](std::size_t i, int k) {
    bool pole = i == 0 || i + 1 == line.size();
    return first[i] + (pole ? 0 : static_cast<std::uint32_t>(k % sides));
  };
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
    for (int k = 0; k < sides; ++k) {
      if (i > 0) s.triangle.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
      if (i + 2 < line.size()) s.triangle.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
    }
  set_normals(s);
  return soil;
}

}  // namespace frond
