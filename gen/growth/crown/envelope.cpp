#include "crown/envelope.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/bounds.h"

namespace frond {

namespace {

struct BoundsOf {
  Bounds operator()(const EllipsoidCrown& e) const { return {e.middle - e.half, e.middle + e.half}; }
  Bounds operator()(const ConeCrown& c) const {
    auto wide = static_cast<float>(std::max(c.low, c.high));
    return {c.foot - Vec3(wide, 0, wide), c.foot + Vec3(wide, c.height, wide)};
  }
  Bounds operator()(const MeshCrown& m) const {
    if (m.surface.position.empty()) return {Vec3(0), Vec3(0)};
    return bounds_of(m.surface.position);
  }
  Bounds operator()(const SilhouetteCrown& s) const {
    auto height = static_cast<float>(s.height);
    float half = 0.5f * s.outline.width() * height, deep = static_cast<float>(s.depth) / 2;
    if (s.depth <= 0) deep = half;
    return {s.foot - Vec3(half, 0, deep), s.foot + Vec3(half, height, deep)};
  }
};

}  // namespace

Envelope::Envelope(EnvelopeShape shape) : shape_(std::move(shape)) {
  Bounds bounds = std::visit(BoundsOf{}, shape_);
  low_ = bounds.low;
  high_ = bounds.high;
  const auto* mesh = std::get_if<MeshCrown>(&shape_);
  if (!mesh) return;
  columns_ =
      std::clamp(static_cast<int>(std::sqrt(static_cast<double>(mesh->surface.triangle.size()))), 1, 256);
  cells_.resize(static_cast<std::size_t>(columns_ * columns_));
  Vec3 size = glm::max(high_ - low_, Vec3(1e-6f));
  auto column = [&](float at, float from, float wide) {
    return std::clamp(static_cast<int>((at - from) / wide * static_cast<float>(columns_)), 0, columns_ - 1);
  };
  for (std::uint32_t t = 0; t < mesh->surface.triangle.size(); ++t) {
    auto [a, b, c] = mesh->surface.triangle[t];
    const auto& p = mesh->surface.position;
    Vec3 from = glm::min(glm::min(p[a], p[b]), p[c]), to = glm::max(glm::max(p[a], p[b]), p[c]);
    for (int z = column(from.z, low_.z, size.z); z <= column(to.z, low_.z, size.z); ++z)
      for (int x = column(from.x, low_.x, size.x); x <= column(to.x, low_.x, size.x); ++x)
        cells_[static_cast<std::size_t>(z * columns_ + x)].push_back(t);
  }
}

bool Envelope::inside_mesh(const MeshCrown& mesh, Vec3 at) const {
  assert(columns_ > 0 && cells_.size() == static_cast<std::size_t>(columns_ * columns_));
  Vec3 share = (at - low_) / glm::max(high_ - low_, Vec3(1e-6f)) * static_cast<float>(columns_);
  int x = std::clamp(static_cast<int>(share.x), 0, columns_ - 1);
  int z = std::clamp(static_cast<int>(share.z), 0, columns_ - 1);
  bool in = false;
  for (std::uint32_t t : cells_[static_cast<std::size_t>(z * columns_ + x)]) {
    auto [i, j, k] = mesh.surface.triangle[t];
    DVec3 a(mesh.surface.position[i]), b(mesh.surface.position[j]), c(mesh.surface.position[k]), p(at);
    // Barycentric places of the point on the triangle seen from above; edges belong to one side only.
    auto side = [&](const DVec3& u, const DVec3& v) {
      return (v.x - u.x) * (p.z - u.z) - (v.z - u.z) * (p.x - u.x);
    };
    double ab = side(a, b), bc = side(b, c), ca = side(c, a), whole = ab + bc + ca;
    bool hit = (ab >= 0 && bc >= 0 && ca >= 0 && whole > 0) || (ab < 0 && bc < 0 && ca < 0);
    if (hit && (bc * a.y + ca * b.y + ab * c.y) / whole > p.y) in = !in;
  }
  return in;
}

bool Envelope::inside(Vec3 at) const {
  if (glm::any(glm::lessThan(at, low_)) || glm::any(glm::greaterThan(at, high_))) return false;
  if (const auto* e = std::get_if<EllipsoidCrown>(&shape_)) {
    Vec3 d = (at - e->middle) / e->half;
    return glm::dot(d, d) <= 1;
  }
  if (const auto* c = std::get_if<ConeCrown>(&shape_)) {
    double t = (at.y - c->foot.y) / c->height;
    return std::hypot(at.x - c->foot.x, at.z - c->foot.z) <= c->low + (c->high - c->low) * t;
  }
  if (const auto* m = std::get_if<MeshCrown>(&shape_)) return inside_mesh(*m, at);
  const auto& s = std::get<SilhouetteCrown>(shape_);
  Vec3 d = (at - s.foot) / static_cast<float>(s.height);
  float across = s.depth > 0 ? d.x : std::hypot(d.x, d.z);
  return s.outline.inside(Vec2(across, d.y));
}

std::vector<Vec3> Envelope::sample(int count, Seed seed) const {
  assert(glm::all(glm::lessThanEqual(low_, high_)));
  constexpr std::uint64_t kTriesInVain = 200'000;  // until it is clear that there is next to no room
  std::vector<Vec3> places;
  Vec3 size = high_ - low_;
  std::uint64_t most = 400ull * static_cast<std::uint64_t>(std::max(count, 0));
  for (std::uint64_t i = 0; i < most && places.size() < static_cast<std::size_t>(count); ++i) {
    Seed own = seed.child(i);
    Vec3 at = low_ + size * Vec3(own.child(0).unit(), own.child(1).unit(), own.child(2).unit());
    if (inside(at)) places.push_back(at);
    if (places.empty() && i == kTriesInVain) break;
  }
  return places;
}

}  // namespace frond
