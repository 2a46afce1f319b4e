#include "crown/axes.h"

#include <algorithm>

#include "core/polyline.h"

namespace frond {

double GuideAxis::length() const { return polyline_length(std::span<const Vec3>(at)); }

Vec3 GuideAxis::point(double along) const { return polyline_point(std::span<const Vec3>(at), along).at; }

std::vector<GuideAxis> axes_of(const GuideAxes& guides) {
  constexpr float kSame = 1e-6f;  // metres
  const std::vector<GuideAxes::Point>& points = guides.points;
  std::size_t n = points.size();
  auto parent_at = [&](std::size_t i) {
    return points[i].parent < 0 ? Vec3(0) : points[static_cast<std::size_t>(points[i].parent)].at;
  };
  // The longest way on from each point, its own step included.
  std::vector<double> longest(n, 0);
  for (std::size_t i = n; i-- > 0;) {
    longest[i] += static_cast<double>(glm::distance(parent_at(i), points[i].at));
    if (points[i].parent >= 0) {
      double& below = longest[static_cast<std::size_t>(points[i].parent)];
      below = std::max(below, longest[i]);
    }
  }
  // Which child goes on with its parent's axis; of the foot's, too.
  std::vector<std::size_t> next(n + 1, n);
  for (std::size_t i = 0; i < n; ++i) {
    std::size_t& best = next[static_cast<std::size_t>(points[i].parent + 1)];
    if (best == n || longest[i] > longest[best]) best = i;
  }
  std::vector<GuideAxis> axes;
  if (n > 0) axes.push_back({{Vec3(0)}, 0, -1});
  std::vector<std::int32_t> axis(n, 0);
  std::vector<double> along(n, 0);  // metres from the foot
  for (std::size_t i = 0; i < n; ++i) {
    bool foot = points[i].parent < 0;
    std::size_t parent = foot ? 0 : static_cast<std::size_t>(points[i].parent);
    double before = foot ? 0 : along[parent];
    along[i] = before + static_cast<double>(glm::distance(parent_at(i), points[i].at));
    axis[i] = foot ? 0 : axis[parent];
    if (next[static_cast<std::size_t>(points[i].parent + 1)] != i) {
      axes.push_back({{parent_at(i)}, before, axis[i]});
      axis[i] = static_cast<std::int32_t>(axes.size()) - 1;
    }
    GuideAxis& own = axes[static_cast<std::size_t>(axis[i])];
    if (glm::distance(own.at.back(), points[i].at) > kSame) own.at.push_back(points[i].at);
  }
  return axes;
}

}  // namespace frond
