#include "geometry/relief.h"

#include <algorithm>
#include <cmath>

namespace frond {

namespace {

constexpr int kMostCuts = 16;  // of a side

/// One triangle with what its corners know.
class Raiser {
 public:
  Raiser(const Surface& smooth, const Relief& relief, Surface& out)
      : smooth_(smooth), relief_(relief), out_(out) {}

  bool concerns(const std::array<std::uint32_t, 3>& t) const {
    return std::ranges::any_of(
        t, [&](auto i) { return relief_.share(smooth_.position[i], smooth_.normal[i]) > 0; });
  }

  void raise(const std::array<std::uint32_t, 3>& t, int cuts) {
    for (int k = 0; k < 3; ++k)
      at_[k] = smooth_.position[t[k]], normal_[k] = smooth_.normal[t[k]], uv_[k] = smooth_.uv[t[k]];
    set_slopes();
    auto start = static_cast<std::uint32_t>(out_.position.size());
    for (int row = 0; row <= cuts; ++row)
      for (int i = 0; i <= row; ++i) {
        float b = static_cast<float>(row - i) / static_cast<float>(cuts),
              c = static_cast<float>(i) / static_cast<float>(cuts);
        add(Vec3(1 - b - c, b, c));
      }
    auto index = [&](int row, int i) { return start + static_cast<std::uint32_t>(row * (row + 1) / 2 + i); };
    for (int row = 0; row < cuts; ++row)
      for (int i = 0; i <= row; ++i) {
        out_.triangle.push_back({index(row, i), index(row + 1, i), index(row + 1, i + 1)});
        if (i < row) out_.triangle.push_back({index(row, i), index(row + 1, i + 1), index(row, i + 1)});
      }
  }

 private:
  /// How a step in space changes uv: for the slope of the heights.
  void set_slopes() {
    Vec3 e = at_[1] - at_[0], f = at_[2] - at_[0];
    Vec2 p = uv_[1] - uv_[0], q = uv_[2] - uv_[0];
    float det = p.x * q.y - p.y * q.x;
    flat_ = std::abs(det) < 1e-12f;
    if (flat_) return;
    Vec3 du = (e * q.y - f * p.y) / det, dv = (f * p.x - e * q.x) / det;
    across_ = du / std::max(glm::dot(du, du), 1e-12f), along_ = dv / std::max(glm::dot(dv, dv), 1e-12f);
    step_ = Vec2(static_cast<float>(relief_.facet) / std::max(glm::length(du), 1e-6f),
                 static_cast<float>(relief_.facet) / std::max(glm::length(dv), 1e-6f));
  }

  void add(Vec3 w) {
    Vec3 at = at_[0] * w.x + at_[1] * w.y + at_[2] * w.z;
    Vec3 normal = glm::normalize(normal_[0] * w.x + normal_[1] * w.y + normal_[2] * w.z);
    Vec2 uv = uv_[0] * w.x + uv_[1] * w.y + uv_[2] * w.z;
    float share = relief_.share(at, normal), depth = static_cast<float>(relief_.depth) * share;
    // Phong tessellation (Boubekeur and Alexa 2008): onto the planes at the corners.
    Vec3 round(0);
    for (int k = 0; k < 3; ++k) round += (at - normal_[k] * glm::dot(at - at_[k], normal_[k])) * w[k];
    at += (round - at) * (0.75f * share);
    if (share > 0 && !flat_) {
      auto height = [&](float u, float v) { return relief_.height(uv + Vec2(u * step_.x, v * step_.y)); };
      at += normal * (depth * (height(0, 0) - 1));
      float du = (height(1, 0) - height(-1, 0)) / (2 * step_.x),
            dv = (height(0, 1) - height(0, -1)) / (2 * step_.y);
      normal = glm::normalize(normal - (across_ * du + along_ * dv) * depth);
    }
    out_.position.push_back(at), out_.normal.push_back(normal), out_.uv.push_back(uv);
  }

  const Surface& smooth_;
  const Relief& relief_;
  Surface& out_;
  Vec3 at_[3], normal_[3], across_{0}, along_{0};
  Vec2 uv_[3], step_{0};
  bool flat_ = false;
};

}  // namespace

Surface raised(const Surface& smooth, const Relief& relief) {
  Surface out = smooth;
  out.triangle.clear();
  out.paint.clear();
  Raiser raiser(smooth, relief, out);
  std::vector<std::array<std::uint32_t, 3>> near;
  std::vector<float> widths;
  for (const auto& t : smooth.triangle) {
    if (!raiser.concerns(t)) {
      out.triangle.push_back(t);
      continue;
    }
    near.push_back(t);
    float width = glm::distance(smooth.position[t[0]], smooth.position[t[2]]);
    for (int k = 0; k < 2; ++k)
      width = std::min(width, glm::distance(smooth.position[t[k]], smooth.position[t[k + 1]]));
    widths.push_back(width);
  }
  if (near.empty()) return out;
  // As many cuts of every side, or neighbours would gape.
  auto middle = widths.begin() + static_cast<std::ptrdiff_t>(widths.size() / 2);
  std::nth_element(widths.begin(), middle, widths.end());
  int cuts = std::clamp(static_cast<int>(std::ceil(*middle / relief.facet)), 1, kMostCuts);
  for (const auto& t : near) raiser.raise(t, cuts);
  return out;
}

}  // namespace frond
