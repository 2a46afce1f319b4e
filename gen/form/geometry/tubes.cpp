#include "geometry/tubes.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "geometry/far.h"

namespace frond {

namespace {

Vec3 any_normal(Vec3 axis) { return glm::normalize(glm::cross(axis, reference_axis(axis))); }

/// The normal of the next ring, a step farther on: it turns about the branch no more than it must (double
/// reflection; Wang et al. 2008). `along` and `next` are the directions of the branch at both rings.
Vec3 carried_normal(Vec3 normal, Vec3 step, Vec3 along, Vec3 next) {
  if (float c = glm::dot(step, step); c > 1e-14f) {
    normal -= step * (2 / c * glm::dot(step, normal));
    along -= step * (2 / c * glm::dot(step, along));
  }
  Vec3 over = next - along;
  if (float d = glm::dot(over, over); d > 1e-12f) normal -= over * (2 / d * glm::dot(over, normal));
  normal -= next * glm::dot(next, normal);
  return glm::length(normal) > 1e-6f ? glm::normalize(normal) : any_normal(next);
}

float girth_of(const Skeleton& rest, const TubeShape& shape, std::int32_t node) {
  return shape.girth.empty() ? rest.radius[node] : shape.girth[node];
}

bool too_thin(const Skeleton& rest, const TubeShape& shape, std::int32_t first) {
  return girth_of(rest, shape, first) < shape.least && rest.order[first] > 0;
}

/// How many chords a circle takes that are a quarter of a grain away from it at most.
int round_sides(float radius, float grain) {
  return static_cast<int>(std::ceil(4.5f * std::sqrt(radius / grain)));
}

/// One chain of nodes as a tube.
class Tube {
 public:
  Tube(const Skeleton& rest, std::span<const Vec3> position, std::span<const float> radius,
       std::span<const Quat> turn, const TubeShape& shape, TubeMesh& mesh)
      : rest_(rest),
        position_(position),
        radius_(radius),
        turn_(turn),
        shape_(shape),
        out_(mesh.surface),
        node_(mesh.node) {}

  /// Adds the tube of the nodes first..last; it begins at the node below `first`, where there is one.
  void add(std::int32_t first, std::int32_t last) {
    nodes_.clear();
    std::int32_t below = rest_.parent[first];
    fork_ = below != Skeleton::kRoot;
    if (fork_) nodes_.push_back(below);
    for (std::int32_t i = first; i <= last; ++i) nodes_.push_back(i);
    if (nodes_.size() < 2) return;
    float thick = 0;
    for (std::size_t k = fork_ ? 1 : 0; k < nodes_.size(); ++k)
      thick = std::max(thick, girth_of(rest_, shape_, nodes_[k]));
    if (too_thin(rest_, shape_, first)) return;
    leave_out_nodes();
    set_normals_along();
    double round = 2 * kPi * thick;
    sides_ = std::clamp(static_cast<int>(std::lround(round / shape_.side)), 3, shape_.most_sides);
    if (shape_.grain > 0)
      sides_ = std::clamp(round_sides(thick, static_cast<float>(shape_.grain)), 3, sides_);
    lobed_ = shape_.lobes > 0 && rest_.order[first] == 0;
    if (lobed_) sides_ = std::max(8 * shape_.lobes, sides_ / shape_.lobes * shape_.lobes);
    wraps_ = std::max(1, static_cast<int>(std::lround(round / shape_.wrap)));
    double pattern = round / wraps_ * shape_.aspect, along = 0;
    auto start = static_cast<std::uint32_t>(out_.position.size());
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
      if (k > 0) along += lengths_[k];
      ring(k, along / pattern);
    }
    stitch(start, pattern);
    node_.resize(out_.position.size(), nodes_.back());  // those of the tip
  }

 private:
  /// Leaves out nodes whose absence shows nowhere. Sets the length of branch, at rest, before each that is
  /// left, so that the picture stays where it is.
  void leave_out_nodes() {
    lengths_.assign(1, 0.0f);
    for (std::size_t k = 1; k < nodes_.size(); ++k)
      lengths_.push_back(glm::distance(rest_.position[nodes_[k]], rest_.position[nodes_[k - 1]]));
    if (shape_.grain <= 0) return;
    std::vector<glm::vec4> chain;
    for (std::int32_t i : nodes_) chain.emplace_back(position_[i], radius_[i]);
    std::vector<char> kept(nodes_.size(), 0);
    mark_bends(chain, static_cast<float>(shape_.grain / 4), kept);
    if (fork_) kept[1] = 1;  // it leaves its fork in its own direction
    // Where growth has come to, the picture is cut off and not squeezed.
    for (std::size_t k = 1; k < nodes_.size(); ++k)
      if (glm::distance(Vec3(chain[k]), Vec3(chain[k - 1])) < 0.99f * lengths_[k]) kept[k] = kept[k - 1] = 1;
    std::size_t count = 0;
    float length = 0;
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
      length += lengths_[k];
      if (!kept[k]) continue;
      nodes_[count] = nodes_[k];
      lengths_[count++] = std::exchange(length, 0.0f);
    }
    nodes_.resize(count), lengths_.resize(count);
  }

  /// Normals of the rest shape that do not twist.
  void set_normals_along() {
    normals_.clear();
    axes_.clear();
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
      Vec3 offset = rest_.position[nodes_[far_as_thick(k, 1)]] - rest_.position[nodes_[far_as_thick(k, -1)]];
      // A branch leaves its fork in its own direction.
      if (fork_ && k == 0) offset = rest_.position[nodes_[1]] - rest_.position[nodes_[0]];
      axes_.push_back(glm::length(offset) > 1e-9f ? glm::normalize(offset)
                      : k > 0                     ? axes_.back()
                                                  : Vec3(0, 1, 0));
    }
    normals_.push_back(any_normal(axes_[0]));
    for (std::size_t k = 1; k < nodes_.size(); ++k) {
      Vec3 step = rest_.position[nodes_[k]] - rest_.position[nodes_[k - 1]];
      normals_.push_back(carried_normal(normals_.back(), step, axes_[k - 1], axes_[k]));
    }
  }

  /// The next place along the branch that is a radius away, or its end: rings of a thick branch of short
  /// internodes that stood across each of them would cut into each other where it bends.
  /// By what it grows to, so that they do not turn while it thickens.
  std::size_t far_as_thick(std::size_t k, std::ptrdiff_t step) const {
    float reach = girth_of(rest_, shape_, nodes_[k]);
    std::size_t end = step > 0 ? nodes_.size() - 1 : 0, at = k;
    while (at != end) {
      at += static_cast<std::size_t>(step);
      if (glm::distance(rest_.position[nodes_[at]], rest_.position[nodes_[k]]) >= reach) break;
    }
    return at;
  }

  float radius_of(std::size_t k) const {
    // The foot of a branch is little thicker than it goes on, or forks would swell.
    if (fork_ && k == 0) return std::min(radius_[nodes_[0]], 1.25f * radius_[nodes_[1]]);
    return radius_[nodes_[k]];
  }

  void ring(std::size_t k, double v) {
    std::int32_t node = nodes_[k], own = fork_ && k == 0 ? nodes_[1] : node;
    Quat turn = turn_.empty() ? Quat(1, 0, 0, 0) : turn_[own];
    node_.resize(node_.size() + static_cast<std::size_t>(sides_) + 1, own);
    Vec3 x = turn * normals_[k], axis = turn * axes_[k], y = glm::cross(axis, x), at = position_[node];
    float r = radius_of(k);
    // How fast it thins tilts the normals.
    std::size_t before = k > 0 ? k - 1 : k, after = std::min(k + 1, nodes_.size() - 1);
    float length = glm::distance(position_[nodes_[after]], position_[nodes_[before]]);
    float thin =
        length > 1e-6f ? std::clamp((radius_of(before) - radius_of(after)) / length, -2.0f, 2.0f) : 0;
    for (int s = 0; s <= sides_; ++s) {
      double a = 2 * kPi * (s % sides_) / sides_, lobe = 1, swing = 0;
      if (lobed_) {
        lobe = 1 + shape_.lobe_depth * std::sin(shape_.lobes * a);
        swing = shape_.lobe_depth * shape_.lobes * std::cos(shape_.lobes * a);
      }
      auto c = static_cast<float>(std::cos(a)), d = static_cast<float>(std::sin(a));
      Vec3 out = x * c + y * d, round = y * c - x * d;
      out_.position.push_back(at + out * (r * static_cast<float>(lobe)));
      out_.normal.push_back(
          glm::normalize(out * static_cast<float>(lobe) - round * static_cast<float>(swing) + axis * thin));
      out_.uv.emplace_back(static_cast<double>(wraps_ * s) / sides_, v);
    }
  }

  void stitch(std::uint32_t start, double pattern) {
    auto n = static_cast<std::uint32_t>(sides_) + 1, rings = static_cast<std::uint32_t>(nodes_.size());
    stitch_rows(out_, start, rings, n);
    // The end is closed by a point a little farther on, which has the place on the picture of each side.
    std::uint32_t last = start + (rings - 1) * n;
    std::int32_t node = nodes_.back();
    float beyond = radius_[node] * 0.6f;
    Vec2 on(0, beyond / static_cast<float>(pattern));
    Vec3 axis = turn_.empty() ? axes_.back() : turn_[node] * axes_.back();
    auto tip = static_cast<std::uint32_t>(out_.position.size());
    for (std::uint32_t s = 0; s + 1 < n; ++s) {
      out_.position.push_back(position_[node] + axis * beyond);
      out_.normal.push_back(axis);
      out_.uv.push_back((out_.uv[last + s] + out_.uv[last + s + 1]) * 0.5f + on);
      out_.triangle.push_back({last + s, last + s + 1, tip + s});
    }
  }

  const Skeleton& rest_;
  std::span<const Vec3> position_;
  std::span<const float> radius_;
  std::span<const Quat> turn_;
  const TubeShape& shape_;
  Surface& out_;
  std::vector<std::int32_t>& node_;  // of each vertex
  std::vector<std::int32_t> nodes_;  // of the chain
  std::vector<float> lengths_;       // of the chain before each
  std::vector<Vec3> normals_, axes_;
  bool fork_ = false, lobed_ = false;
  int sides_ = 3, wraps_ = 1;
};

constexpr int kCapRings = 2;  // between the last ring of a branch and the pole of its end

/// The middle line of one branch.
struct Line {
  std::vector<Vec3> at, along;  // along: of length 1
  std::vector<float> radius, distance;
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

/// Branches as closed tubes.
class Closer {
 public:
  explicit Closer(TubeMesh& mesh) : mesh_(mesh) {}

  void add(Line& line, int sides) {
    if (line.at.size() < 2) return;
    sides_ = sides;
    set_directions(line);
    Vec3 along = line.along[0];
    Vec3 side = -any_normal(along);
    first_ring_ = true;
    // The foot lies in what it grows from: a flat cone closes it.
    pole(line.at[0] - along * (0.5f * line.radius[0]), -along, line, 0, -1.118f * line.radius[0]);
    for (std::size_t i = 0; i < line.at.size(); ++i) {
      if (i > 0) side = carried_normal(side, line.at[i] - line.at[i - 1], line.along[i - 1], line.along[i]);
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
           last, radius * turn);
    }
    close(tip + end * radius, end, line, last, radius * static_cast<float>(kPi / 2));
  }

 private:
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
      Vec2 uv(static_cast<float>(k) / static_cast<float>(sides_), line.distance[i] + beyond);
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
  std::uint32_t pole(Vec3 at, Vec3 normal, const Line& line, std::size_t i, float beyond) {
    auto start = static_cast<std::uint32_t>(mesh_.surface.position.size());
    Vec2 uv(0.5f / static_cast<float>(sides_), line.distance[i] + beyond);
    for (int k = 0; k < sides_; ++k, uv.x += 1.0f / static_cast<float>(sides_))
      vertex(at, normal, uv, line.node[i]);
    return before_ = start;
  }

  void close(Vec3 at, Vec3 normal, const Line& line, std::size_t i, float beyond) {
    std::uint32_t ring = before_, tip = pole(at, normal, line, i, beyond);
    for (int k = 0; k < sides_; ++k) {
      auto step = static_cast<std::uint32_t>(k);
      triangle(ring + step, ring + step + 1, tip + step);
    }
  }

  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh_.surface.triangle.push_back({a, b, c});
  }

  TubeMesh& mesh_;
  int sides_ = 3;
  std::uint32_t before_ = 0;
  bool first_ring_ = true;
};

}  // namespace

std::vector<bool> left_out(const Skeleton& rest, const TubeShape& shape) {
  std::vector<bool> out(rest.size());
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(rest.size()); ++i)
    out[i] = i > 0 && rest.parent[i] == i - 1 ? out[i - 1] : too_thin(rest, shape, i);
  return out;
}

TubeMesh tube_mesh(const Skeleton& rest, std::span<const Vec3> position, std::span<const float> radius,
                   std::span<const Quat> turn, const TubeShape& shape) {
  TubeMesh mesh;
  Tube tube(rest, position, radius, turn, shape, mesh);
  auto n = static_cast<std::int32_t>(rest.size());
  for (std::int32_t first = 0; first < n;) {
    std::int32_t last = chain_end(rest, first);
    tube.add(first, last);
    first = last + 1;
  }
  return mesh;
}

Surface tube_surface(const Skeleton& rest, std::span<const Vec3> position, std::span<const float> radius,
                     std::span<const Quat> turn, const TubeShape& shape) {
  return tube_mesh(rest, position, radius, turn, shape).surface;
}

Surface tube_surface(const Skeleton& rest, const TubeShape& shape) {
  return tube_surface(rest, rest.position, rest.radius, {}, shape);
}

TubeMesh closed_tubes(const Skeleton& rest, std::span<const Vec3> position, std::span<const float> radius,
                      float front, int sides, float grain) {
  TubeMesh mesh;
  Closer closer(mesh);
  auto n = static_cast<std::int32_t>(rest.size());
  for (std::int32_t start = 0; start < n;) {
    std::int32_t below = rest.parent[start];
    if (below == Skeleton::kRoot) {
      ++start;
      continue;
    }
    std::int32_t stop = chain_end(rest, start) + 1;
    Line line;
    auto add = [&](std::int32_t i, float thick) {
      Vec3 at = position[i];
      if (!line.at.empty() && glm::distance(line.at.back(), at) < 1e-6f) return;
      line.at.push_back(at);
      line.radius.push_back(thick);
      line.distance.push_back(rest.distance[i]);
      line.node.push_back(i == below ? start : i);
    };
    float foot = radius[below];
    // A branch leaves its parent little thicker than it goes on, or the fork would swell.
    if (below != start - 1) foot = std::min(foot, 1.25f * radius[start]);
    if (rest.birth[below] < front) add(below, foot);
    for (std::int32_t i = start; i < stop && rest.birth[rest.parent[i]] < front; ++i) add(i, radius[i]);
    float thickest = line.radius.empty() ? 0 : std::ranges::max(line.radius);
    closer.add(line, grain > 0 ? std::clamp(round_sides(thickest, grain), 5, std::max(5, sides)) : sides);
    start = stop;
  }
  return mesh;
}

}  // namespace frond
