#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/parallel.h"
#include "core/triangle.h"
#include "organisms/school/swim.h"

namespace frond {

namespace {

constexpr float kFar = 1e12f;
constexpr float kHalfDiagonal = 0.87f;  // of a cell
constexpr int kMoments = 12;            // of a film at which what sways is looked at

/// The lower envelope of parabolas along one line, in place: f(p) becomes the least (p - q)^2 + f(q).
void sweep_line(std::vector<float>& f, std::vector<float>& out, std::vector<int>& hull,
                std::vector<float>& from) {
  int n = static_cast<int>(f.size()), k = -1;
  for (int q = 0; q < n; ++q) {
    if (f[static_cast<std::size_t>(q)] >= kFar) continue;
    float start = -kFar;
    while (k >= 0) {
      int v = hull[static_cast<std::size_t>(k)];
      float own = f[static_cast<std::size_t>(q)] + static_cast<float>(q) * static_cast<float>(q);
      float other = f[static_cast<std::size_t>(v)] + static_cast<float>(v) * static_cast<float>(v);
      start = (own - other) / static_cast<float>(2 * (q - v));
      if (start > from[static_cast<std::size_t>(k)]) break;
      --k;
    }
    if (k < 0) start = -kFar;
    ++k;
    hull[static_cast<std::size_t>(k)] = q;
    from[static_cast<std::size_t>(k)] = start;
  }
  if (k < 0) return;
  int last = k;
  k = 0;
  for (int p = 0; p < n; ++p) {
    while (k < last && from[static_cast<std::size_t>(k + 1)] < static_cast<float>(p)) ++k;
    int v = hull[static_cast<std::size_t>(k)];
    out[static_cast<std::size_t>(p)] = static_cast<float>((p - v) * (p - v)) + f[static_cast<std::size_t>(v)];
  }
  f.swap(out);
}

void add_skeleton(Clearance& grid, const Skeleton& rest, const Pose& pose) {
  for (std::size_t i = 0; i < rest.size(); ++i) {
    std::int32_t parent = rest.parent[i];
    if (parent < 0) {
      grid.add(pose.position[i], pose.radius[i]);
      continue;
    }
    auto p = static_cast<std::size_t>(parent);
    grid.add(pose.position[p], pose.position[i], pose.radius[p], pose.radius[i]);
  }
}

}  // namespace

Clearance::Clearance(Vec3 low, Vec3 high, float cell) : low_(low), cell_(cell) {
  std::size_t all = 1;
  for (int axis = 0; axis < 3; ++axis) {
    size_[axis] = std::max(2, static_cast<int>(std::ceil((high[axis] - low[axis]) / cell)));
    all *= static_cast<std::size_t>(size_[axis]);
  }
  distance_.assign(all, kFar);
}

void Clearance::add(Vec3 middle, float radius) {
  float reach = radius + kHalfDiagonal * cell_;
  int from[3], to[3];
  for (int axis = 0; axis < 3; ++axis) {
    float at = (middle[axis] - low_[axis]) / cell_ - 0.5f, wide = reach / cell_;
    if (!(at + wide > 0 && at - wide < static_cast<float>(size_[axis]))) return;
    from[axis] = std::max(0, static_cast<int>(std::ceil(at - wide)));
    to[axis] = std::min(size_[axis] - 1, static_cast<int>(std::floor(at + wide)));
  }
  for (int z = from[2]; z <= to[2]; ++z)
    for (int y = from[1]; y <= to[1]; ++y)
      for (int x = from[0]; x <= to[0]; ++x) {
        Vec3 off = low_ + cell_ * (Vec3(x, y, z) + 0.5f) - middle;
        if (glm::dot(off, off) <= reach * reach) distance_[index(x, y, z)] = 0;
      }
}

void Clearance::add(Vec3 a, Vec3 b, float radius_a, float radius_b) {
  constexpr float kApart = 0.7f;  // cells, from ball to ball along the rod
  int parts = std::max(1, static_cast<int>(std::ceil(glm::distance(a, b) / (kApart * cell_))));
  for (int i = 0; i <= parts; ++i) {
    float t = static_cast<float>(i) / static_cast<float>(parts);
    add(a + (b - a) * t, radius_a + (radius_b - radius_a) * t);
  }
}

void Clearance::add(const Surface& surface) {
  Vec3 top = high();
  for (const auto& [a, b, c] : surface.triangle) {
    Vec3 p = surface.position[a], q = surface.position[b], r = surface.position[c];
    Vec3 least = glm::min(p, glm::min(q, r)), most = glm::max(p, glm::max(q, r));
    if (glm::any(glm::greaterThan(least, top)) || glm::any(glm::lessThan(most, low_))) continue;
    over_triangle(p, q, r, cell_, [&](Vec3 at) { add(at, 0); });
  }
}

void Clearance::add_ground(const World& world) {
  for (int z = 0; z < size_[2]; ++z)
    for (int x = 0; x < size_[0]; ++x) {
      Vec3 at = low_ + cell_ * (Vec3(x, 0, z) + 0.5f);
      auto high = static_cast<float>(world.height({at.x, at.z}));
      for (int y = 0; y < size_[1] && low_.y + cell_ * static_cast<float>(y) <= high; ++y)
        distance_[index(x, y, z)] = 0;
    }
}

void Clearance::measure() {
  const std::size_t stride[] = {1, static_cast<std::size_t>(size_[0]),
                                static_cast<std::size_t>(size_[0]) * static_cast<std::size_t>(size_[1])};
  for (int axis = 0; axis < 3; ++axis) {
    int a = (axis + 1) % 3, b = (axis + 2) % 3;
    auto n = static_cast<std::size_t>(size_[axis]);
    parallel_for(static_cast<std::size_t>(size_[a]), [&](std::size_t i) {
      std::vector<float> line(n), out(n), from(n + 1);
      std::vector<int> hull(n + 1);
      for (std::size_t j = 0; j < static_cast<std::size_t>(size_[b]); ++j) {
        std::size_t first = i * stride[a] + j * stride[b];
        for (std::size_t k = 0; k < n; ++k) line[k] = distance_[first + k * stride[axis]];
        sweep_line(line, out, hull, from);
        for (std::size_t k = 0; k < n; ++k) distance_[first + k * stride[axis]] = line[k];
      }
    });
  }
  float most = glm::distance(low_, high());
  for (float& d : distance_) d = d >= kFar ? most : std::min(most, cell_ * (std::sqrt(d) - 0.5f));
}

float Clearance::operator()(Vec3 at) const {
  assert(std::isfinite(glm::dot(at, at)) && "a fish at a finite place");
  int cell[3];
  float share[3];
  for (int axis = 0; axis < 3; ++axis) {
    float x = std::clamp((at[axis] - low_[axis]) / cell_ - 0.5f, 0.0f, static_cast<float>(size_[axis] - 1));
    cell[axis] = std::min(static_cast<int>(x), size_[axis] - 2);
    share[axis] = x - static_cast<float>(cell[axis]);
  }
  float sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    int dx = corner & 1, dy = corner >> 1 & 1, dz = corner >> 2;
    float weight =
        (dx ? share[0] : 1 - share[0]) * (dy ? share[1] : 1 - share[1]) * (dz ? share[2] : 1 - share[2]);
    sum += weight * distance_[index(cell[0] + dx, cell[1] + dy, cell[2] + dz)];
  }
  return sum;
}

Vec3 Clearance::away(Vec3 at) const {
  Vec3 slope;
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 step(0);
    step[axis] = cell_;
    slope[axis] = ((*this)(at + step) - (*this)(at - step)) / (2 * cell_);
  }
  return slope;
}

Clearance clearance_of(const World& world, Vec3 low, Vec3 high, float cell) {
  Clearance grid(low, high, cell);
  grid.add_ground(world);
  grid.add(world.stones());
  int moments = world.filmed() ? kMoments : 1;
  for (const Specimen& s : world.standing()) {
    if (s.model.solids.size() > 0 || !s.model.hull.triangle.empty()) grid.add(skin_of(s.model));
    grid.add(s.model.blades.surface);
    if (s.model.skeleton.size() == 0) continue;
    // What grows is there in full: fish do not know that it is not there yet.
    Motion grown = s.motion;
    grown.growth = {};
    bool moves = grown.wave.amplitude > 0 || grown.food.pulls();
    Pose pose;
    for (int k = 0; k < (moves ? moments : 1); ++k) {
      pose_skeleton(s.model.skeleton, grown, world.film_length() * k / moments, pose);
      add_skeleton(grid, s.model.skeleton, pose);
    }
  }
  grid.measure();
  return grid;
}

}  // namespace frond
