#include "geometry/tube.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace frond {

namespace {

constexpr int kCapRings = 2;  // between the last ring of a branch and the pole of its end

/// The middle line of one branch.
struct Line {
  std::vector<Vec3> at, along;  // along: of length 1
  std::vector<float> radius, way;
  std::vector<std::int32_t> node;
};

void set_directions(Line& line) {
  assert(line.at.size() >= 2 && line.radius.size() == line.at.size() && line.node.size() == line.at.size());
  std::size_t n = line.at.size();
  line.along.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    Vec3 sum(0);
    if (i > 0) sum += glm::normalize(line.at[i] - line.at[i - 1]);
    if (i + 1 < n) sum += glm::normalize(line.at[i + 1] - line.at[i]);
    float length = glm::length(sum);
    line.along[i] = length > 1e-4f ? sum / length : glm::normalize(line.at[i] - line.at[i - 1]);
  }
}

class Maker {
 public:
  Maker(TubeMesh& mesh, int sides) : mesh_(mesh), sides_(sides) {}

  void add(Line& line) {
    if (line.at.size() < 2) return;
    set_directions(line);
    Vec3 along = line.along[0];
    Vec3 helper = std::abs(along.y) < 0.9f ? Vec3(0, 1, 0) : Vec3(1, 0, 0);
    Vec3 side = glm::normalize(glm::cross(helper, along));
    first_ring_ = true;
    // The foot lies in what it grows from: a flat cone closes it.
    pole(line.at[0] - along * (0.5f * line.radius[0]), -along, line, 0);
    for (std::size_t i = 0; i < line.at.size(); ++i) {
      if (i > 0) side = carried_side(line, i, side);
      std::size_t from = i > 0 ? i - 1 : i, to = std::min(i + 1, line.at.size() - 1);
      float run = glm::distance(line.at[from], line.at[to]);
      float slope = run > 0 ? (line.radius[from] - line.radius[to]) / run : 0;
      ring(line.at[i], line.along[i], side, line.radius[i], std::clamp(slope, -1.0f, 1.0f), line, i, 0);
    }
    std::size_t last = line.at.size() - 1;
    float radius = line.radius[last];
    Vec3 tip = line.at[last], end = line.along[last];
    for (int r = 1; r <= kCapRings; ++r) {
      auto turn = static_cast<float>(kPi / 2 * r / (kCapRings + 1));
      ring(tip + end * (radius * std::sin(turn)), end, side, radius * std::cos(turn), std::tan(turn), line,
           last, radius * std::sin(turn));
    }
    close(tip + end * radius, end, line, last);
  }

 private:
  /// The side direction of the next ring: reflected twice, so that it turns about the branch no more than it
  /// must.
  static Vec3 carried_side(const Line& line, std::size_t i, Vec3 side) {
    Vec3 step = line.at[i] - line.at[i - 1];
    float square = glm::dot(step, step);
    Vec3 mirrored = side - step * (2 / square * glm::dot(step, side));
    Vec3 along = line.along[i - 1] - step * (2 / square * glm::dot(step, line.along[i - 1]));
    Vec3 over = line.along[i] - along;
    float over2 = glm::dot(over, over);
    if (over2 > 1e-12f) mirrored -= over * (2 / over2 * glm::dot(over, mirrored));
    mirrored -= line.along[i] * glm::dot(mirrored, line.along[i]);
    return glm::normalize(mirrored);
  }

  std::uint32_t vertex(Vec3 at, Vec3 normal, Vec2 uv, std::int32_t node) {
    Surface& s = mesh_.surface;
    s.position.push_back(at);
    s.normal.push_back(normal);
    s.uv.push_back(uv);
    mesh_.node.push_back(node);
    return static_cast<std::uint32_t>(s.position.size()) - 1;
  }

  /// A ring, tied to what is before it. The first and last vertex lie at one place, at both ends of the
  /// texture.
  void ring(Vec3 at, Vec3 along, Vec3 side, float radius, float slope, const Line& line, std::size_t i,
            float beyond) {
    Vec3 across = glm::cross(along, side);
    auto start = static_cast<std::uint32_t>(mesh_.surface.position.size());
    for (int k = 0; k <= sides_; ++k) {
      auto turn = static_cast<float>(2 * kPi * (k % sides_) / sides_);
      Vec3 out = side * std::cos(turn) + across * std::sin(turn);
      Vec2 uv(static_cast<float>(k) / static_cast<float>(sides_), line.way[i] + beyond);
      vertex(at + out * radius, glm::normalize(out + along * slope), uv, line.node[i]);
    }
    for (int k = 0; k < sides_; ++k) {
      auto step = static_cast<std::uint32_t>(k);
      if (first_ring_) {
        triangle(before_ + step, start + step + 1, start + step);
      } else {
        triangle(before_ + step, before_ + step + 1, start + step);
        triangle(before_ + step + 1, start + step + 1, start + step);
      }
    }
    before_ = start;
    first_ring_ = false;
  }

  /// The vertices of a pole, one for each side, so that each has its place on the texture.
  std::uint32_t pole(Vec3 at, Vec3 normal, const Line& line, std::size_t i) {
    auto start = static_cast<std::uint32_t>(mesh_.surface.position.size());
    for (int k = 0; k < sides_; ++k)
      vertex(at, normal, Vec2((static_cast<float>(k) + 0.5f) / static_cast<float>(sides_), line.way[i]),
             line.node[i]);
    return before_ = start;
  }

  void close(Vec3 at, Vec3 normal, const Line& line, std::size_t i) {
    std::uint32_t ring = before_, tip = pole(at, normal, line, i);
    for (int k = 0; k < sides_; ++k) {
      auto step = static_cast<std::uint32_t>(k);
      triangle(ring + step, ring + step + 1, tip + step);
    }
  }

  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh_.surface.triangle.push_back({a, b, c});
  }

  TubeMesh& mesh_;
  int sides_;
  std::uint32_t before_ = 0;
  bool first_ring_ = true;
};

}  // namespace

TubeMesh branch_tubes(const Skeleton& rest, std::span<const Vec3> position, std::span<const float> radius,
                      float front, int sides) {
  TubeMesh mesh;
  Maker maker(mesh, sides);
  auto n = static_cast<std::int32_t>(rest.size());
  for (std::int32_t start = 0; start < n;) {
    std::int32_t below = rest.parent[start];
    if (below == Skeleton::kRoot) {
      ++start;
      continue;
    }
    std::int32_t stop = start + 1;
    while (stop < n && rest.parent[stop] == stop - 1) ++stop;
    Line line;
    auto add = [&](std::int32_t i, float thick) {
      Vec3 at = position[static_cast<std::size_t>(i)];
      if (!line.at.empty() && glm::distance(line.at.back(), at) < 1e-6f) return;
      line.at.push_back(at);
      line.radius.push_back(thick);
      line.way.push_back(rest.distance[i]);
      line.node.push_back(i == below ? start : i);
    };
    float foot = radius[static_cast<std::size_t>(below)];
    // A branch leaves its parent little thicker than it goes on, or the fork would swell.
    if (below != start - 1) foot = std::min(foot, 1.25f * radius[static_cast<std::size_t>(start)]);
    if (rest.birth[below] < front) add(below, foot);
    for (std::int32_t i = start; i < stop && rest.birth[rest.parent[i]] < front; ++i)
      add(i, radius[static_cast<std::size_t>(i)]);
    maker.add(line);
    start = stop;
  }
  return mesh;
}

}  // namespace frond
