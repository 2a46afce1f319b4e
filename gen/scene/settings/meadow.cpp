#include "settings/meadow.h"

#include "core/linear.h"
#include "images/describe_mask.h"
#include "settings/describe_plot.h"
#include "settings/settings.h"

namespace frond {

void describe(Properties& v, MountainShape& m) {
  v.number("height", m.height, metres(50, 6000), "Height of its top above the plain");
  v.number("distance", m.distance, metres(1500, 40000), "Distance from the middle to its crest");
  v.number("width", m.width, metres(500, 60000), "Distance from one end to the other");
  v.number("toward", m.toward, {.min = -360, .max = 360, .unit = "degrees"},
           "Direction in which it stands: 0 toward +z, 90 toward +x, 180 toward -z");
  v.number("snow", m.snow, metres(0, 100000), "Height above the plain from which snow lies");
  v.number("woods", m.woods, kShare, "Share of its height that woods climb");
  v.color("rock", m.rock, "Colour of the bare rock");
  v.integer("seed", m.seed, {.min = 0, .max = 1000000}, "Which of many mountains it is");
}

inline constexpr Choice<MeadowPlant> kMeadowPlants[] = {
    {"grass", MeadowPlant::grass, "blades of middling width"},
    {"fescue", MeadowPlant::fescue, "tufts of blades as fine as threads"},
    {"cocksfoot", MeadowPlant::cocksfoot, "clumps of long broad blades"},
    {"panicle", MeadowPlant::panicle, "stalks above the rest that bear seed"},
    {"clover", MeadowPlant::clover,
     "three leaflets with a pale chevron, and white heads where flowers is above 0"},
    {"daisy", MeadowPlant::daisy, "a white head with a yellow heart above leaves that lie flat"},
    {"buttercup", MeadowPlant::buttercup, "a yellow cup above leaves of three lobes"},
    {"plantain", MeadowPlant::plantain, "ribbed lances about a brown spike"}};

void describe(Properties& v, Sward& s) {
  v.choice("kind", s.kind, kMeadowPlants, "What it is");
  v.number("share", s.share, {.min = 0, .max = 100}, "How much there is of it, against the other shares");
  v.number("height", s.height, {.min = 0.1, .max = 10},
           "Factor of its size; 1 goes with the length of the blades");
}

void describe(Properties& v, Meadow& m) {
  v.animated("hour", m.hour, kHours,
             "Hour of the day, which places the sun instead of `sun`, as that of garden does");
  describe_place(v, m.when);
  v.number("turbidity", m.turbidity, {.min = 1.7, .max = 10},
           "How dusty the air is: 2 clear as in mountains, 3 a summer's day, 6 white with haze");
  v.color("zenith", m.zenith, "Colour of the sky above; not given: as the sun makes it");
  v.color("horizon", m.horizon, "Colour of the sky far off, and of the haze; not given: as the sun makes it");
  v.color("grass", m.grass, "Colour of the grass");
  v.direction("sun", m.sun, "Direction toward the sun, where no hour is given");
  v.direction("moon", m.moon, "Direction toward the moon, which casts the shadows of nights");
  v.number("haze", m.haze, metres(1, 100000),
           "Distance at which two thirds of a colour are lost in the haze");
  v.number("clouds", m.clouds, kShare, "Share of the sky that clouds cover");
  v.object("mountain", m.mountain, "A mountain far off; without it there is none");
  v.number("blade", m.lawn.blade, metres(0, 5), "Length of the blades of grass; 0 leaves a bare lawn");
  v.number("blades", m.lawn.blades, {.min = 0, .max = 20000, .unit = "1/m2"},
           "Number of blades on a square metre");
  v.number("extent", m.lawn.extent, metres(0.1, 200),
           "Distance from the middle within which single blades stand");
  v.number("flowers", m.lawn.flowers, {.min = 0, .max = 0.2}, "Share of the blades that bear a flower");
  v.list("plants", m.lawn.plants, {.min = 1, .max = 16},
         "What grows there; the shares of the kinds make the mixture");
  v.number("bare", m.lawn.bare, kShare, "Share of the patches, five blades wide, with a spot of bare earth");
  v.object("grass_map", m.lawn.map,
           "A picture that scales the grass over the land, with bare earth where there is none; a bare file "
           "name will do");
}

SettingRow meadow_setting() {
  return setting_row<Meadow>(
      "meadow", "grass under a summer sky", "meadow", "Sky and grass, for meadow",
      {"/meadow", "/floor/relief", "/floor/scale", "/snow", "/rain", "/air", "/far", "/year"},
      [](const SceneSetup&) { return Extent{.reach = kLawnSown / 2, .sown = kLawnSown}; },
      [](const SceneSetup& setup, const Film&) { return check_grass(setup.block<Meadow>().lawn); },
      [](const SceneSetup& setup, const Film& film) {
        GroundSizeEstimate ground{.triangles = 48'180};
        estimate_grass(setup.block<Meadow>().lawn, film, ground);
        return ground;
      },
      [](const SceneSetup& setup, const Film& film, double reach, Seed seed) -> std::unique_ptr<Grounds> {
        return std::make_unique<Lawn>(setup.floor, setup.block<Meadow>().lawn, film.quality, reach, seed);
      },
      [](const SceneSetup& setup) {
        const auto& meadow = setup.block<Meadow>();
        return daylight(meadow_sky(setup), meadow.grass, linear(meadow.grass), meadow.haze);
      },
      [](SceneSetup& setup) {
        std::optional<Animated<double>>& hour = setup.block<Meadow>().hour;
        return hour ? &*hour : nullptr;
      });
}

Sky sky_over(const SceneSetup& setup, Vec3 sun, double exposure) {
  const auto& meadow = setup.block<Meadow>();
  auto light = [](const std::optional<Color>& c) { return c ? std::optional(linear(*c)) : std::nullopt; };
  return Sky({sun, meadow.turbidity, meadow.clouds, exposure, light(meadow.zenith), light(meadow.horizon),
              meadow.moon, overcast(setup)});
}

Sky meadow_sky(const SceneSetup& setup) {
  const auto& meadow = setup.block<Meadow>();
  Moment when = meadow.when;
  if (meadow.hour) when.hour = meadow.hour->at(0);
  return sky_over(setup, meadow.hour ? sun_at(when) : meadow.sun, setup.camera.stops());
}

}  // namespace frond
