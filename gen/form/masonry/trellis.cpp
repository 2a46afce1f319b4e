#include "masonry/trellis.h"

#include <algorithm>
#include <cmath>

#include "geometry/tubes.h"
#include "masonry/block.h"

namespace frond {

namespace {

constexpr double kSunk = 0.35;     // metres of a post in the ground
constexpr double kAboveTop = 0.1;  // metres of a post above the uppermost wire
constexpr int kPiecesASpan = 8;    // of a wire between two posts
constexpr int kWireSides = 6;
constexpr double kFanOpen = 0.62;  // radians to either side of the upright that a fan spreads at most

/// A piece of timber from one end to the other, `width` across in the plane of the trellis.
TrellisPart bar(Vec3 from, Vec3 to, double width, double thick) {
  Vec3 way = to - from;
  float angle = std::atan2(way.y, way.x);
  Block block{Vec3(glm::length(way), width, thick), static_cast<float>(0.08 * std::min(width, thick))};
  return {false, block_surface(block), (from + to) * 0.5f, glm::angleAxis(angle, Vec3(0, 0, 1))};
}

/// A wire through all posts, which sags as a parabola from one to the next.
TrellisPart wire_part(const TrellisShape& s, double height, double front) {
  Skeleton line;
  int pieces = (s.posts - 1) * kPiecesASpan;
  for (int i = 0; i <= pieces; ++i) {
    double share = static_cast<double>(i % kPiecesASpan) / kPiecesASpan;
    Vec3 at(s.width * (static_cast<double>(i) / pieces - 0.5), height - 4 * s.sag * share * (1 - share),
            front);
    line.add(at, static_cast<float>(s.wire / 2), i - 1, 0);
  }
  set_tip_distances(line);
  set_births(line);
  return {true, closed_tubes(line, line.position, line.radius, 1, kWireSides).surface};
}

/// Heights of the level wires or laths.
std::vector<double> levels_of(const TrellisShape& s) {
  std::vector<double> levels;
  double top = std::max(s.height - kAboveTop, s.lowest);
  for (int i = 0; i < s.wires; ++i)
    levels.push_back(s.lowest + (top - s.lowest) * i / std::max(s.wires - 1, 1));
  return levels;
}

void add_wires(const TrellisShape& s, std::vector<TrellisPart>& parts) {
  for (int i = 0; i < s.posts; ++i) {
    double x = s.width * (static_cast<double>(i) / (s.posts - 1) - 0.5);
    parts.push_back(bar(Vec3(x, -kSunk, 0), Vec3(x, s.height, 0), s.post, s.post));
  }
  for (double height : levels_of(s)) parts.push_back(wire_part(s, height, s.post / 2 + 2 * s.wire));
}

void add_lattice(const TrellisShape& s, std::vector<TrellisPart>& parts) {
  double thick = s.lath / 2;
  int columns = std::max(static_cast<int>(std::lround(s.width / s.spacing)), 1);
  int rows = std::max(static_cast<int>(std::lround(s.height / s.spacing)), 1);
  for (int i = 0; i <= columns; ++i) {
    double x = s.width * (static_cast<double>(i) / columns - 0.5);
    bool edge = i == 0 || i == columns;
    parts.push_back(bar(Vec3(x, edge ? -kSunk : 0.02, 0), Vec3(x, s.height, 0), s.lath, thick));
  }
  for (int i = 0; i <= rows; ++i) {
    double y = std::max(s.height * i / rows, s.lath);
    double half = s.width / 2 + s.lath / 2;
    parts.push_back(bar(Vec3(-half, y, thick), Vec3(half, y, thick), s.lath, thick));
  }
}

void add_fan(const TrellisShape& s, std::vector<TrellisPart>& parts) {
  double thick = s.lath / 2, open = std::min(kFanOpen, std::atan2(s.width / 2, s.height));
  for (int i = 0; i < s.rays; ++i) {
    double angle = s.rays > 1 ? open * (2.0 * i / (s.rays - 1) - 1) : 0,
           x = 1.5 * s.lath * (i - (s.rays - 1) / 2.0);
    x *= 0.7;  // they lie close together at the foot
    parts.push_back(
        bar(Vec3(x, -kSunk, 0), Vec3(x + s.height * std::tan(angle), s.height, 0), s.lath, thick));
  }
  for (double y : levels_of(s)) {
    double half = y * std::tan(open) + s.lath * 0.6 * s.rays;
    parts.push_back(bar(Vec3(-half, y, thick), Vec3(half, y, thick), s.lath, thick));
  }
}

}  // namespace

std::vector<TrellisPart> trellis_parts(const TrellisShape& shape) {
  constexpr decltype(&add_wires) kAdd[] = {add_wires, add_lattice, add_fan};  // by TrellisForm
  std::vector<TrellisPart> parts;
  kAdd[static_cast<std::size_t>(shape.form)](shape, parts);
  return parts;
}

}  // namespace frond
