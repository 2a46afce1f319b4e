#include "scene/describe.h"

#include "images/describe_mask.h"
#include "organisms/describe.h"
#include "organisms/kinds.h"
#include "preset/eases.h"
#include "preset/keys.h"
#include "preset/palettes.h"
#include "preset/reader.h"
#include "settings/settings.h"

namespace frond {

inline constexpr Choice<Background> kBackgrounds[] = {
    {"scene", Background::scene, "the whole scene"},
    {"ground", Background::ground, "the ground, but neither sky, backdrop, haze nor far land"},
    {"transparent", Background::transparent, "nothing: what grows and stands there is alone"}};

void describe(Properties& v, Film& f) {
  v.integer("frames", f.frames, {.min = 1, .max = 100000}, "Number of frames; 1 makes a still");
  v.number("fps", f.fps, {.min = 0.1, .max = 1000}, "Frames a second");
  v.size("size", f.size, kSides, "Width and height of the pictures");
  v.choice("quality", f.quality, kQualities, "How carefully the pictures are rendered");
  v.choice("background", f.background, kBackgrounds,
           "What is seen round that which grows; what is left out is transparent in the PNG pictures");
  v.number(
      "twigs", f.twigs, {.min = 0, .max = 200},
      "Pixels: twigs of a large plant that nowhere in the film are longer than that are drawn as copies of "
      "some hundred of them, which takes a third of the file and less time; 0: each is drawn by itself");
}

namespace {

constexpr std::string_view kFocusSchema = R"({"anyOf": [
  {"type": "array", "items": {"type": "number", "minimum": -1000, "maximum": 1000}, "minItems": 3, "maxItems": 3},
  {"type": "array", "minItems": 1, "items": {"type": "array", "minItems": 2, "maxItems": 3, "items": [
    {"type": "number"},
    {"type": "array", "items": {"type": "number", "minimum": -1000, "maximum": 1000}, "minItems": 3, "maxItems": 3},
    {}]}},
  {"type": "string"}]})";

bool read_focus(Reader& reader, const Value& value, Focus& focus) {
  if (value.is(Value::Type::text)) {
    focus.organism = value.text;
    if (value.text.empty()) reader.fault(value, "a point, keyframes of one, or the name of an organism");
    return !value.text.empty();
  }
  auto point = reader.animated_at(value, metres(-1000, 1000), Animated<Vec3>{});
  if (point) focus.point = *point;
  return point.has_value();
}

}  // namespace

void describe_rest(KeyWriter& v, Focus& focus) {
  v.add("organism", focus.organism);
  v.add("point", focus.point);
}

void describe(Properties& v, Orbit& o) {
  v.angle("turn", o.turn, {.min = -36000, .max = 36000, .sense = "360 once round, -90 a quarter to the left"},
          "How far the camera goes round while the film lasts, to the right of where it looks");
  v.number("rise", o.rise, metres(-1000, 1000), "By how much the camera ends higher than it begins");
  v.vector("center", o.center, metres(-1000, 1000),
           "The point that the camera goes round; not given: what it looks at");
}

void describe(Properties& v, Rail& r) {
  v.vector("to", r.to, metres(-1000, 1000),
           "Where the camera ends that goes in a straight line from `location`");
  v.required("to");
}

void describe(Properties& v, Shake& s) {
  v.angle("amplitude", s.amplitude, {.min = 0, .max = 20, .sense = "0.4 a calm hand, 2 a run"},
          "How far the camera turns aside at most, and as far up and down");
  v.number("frequency", s.frequency, {.min = 0.01, .max = 20, .unit = "1/s"},
           "Swings a second of the slowest and widest of its swings");
  v.boolean("loop", s.loop, "Whether the film can be repeated without a jump of the camera");
}

void describe(Properties& v, CameraMove& m) {
  v.object("orbit", m.orbit, "A way round a point");
  v.object("rail", m.rail, "A way in a straight line");
  v.object("shake", m.shake, "The unrest of a camera that is held by hand");
  v.choice("ease", m.ease, kEases, "How `orbit` and `rail` begin and end");
}

inline constexpr Choice<LightSide> kLightSides[] = {
    {"as_it_is", LightSide::as_it_is, "the camera looks the way that it does"},
    {"back", LightSide::back,
     "from behind, 40 degrees beside what the camera looks at: leaves glow, edges shine"},
    {"side", LightSide::side, "80 degrees aside: forms are round"},
    {"front", LightSide::front, "over the camera's shoulder: colours are full"}};
inline constexpr Choice<Third> kThirds[] = {
    {"left", Third::left, "on the left third, with light from the right"},
    {"middle", Third::middle, "in the middle"},
    {"right", Third::right, "on the right third, with light from the left"}};

void describe(Properties& v, Composition& c) {
  v.choice("light", c.light, kLightSides, "Where the sun or the main lamp comes from, as the camera sees it");
  v.choice("third", c.third, kThirds, "Where in the picture the subject stands");
  v.number("height", c.height, {.min = 0.02, .max = 500, .unit = "m", .sense = "0.5 kneeling, 1.6 standing"},
           "How high above the ground the lens is");
  v.number("headroom", c.headroom, {.min = 0, .max = 0.6}, "Share of the picture's height above the subject");
  v.number("foreground", c.foreground, {.min = 0, .max = 0.6},
           "Share of the picture's height below the subject");
}

void describe(Properties& v, NamedView& w) {
  v.text("name", w.name, "What the view is called");
  v.required("name");
  v.vector("at", w.at, metres(-1e6, 1e6), "Where one stands");
  v.vector("to", w.to, metres(-1e6, 1e6), "The point that one looks at");
  v.number("angle", w.angle, {.min = 1, .max = 160, .unit = "degrees"},
           "Angle of the view, from its left edge to its right");
}

void describe(Properties& v, Camera& c) {
  v.animated("location", c.location, metres(-1000, 1000), "Where the camera stands");
  v.animated("look_at", c.look_at, metres(-1000, 1000), "The point that the camera looks at");
  v.animated("angle", c.angle, {.min = 1, .max = 160, .unit = "degrees"},
             "Angle of the view, from its left edge to its right");
  v.object("move", c.move,
           "A move of the camera over the whole film, on top of its `location` and `look_at`");
  v.boolean("follow", c.follow,
            "Whether heights of the camera count from the ground below it instead of from y = 0");
  v.list("fit", c.fit,
         "Names of organisms, or \"all\": the camera goes on looking the same way and moves to where these "
         "fill the picture, grown, whatever its shape");
  v.text("part", c.part,
         "What of those, or of the first organism, it comes close to: the name of an organ, one of which it "
         "shows, or the `leaf`, the "
         "`flower` or the `fruit` of a species; in focus, at f/11 or less light");
  v.number("margin", c.margin, {.min = 0, .max = 0.45},
           "Share of the picture's width and height that `fit` leaves free at each edge");
  v.object(
      "compose", c.compose,
      "The camera goes to where what `fit` names, or all, is composed: light, thirds, height of the eye");
  v.number("exposure", c.exposure, {.min = -8, .max = 8, .sense = "1 is twice as bright, -1 half"},
           "Stops by which a picture outdoors is brighter than a light meter has it");
  v.number("highlights", c.highlights, {.min = 0, .max = 6, .sense = "2 as on film"},
           "Stops above white that keep their shape instead of burning out, outdoors");
  v.number("contrast", c.contrast, {.min = 0.5, .max = 2, .sense = "1.2 a crisp picture"},
           "How steep the picture's curve is about middle grey");
  v.number("saturation", c.saturation, {.min = 0, .max = 2, .sense = "0 grey, 0.85 as on film"},
           "Factor of how colourful the picture is");
  v.number(
      "warmth", c.warmth, {.min = -0.5, .max = 0.5, .sense = "0.06 warm light in cool shade"},
      "Share of red that what is bright gains and of blue that it loses; what is dark the other way round");
  v.number("vignette", c.vignette, {.min = 0, .max = 1, .sense = "0.15 slight"},
           "Share of their light that the picture's corners lose");
  v.number(
      "aperture", c.aperture,
      {.min = 0.5, .max = 64, .sense = "1.4 a wide lens, 4 a portrait's, 16 nearly all sharp"},
      "f-number of the lens, on film 36 mm wide: what is not in focus is blurred; not given: all is sharp");
  v.custom(
      "focus", c.focus, read_focus, kFocusSchema,
      "The point that is sharp, or the name of an organism, which is sharp where the camera sees it; not "
      "given: the point that the camera looks at (m)");
  v.number(
      "shutter", c.shutter, {.min = 0, .max = 1, .sense = "0.5 as a film camera's, 1 open all the time"},
      "Share of a frame's time for which the shutter of a film is open: what moves meanwhile is blurred");
  v.integer("shutter_samples", c.shutter_samples, {.min = 1, .max = 64},
            "Exposures that make a frame where the shutter is open; not given: 1 in a draft (no blur), 4 in "
            "good, 8 in best quality");
}

void describe(Properties& v, Wind& w) {
  v.aspect(Aspect::motion);
  v.number("speed", w.speed,
           {.min = 0, .max = 60, .unit = "m/s", .sense = "3 a breeze, 8 a fresh wind, 20 a gale"},
           "Mean speed of the wind ten metres above the ground");
  v.number("gusts", w.gusts, {.min = 0, .max = 0.6, .sense = "0.15 over the sea, 0.3 over woods"},
           "How gusty it is: the standard deviation of its speed as a share of the mean");
  v.direction("direction", w.direction, Across::xz, "Direction in which it blows; only x and z count");
  v.boolean("loop", w.loop,
            "Whether the gusts repeat after the film, so that it can be repeated without a jump");
}

void describe(Properties& v, Floor& f) {
  v.number("relief", f.relief, metres(0, 5), "Height of the dunes, or of the lawn's swells");
  v.number("scale", f.scale, metres(0.1, 100), "Distance from one dune or swell to the next");
  v.integer("stones", f.stones, {.min = 0, .max = 5000}, "Number of loose stones, under water only");
  v.number("stone_size", f.stone_size, metres(0.001, 10), "Size of the largest loose stone");
  v.number("extent", f.extent, metres(0.1, 30), "Distance from the middle within which loose stones lie");
}

void describe(Properties& v, FarLandShape& f) {
  v.number("reach", f.reach, {.min = 0, .max = 40000, .unit = "m", .sense = "0 no far land"},
           "Distance from the middle to the horizon");
  v.number("relief", f.relief, metres(0, 500), "Height of far hills above their valleys");
  v.number("hill_size", f.hill_size, metres(200, 10000), "Distance from one far hill to the next");
  v.number("parcel", f.parcel, metres(20, 1000),
           "Mean width of the far fields and meadows, which are twice as long");
  v.number("fields", f.fields, kShare, "Share of the open far land that is ploughed; the rest is grass");
  v.number("woods", f.woods, kShare,
           "Share of the far land that is wooded; with neither woods nor hedges no tree stands alone there");
  v.number("hedges", f.hedges, kShare, "Share of the borders between far fields that have a hedge");
  v.number("villages", f.villages, metres(0, 10000),
           "Distance from one village to the next along a road; 0 leaves none");
  v.number("mountains", f.mountains, metres(0, 5000), "Height of mountains above the far hills; 0 is none");
  v.number("mountains_distance", f.mountains_distance, metres(1000, 40000),
           "Distance from the middle at which mountains have reached their height");
  v.number("tree_line", f.tree_line, metres(0, 100000),
           "Height above the middle up to which far woods climb");
  v.number("snow_line", f.snow_line, metres(0, 100000),
           "Height above the middle from which far mountains are white");
  v.list("trees", f.trees, Count{0, 16},
         "Names of organisms with `sown` that far trees are copies of: the first stands where conifers grow, "
         "the others elsewhere; none: trees of a plain shape");
}

void describe(Properties& v, Snow& s) {
  v.animated("depth", s.depth, metres(0, 2),
             "Depth of the snow on open level ground; with keyframes it falls and melts");
  v.object("depth_map", s.depth_map,
           "A picture that scales the depth over the land; a bare file name will do");
  v.animated("frost", s.frost, kShare, "How white hoarfrost makes leaves, twigs and blades of grass");
  v.angle("wind", s.wind, {.min = -360, .max = 360},
          "Direction that the wind comes from which brought the snow: 0 from +z, 90 from +x");
  v.number("drift", s.drift, kShare,
           "How much of the snow the wind has carried into the lee of what stands there: 0 calm, 1 a storm");
  v.animated(
      "falling", s.falling,
      {.min = 0, .max = 20, .unit = "mm/h", .sense = "0.3 light snow, 1 steady, 3 heavy"},
      "How hard it snows, as the water that the flakes are, from an overcast sky; with keyframes a snowfall "
      "comes and goes");
  v.number(
      "shed", s.shed, {.min = 0, .max = 1000, .unit = "1/min"},
      "How many of a hundred boughs drop their snow in a minute of calm air; wind and thaw bring down more");
}

void describe(Properties& v, Rain& r) {
  v.animated("rate", r.rate,
             {.min = 0, .max = 100, .unit = "mm/h", .sense = "1 a drizzle, 5 steady rain, 20 a shower"},
             "How hard it rains, from an overcast sky; with keyframes rain comes and goes");
  v.animated(
      "fallen", r.fallen, {.min = 0, .max = 100, .unit = "mm"},
      "How much rain has fallen, which makes things wet and fills puddles; with keyframes they fill and dry");
  v.animated("mist", r.mist, metres(0, 50), "Height of the mist that rain leaves over the ground; 0 is none");
}

void describe(Properties& v, Air& a) {
  v.animated("visibility", a.visibility,
             {.min = 1, .max = 50'000, .unit = "m", .sense = "100 fog, 400 mist, 2000 a hazy morning"},
             "How far one sees through it where it is densest; with keyframes it lifts");
  v.number("level", a.level, metres(-1000, 10'000), "Height (y) up to which it is as dense");
  v.number("height", a.height, metres(0.1, 10'000),
           "Rise above that in which it thins to a third: less is ground mist");
  v.number("forward", a.forward, {.min = 0, .max = 0.95, .sense = "0 all ways alike, 0.7 mist, 0.9 spray"},
           "How far light that it scatters goes on as it came: more is brighter toward the sun");
}

void describe(Properties& v, SceneSetup& s) {
  std::vector<Choice<std::size_t>> names;
  for (const SettingRow& row : settings()) names.push_back({row.name, names.size(), row.doc});
  v.choice("setting", s.setting, names, "The surroundings, which bring their own light and ground");
  v.object("camera", s.camera, "The camera");
  v.list("views", s.views, Count{0, 200},
         "Views of the scene with names, which the studio goes to; no film reads them");
  v.object("wind", s.wind,
           "The wind over the land, in which trees and sown herbs without a wave of their own sway");
  for (std::size_t i = 0; i < names.size(); ++i) {
    const SettingRow& row = settings()[i];
    // Only who writes the schema asks for it: it takes longer than reading.
    std::string schema = v.purpose() == Purpose::schema ? row.schema() : std::string();
    v.custom(row.block, s.blocks[i], row.read, schema, row.block_doc);
  }
  v.object("floor", s.floor, "The ground of the sea and the lawn, for underwater, meadow and garden");
  v.animated(
      "year", s.year, {.min = -1000, .max = 1000, .unit = "years", .sense = "winter is 0, summer 0.5"},
      "Time of the year of lawns and forest floors, and of every `season` that has none of its own: 0 new "
      "year, 0.5 midsummer; not given: always summer");
  v.object("far", s.far,
           "The land as far as the horizon, for meadow, garden and forest; not given: hills with fields and "
           "woods round meadow and garden, none round a forest");
  v.object("rain", s.rain,
           "Rain with wet things and puddles, for meadow, garden and forest; without it all is dry");
  v.object("air", s.air,
           "Mist or dust that glows in the sun and through which shadows fall in shafts, for meadow, garden "
           "and forest; its frames are resolved in every quality");
  v.object("snow", s.snow, "Snow and hoarfrost on everything, for meadow, garden and forest");
}

/// Their colours count where they stand.
void describe_rest(KeyWriter&, Palettes&) {}

void describe(Properties& v, Preset& p) {
  v.text("title", p.title, "A name for the preset, shown in lists but not in the picture");
  v.text(
      "base", p.base,
      "Another preset, named as seen from this one's folder, whose values stand wherever this one has none");
  v.integer("version", p.version, {.min = 1, .max = kPresetVersion, .sense = "2 in new presets"},
            "How organisms take their random numbers: in 1 by their place in the list, so that one more in "
            "front makes all others grow anew; in 2 by their names, or else by their place among those "
            "without a name of their kind");
  v.integer("seed", p.seed, {.min = 0, .max = 9e15},
            "Seed of everything random: another number gives another reef, tree or wood by the same rules");
  v.object("taxon", p.taxon,
           "What is known of the species that the first organism is; it is found by these names, and nothing "
           "grows otherwise by it");
  v.custom("palettes", p.palettes, read_palettes, kPalettesSchema,
           "Lists of colours by name: `palette:autumn/0` stands for the first one of autumn wherever a "
           "colour may, and `palette:autumn` for all of them in a list");
  v.object("film", p.film, "Length, size and quality of the film");
  v.object("scene", p.setup, "Everything but the organisms: surroundings, light and camera");
  v.list("events", p.events, Count{0, 1000},
         "What happens once in the lives of the trees of the kind tree, or to the reef: storms, heat waves, "
         "fellings, prunings");
  v.object("plan", p.plan,
           "A plan of rooms and ways that a grammar lays out by the preset's seed; the ground of a garden "
           "follows it");
  v.object(
      "stand", p.stand,
      "The trees of a piece of land over centuries, simulated year by year; `frond stand` draws its figures");
  v.object("reef", p.reef,
           "The colonies of a piece of sea floor over a century, simulated year by year; `frond stand` draws "
           "its figures");
  v.inheriting_list({}, p.organisms, organism_kinds(),
                    "What grows and stands in the scene, one entry for each kind of thing");
}

}  // namespace frond
