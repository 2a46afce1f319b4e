#include "grammar/guide.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

#include "core/spline.h"
#include "grammar/turtle_state.h"

namespace frond {

namespace {

constexpr std::size_t kMostPoints = 1'000'000;

/// The children of all points, in the order of the points.
void list_children(Guide& guide) {
  guide.first_child.assign(guide.points.size() + 1, 0);
  for (std::size_t i = 0; i < guide.points.size(); ++i) {
    std::int32_t parent = guide.points[i].parent;
    if (parent == GuidePoint::kRoot)
      guide.roots.push_back(static_cast<std::int32_t>(i));
    else
      ++guide.first_child[static_cast<std::size_t>(parent) + 1];
  }
  for (std::size_t i = 1; i < guide.first_child.size(); ++i) guide.first_child[i] += guide.first_child[i - 1];
  guide.child.resize(guide.points.size() - guide.roots.size());
  std::vector<std::uint32_t> next = guide.first_child;
  for (std::size_t i = 0; i < guide.points.size(); ++i)
    if (std::int32_t parent = guide.points[i].parent; parent != GuidePoint::kRoot)
      guide.child[next[parent]++] = static_cast<std::int32_t>(i);
}

/// Whether every point hangs from a first one: walks up, marking what is known to.
bool hangs_together(const std::vector<GuidePoint>& points) {
  enum : char { unknown, visiting, good };
  std::vector<char> state(points.size(), unknown);
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::vector<std::size_t> path;
    std::size_t at = i;
    while (state[at] == unknown) {
      state[at] = visiting;
      path.push_back(at);
      if (points[at].parent == GuidePoint::kRoot) break;
      at = static_cast<std::size_t>(points[at].parent);
    }
    if (state[at] == visiting && points[at].parent != GuidePoint::kRoot) return false;
    for (std::size_t passed : path) state[passed] = good;
  }
  return true;
}

Errors set_parents(std::vector<GuidePoint>& points, const std::vector<int>& parent) {
  auto mistake = [](std::string what) { return Errors{{"guide", std::move(what)}}; };
  if (parent.size() != points.size())
    return mistake(
        fmt::format("`parent` has {} numbers for {} points; give one each", parent.size(), points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (parent[i] < -1 || parent[i] >= static_cast<int>(points.size()))
      return mistake(fmt::format("the parent of point {} is {}; the points are 0 to {}, and -1 is none", i,
                                 parent[i], points.size() - 1));
    points[i].parent = parent[i];
  }
  if (!hangs_together(points))
    return mistake("points follow each other in a circle; one needs the parent -1");
  return {};
}

/// The curves between points with handles as points of their own. Points stay in their order.
std::vector<GuidePoint> bent(const std::vector<GuidePoint>& points) {
  constexpr int kPieces = 12;
  auto handled = [](const GuidePoint& p) { return p.in || p.out; };
  auto is_bent = [&](const GuidePoint& p) {
    return p.parent != GuidePoint::kRoot && (handled(p) || handled(points[p.parent]));
  };
  std::vector<std::int32_t> number;  // of each point among all
  for (std::int32_t next = 0; const GuidePoint& p : points) {
    next += is_bent(p) ? kPieces : 1;
    number.push_back(next - 1);
  }
  std::vector<GuidePoint> all;
  for (const GuidePoint& p : points) {
    std::int32_t before = p.parent;
    if (before != GuidePoint::kRoot) before = number[p.parent];
    if (is_bent(p)) {
      const GuidePoint& from = points[p.parent];
      DVec3 control[] = {from.at, from.at + handle_of(from.out, from.in), p.at + handle_of(p.in, p.out),
                         p.at};
      for (int k = 1; k < kPieces; ++k) {
        double share = static_cast<double>(k) / kPieces;
        all.push_back({bezier_point(control, share), before});
        if (from.radius && p.radius) all.back().radius = *from.radius + (*p.radius - *from.radius) * share;
        before = static_cast<std::int32_t>(all.size()) - 1;
      }
    }
    all.push_back(p);
    all.back().parent = before;
  }
  return all;
}

void apply_point(const GuidePoint& point, std::int32_t index, TurtleState& turtle) {
  if (point.radius) turtle.width = 2 * *point.radius, turtle.width_here = -1;
  if (point.angle) turtle.angle = *point.angle;
  if (point.elasticity) turtle.elasticity = *point.elasticity;
  if (point.tropism) turtle.pull = index;
}

}  // namespace

std::size_t Guide::leaves() const {
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.size(); ++i) count += first_child[i] == first_child[i + 1];
  return count;
}

DVec3 bezier_point(std::span<const DVec3> control, double t) {
  std::vector<DVec3> polygon(control.begin(), control.end());
  for (std::size_t left = polygon.size(); left > 1; --left)
    for (std::size_t i = 0; i + 1 < left; ++i) polygon[i] += (polygon[i + 1] - polygon[i]) * t;
  return polygon.empty() ? DVec3(0) : polygon[0];
}

std::vector<GuidePoint> points_of(const GuideLines& lines) {
  using Key = std::tuple<double, double, double>;
  std::map<Key, std::uint32_t> known;
  std::vector<std::uint32_t> same(lines.place.size());
  for (std::uint32_t i = 0; i < same.size(); ++i) {
    DVec3 p = lines.place[i];
    same[i] = known.try_emplace(Key{p.x, p.y, p.z}, i).first->second;
  }
  std::vector<std::vector<std::uint32_t>> near(lines.place.size());
  for (auto [a, b] : lines.line) {
    if (a >= same.size() || b >= same.size() || same[a] == same[b]) continue;
    near[same[a]].push_back(same[b]);
    near[same[b]].push_back(same[a]);
  }
  std::vector<GuidePoint> points;
  std::vector<bool> reached(lines.place.size());
  std::vector<std::uint32_t> place;  // of each point
  for (auto [start, end] : lines.line) {
    if (start >= same.size() || end >= same.size() || reached[same[start]]) continue;
    std::size_t next = points.size();
    points.push_back({lines.place[same[start]]});
    place.push_back(same[start]);
    reached[same[start]] = true;
    for (; next < points.size(); ++next) {
      for (std::uint32_t other : near[place[next]]) {
        if (reached[other]) continue;
        reached[other] = true;
        points.push_back({lines.place[other], static_cast<std::int32_t>(next)});
        place.push_back(other);
      }
    }
  }
  return points;
}

Result<Guide> guide_of(const GuideText& text) {
  Guide guide;
  guide.tolerance = text.tolerance;
  guide.leniency = text.leniency;
  guide.reach_ends = text.reach_ends;
  auto mistake = [](const char* what) { return Error{"guide", what}; };
  if (!text.points.empty() + !text.bezier.empty() + !text.file.empty() > 1)
    return mistake("give one of `points`, `bezier` and `file`");
  if (!text.parent.empty() && text.points.empty()) return mistake("`parent` is about `points`; give them");
  if (text.bezier.size() == 1) return mistake("a curve needs two control points or more");
  if (text.samples < 1 || static_cast<std::size_t>(text.samples) > kMostPoints)
    return mistake("`samples` must be from 1 to 1000000");
  if (!(text.tolerance >= 0) || !(text.leniency > 0))
    return mistake("`tolerance` must be 0 or more and `leniency` more than 0");

  guide.points = text.points;
  if (!text.lines.line.empty()) guide.points = points_of(text.lines);
  if (!text.bezier.empty())
    for (int i = 0; i <= text.samples; ++i)
      guide.points.push_back({bezier_point(text.bezier, static_cast<double>(i) / text.samples), i - 1});
  if (!text.parent.empty())
    if (Errors errors = set_parents(guide.points, text.parent); !errors.empty()) return errors;
  guide.points = bent(guide.points);
  if (guide.points.size() > kMostPoints) return mistake("more than 1000000 points");
  for (const GuidePoint& point : guide.points)
    if (!std::isfinite(glm::dot(point.at, point.at))) return mistake("a point is not finite");
  list_children(guide);
  return guide;
}

void lead(const Guide& guide, TurtleState& turtle, std::int32_t target) {
  const GuidePoint& point = guide.points[target];
  DVec3 offset = point.at - turtle.position;
  double distance = glm::length(offset);
  turtle.target = target;
  head_for(turtle, offset);
  turtle.length = guide.leniency * distance;
  if (!point.radius) return;
  // The width is approached as the place is; what is drawn next begins as wide as the turtle is here.
  if (!(distance > 0)) return void(turtle.width = 2 * *point.radius);
  if (turtle.width_here < 0) turtle.width_here = turtle.width;
  turtle.width += (2 * *point.radius - turtle.width) * std::min(1.0, guide.leniency);
}

std::span<const std::int32_t> follow(const Guide& guide, TurtleState& turtle) {
  if (turtle.target == TurtleState::kFree || guide.points.empty()) return {};
  if (turtle.target == TurtleState::kNotLed) {
    turtle.own_length = turtle.length;
    if (guide.roots.size() > 1) return guide.roots;
    turtle.target = guide.roots[0];
  }
  std::int32_t target = turtle.target;
  const GuidePoint& point = guide.points[target];
  std::span<const std::int32_t> children = guide.children(target);
  bool there = glm::distance(turtle.position, point.at) <= guide.tolerance;
  if (there || (children.empty() && !guide.reach_ends)) {
    apply_point(point, target, turtle);
    if (!children.empty()) return children;
    turtle.length = turtle.own_length;
    turtle.target = TurtleState::kFree;
  } else {
    lead(guide, turtle, target);
  }
  return {};
}

}  // namespace frond
