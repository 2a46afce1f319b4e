#include "settings/meadow.h"

#include "settings/settings.h"

namespace frond {

template <class Visitor>
void describe(Visitor& v, Meadow& m) {
  v.color("zenith", m.zenith, "Colour of the sky above");
  v.color("horizon", m.horizon, "Colour of the sky far off, and of the haze");
  v.color("grass", m.grass, "Colour of the grass");
  v.direction("sun", m.sun, "Direction toward the sun");
  v.number("haze", m.haze, {.min = 1, .max = 100000, .unit = "m"},
           "Distance at which two thirds of a colour are lost in the haze");
  v.number("clouds", m.clouds, {.min = 0, .max = 1}, "Share of the sky that clouds cover");
  v.number("blade", m.lawn.blade, {.min = 0, .max = 5, .unit = "m"},
           "Length of the blades of grass; 0 leaves a bare lawn");
  v.number("blades", m.lawn.blades, {.min = 0, .max = 20000, .unit = "1/m2"},
           "Number of blades on a square metre");
  v.number("extent", m.lawn.extent, {.min = 0.1, .max = 200, .unit = "m"},
           "Distance from the middle within which single blades stand");
  v.number("flowers", m.lawn.flowers, {.min = 0, .max = 0.2}, "Share of the blades that bear a flower");
}

SettingRow meadow_setting() {
  return setting_row<Meadow>(
      "meadow", "grass under a summer sky", "meadow", "Sky and grass, for meadow",
      {"/meadow", "/floor/relief", "/floor/scale"}, [](const Stage&) { return Extent{.sown = kLawnSown}; },
      [](const Stage& stage, const Film&) { return check_grass(stage.block<Meadow>().lawn); },
      [](const Stage& stage, const Film& film) {
        GroundForesight ground{.triangles = 48'180};
        foresee_grass(stage.block<Meadow>().lawn, film, ground);
        return ground;
      },
      [](const Stage& stage, const Film& film, double reach, Seed seed) -> std::unique_ptr<Grounds> {
        return std::make_unique<Lawn>(stage.floor, stage.block<Meadow>().lawn, film.quality, reach, seed);
      },
      [](const Stage& stage) {
        const auto& meadow = stage.block<Meadow>();
        return Daylight{glm::normalize(meadow.sun),
                        {1, 0.96f, 0.88f},
                        meadow.zenith,
                        meadow.horizon,
                        meadow.grass,
                        meadow.haze};
      });
}

}  // namespace frond
