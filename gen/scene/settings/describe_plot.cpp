#include "settings/describe_plot.h"

#include <fmt/format.h>

#include "preset/describe_spline.h"

namespace frond {

void describe_place(Properties& v, Moment& m) {
  v.angle("south", m.south, {.min = -360, .max = 360},
          "Direction in which south lies, where the sun stands at noon: 0 toward +z, 90 toward +x");
  v.angle("latitude", m.latitude, {.min = -90, .max = 90},
          "How far north of the equator it is: 0 tropics, 50 middle Europe; negative is south of it");
  v.number("day", m.day, {.min = 1, .max = 366},
           "Day of the year: 80 spring, 172 midsummer, 266 autumn, 355 midwinter of the north");
}

void describe(Properties& v, PondShape& p) {
  v.vector("center", p.center, metres(-28, 28), "Middle of the pond, x and z");
  v.vector("size", p.size, metres(0, 20),
           "Distance from the middle to the shore along x and along z; 0 is no pond");
  v.number("depth", p.depth, metres(0.1, 5), "Depth of the pond's bed below the lawn");
  v.number("level", p.level, metres(-2, 0), "Height of the water above the lawn; negative is below it");
}

void describe(Properties& v, PathShape& p) {
  v.list("points", p.points,
         "Points [x, z] in metres of a smooth curve, or objects with handles; fewer than two make no path");
  v.number("width", p.width, metres(0.1, 20), "Width of the path");
}

namespace {

constexpr Choice<GroundArea::Kind> kAreaKinds[] = {
    {"gravel", GroundArea::Kind::gravel, "as on the path"},
    {"earth", GroundArea::Kind::earth, "as in a bed of flowers, raised a little"}};

constexpr double kMostPoints = 200;
constexpr double kLongestPath = 10'000;  // metres

}  // namespace

void describe(Properties& v, GroundArea& a) {
  v.choice("kind", a.kind, kAreaKinds, "What lies on the area");
  v.vector("center", a.center, metres(-30, 30), "Middle of the area, x and z");
  v.vector("size", a.size, metres(0.05, 60), "Extent of the area along x and along z");
  v.list("outline", a.outline, Count{3, 400},
         "Corners [x, z] in metres of an area of another shape, or objects with handles, in place of center "
         "and size");
  v.boolean("curve", a.curve, "Whether the outline is smooth at corners without handles, too");
}

void check_path(Errors& list, const PathShape& path, const std::string& pointer, double reach) {
  if (static_cast<double>(path.points.size()) > kMostPoints)
    return list.push_back(
        error_at(pointer, "found {} points; expected {:g} at most", path.points.size(), kMostPoints));
  double length = 0;
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    if (glm::length(glm::dvec2(path.points[i].at)) > reach)
      return list.push_back(error_at(fmt::format("{}/{}", pointer, i),
                                     "lies off the ground; expected a place within {:g} m of the middle",
                                     reach));
    if (i > 0) length += glm::distance(path.points[i - 1].at, path.points[i].at);
  }
  if (length > kLongestPath)
    list.push_back(
        error_at(pointer, "makes a path of {:.3g} m; expected {:g} m at most", length, kLongestPath));
}

}  // namespace frond
