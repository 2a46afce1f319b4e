#include "settings/garden.h"

#include "core/linear.h"
#include "core/polyline.h"
#include "settings/describe_plot.h"
#include "settings/meadow.h"
#include "settings/settings.h"

namespace frond {

void describe(Properties& v, Garden& g) {
  v.animated("hour", g.hour, kHours,
             "Hour of the day, which places the sun: 6 dawn, 12 noon, 19 dusk; with keyframes a day goes by");
  describe_place(v, g.when);
  v.object("pond", g.pond, "The pond");
  v.object("path", g.path, "The gravel path");
  v.list("areas", g.areas, Count{0, 1000},
         "Areas of gravel or of bare earth in the lawn; a plan adds its ways and rooms to them");
  v.integer("lilies", g.lilies, {.min = 0, .max = 2000}, "Number of leaves of water lilies on the pond");
  v.number("gravel", g.gravel, metres(0.02, 1), "Size of the stones on the path");
  v.number("clods", g.clods, metres(0.01, 1), "Size of the clods of earth in beds");
  v.color("gravel_color", g.gravel_color, "Colour of the stones on the path");
  v.color("earth_color", g.earth_color, "Colour of bare earth");
}

namespace {

constexpr double kLand = 150;  // metres from the middle

/// Square metres of the boxes of areas of a kind.
double square_metres(const Garden& garden, GroundArea::Kind kind) {
  double sum = 0;
  for (const GroundArea& area : garden.areas)
    if (area.kind == kind) {
      auto [low, high] = area.box();
      sum += static_cast<double>((high.x - low.x) * (high.y - low.y));
    }
  return sum;
}

void check_stones(Errors& list, const Garden& garden) {
  std::vector<Vec2> points = spline_points(garden.path.points);
  double path = polyline_length(std::span<const Vec2>(points)) * garden.path.width;
  auto check = [&](const char* pointer, double size, double covered, const char* what) {
    double side = 10 * size, patches = covered / (side * side);
    if (patches > kMostPatches)
      list.push_back(error_at(pointer,
                              "stones of {:g} m take {:.2g} patches on such {}; expected {:g} at most, by "
                              "larger ones or less of it",
                              size, patches, what, kMostPatches));
  };
  check("/garden/gravel", garden.gravel, path + square_metres(garden, GroundArea::Kind::gravel), "a path");
  check("/garden/clods", garden.clods, square_metres(garden, GroundArea::Kind::earth), "earth");
}

}  // namespace

SettingRow garden_setting() {
  return setting_row<Garden>(
      "garden", "a lawn with pond and path at any hour of the day", "garden",
      "Hour, pond and path, for garden; lawn and sky are the meadow's",
      {"/garden",
       "/meadow/grass",
       "/meadow/haze",
       "/meadow/clouds",
       "/meadow/turbidity",
       "/meadow/moon",
       "/meadow/zenith",
       "/meadow/horizon",
       "/meadow/blade",
       "/meadow/blades",
       "/meadow/extent",
       "/meadow/flowers",
       "/meadow/plants",
       "/meadow/bare",
       "/meadow/grass_map",
       "/floor/relief",
       "/floor/scale",
       "/snow",
       "/rain",
       "/air",
       "/far",
       "/year"},
      [](const SceneSetup&) { return Extent{.reach = kLawnSown / 2, .sown = kLawnSown}; },
      [](const SceneSetup& setup, const Film&) {
        Errors errors = check_grass(setup.block<Meadow>().lawn);
        check_path(errors, setup.block<Garden>().path, "/garden/path/points", kLand);
        if (errors.empty()) check_stones(errors, setup.block<Garden>());
        return errors;
      },
      [](const SceneSetup& setup, const Film& film) {
        GroundSizeEstimate ground{.triangles = 89'700 + 66'400};
        estimate_grass(setup.block<Meadow>().lawn, film, ground);
        ground.grass *= 1.3;
        ground.placed = 1000 + 1.6 * ground.placed;
        return ground;
      },
      [](const SceneSetup& setup, const Film& film, double reach, Seed seed) -> std::unique_ptr<Grounds> {
        return std::make_unique<Lawn>(setup.floor, setup.block<Meadow>().lawn, film.quality, reach, seed,
                                      &setup.block<Garden>());
      },
      [](const SceneSetup& setup) {
        const auto& meadow = setup.block<Meadow>();
        return daylight(garden_sky(setup), meadow.grass, linear(meadow.grass), meadow.haze);
      },
      [](SceneSetup& setup) { return &setup.block<Garden>().hour; });
}

Sky garden_sky(const SceneSetup& setup) {
  const auto& garden = setup.block<Garden>();
  Moment when = garden.when;
  when.hour = garden.hour.at(0);
  return sky_over(setup, sun_at(when), setup.camera.stops());
}

}  // namespace frond
