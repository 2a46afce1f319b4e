#include "settings/plot_bounds.h"

#include <fmt/format.h>

namespace frond {

namespace {

constexpr double kMostPoints = 200;
constexpr double kLongestPath = 10'000;  // metres

}  // namespace

void check_path(Errors& list, const PathShape& path, const std::string& pointer, double reach) {
  if (static_cast<double>(path.points.size()) > kMostPoints)
    return list.push_back(
        {pointer, fmt::format("found {} points; expected {:g} at most", path.points.size(), kMostPoints)});
  double length = 0;
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    if (glm::length(glm::dvec2(path.points[i].at)) > reach)
      return list.push_back(
          {fmt::format("{}/{}", pointer, i),
           fmt::format("lies off the ground; expected a place within {:g} m of the middle", reach)});
    if (i > 0) length += glm::distance(path.points[i - 1].at, path.points[i].at);
  }
  if (length > kLongestPath)
    list.push_back(
        {pointer, fmt::format("makes a path of {:.3g} m; expected {:g} m at most", length, kLongestPath)});
}

}  // namespace frond
