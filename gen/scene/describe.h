#pragma once

#include "organisms/describe.h"
#include "organisms/describe_events.h"
#include "organisms/kinds.h"
#include "scene/describe_plan.h"
#include "scene/describe_stand.h"
#include "scene/preset.h"
#include "settings/settings.h"

// The outline of presets; see preset/describe.h.

namespace frond {

inline constexpr Choice<Quality> kQualities[] = {{"draft", Quality::draft, "a few seconds a frame"},
                                                 {"good", Quality::good, "smooth edges, soft shadows"},
                                                 {"best", Quality::best, "everything, slow"}};

/// The sides of a picture.
inline constexpr Range kSides{.min = 16, .max = 16384, .unit = "pixels"};

template <class Visitor>
void describe(Visitor& v, Film& f) {
  v.integer("frames", f.frames, {.min = 1, .max = 100000}, "Number of frames; 1 makes a still");
  v.number("fps", f.fps, {.min = 0.1, .max = 1000}, "Frames a second");
  v.size("size", f.size, kSides, "Width and height of the pictures");
  v.choice("quality", f.quality, kQualities, "How carefully the pictures are rendered");
}

inline constexpr std::string_view kFocusSchema = R"({"anyOf": [
  {"type": "array", "items": {"type": "number", "minimum": -1000, "maximum": 1000}, "minItems": 3, "maxItems": 3},
  {"type": "array", "minItems": 1, "items": {"type": "array", "minItems": 2, "maxItems": 2, "items": [
    {"type": "number"},
    {"type": "array", "items": {"type": "number", "minimum": -1000, "maximum": 1000}, "minItems": 3, "maxItems": 3}]}},
  {"type": "string"}]})";

inline bool read_focus(Reader& reader, const Value& value, Focus& focus) {
  if (value.is(Value::Type::text)) {
    focus.organism = value.text;
    if (value.text.empty()) reader.fault(value, "a point, keyframes of one, or the name of an organism");
    return !value.text.empty();
  }
  auto point = reader.animated_at(value, {.min = -1000, .max = 1000, .unit = "m"}, Animated<Vec3>{});
  if (point) focus.point = *point;
  return point.has_value();
}

inline void describe_rest(KeyWriter& v, Focus& focus) {
  v.add("organism", focus.organism);
  v.add("point", focus.point);
}

template <class Visitor>
void describe(Visitor& v, Camera& c) {
  v.animated("location", c.location, {.min = -1000, .max = 1000, .unit = "m"}, "Where the camera stands");
  v.animated("look_at", c.look_at, {.min = -1000, .max = 1000, .unit = "m"},
             "The point that the camera looks at");
  v.animated("angle", c.angle, {.min = 1, .max = 160, .unit = "degrees"},
             "Angle of the view, from its left edge to its right");
  v.boolean("follow", c.follow,
            "Whether heights of the camera count from the ground below it instead of from y = 0");
  v.list(
      "fit", c.fit,
      "Names of organisms, or \"all\": the camera goes on looking the same way and moves to where these fill "
      "the picture, grown, whatever its shape");
  v.number("margin", c.margin, {.min = 0, .max = 0.45},
           "Share of the picture's width and height that `fit` leaves free at each edge");
  v.number("exposure", c.exposure, {.min = -8, .max = 8, .sense = "1 is twice as bright, -1 half"},
           "Stops by which a picture outdoors is brighter than a light meter has it");
  v.number("highlights", c.highlights, {.min = 0, .max = 6, .sense = "2 as on film"},
           "Stops above white that keep their shape instead of burning out, outdoors");
  v.number("contrast", c.contrast, {.min = 0.5, .max = 2, .sense = "1.2 a crisp picture"},
           "How steep the picture's curve is about middle grey");
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

template <class Visitor>
void describe(Visitor& v, Wind& w) {
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

template <class Visitor>
void describe(Visitor& v, Floor& f) {
  v.number("relief", f.relief, {.min = 0, .max = 5, .unit = "m"},
           "Height of the dunes, or of the lawn's swells");
  v.number("scale", f.scale, {.min = 0.1, .max = 100, .unit = "m"},
           "Distance from one dune or swell to the next");
  v.integer("stones", f.stones, {.min = 0, .max = 5000}, "Number of loose stones, under water only");
  v.number("stone_size", f.stone_size, {.min = 0.001, .max = 10, .unit = "m"},
           "Size of the largest loose stone");
  v.number("extent", f.extent, {.min = 0.1, .max = 30, .unit = "m"},
           "Distance from the middle within which loose stones lie");
}

template <class Visitor>
void describe(Visitor& v, Snow& s) {
  v.animated("depth", s.depth, {.min = 0, .max = 2, .unit = "m"},
             "Depth of the snow on open level ground; with keyframes it falls and melts");
  v.animated("frost", s.frost, {.min = 0, .max = 1},
             "How white hoarfrost makes leaves, twigs and blades of grass");
  v.angle("wind", s.wind, {.min = -360, .max = 360},
          "Direction that the wind comes from which brought the snow: 0 from +z, 90 from +x");
  v.number("drift", s.drift, {.min = 0, .max = 1},
           "How much of the snow the wind has carried into the lee of what stands there: 0 calm, 1 a storm");
}

template <class Visitor>
void describe(Visitor& v, Rain& r) {
  v.animated("rate", r.rate,
             {.min = 0, .max = 100, .unit = "mm/h", .sense = "1 a drizzle, 5 steady rain, 20 a shower"},
             "How hard it rains, from an overcast sky; with keyframes rain comes and goes");
  v.animated(
      "fallen", r.fallen, {.min = 0, .max = 100, .unit = "mm"},
      "How much rain has fallen, which makes things wet and fills puddles; with keyframes they fill and dry");
  v.animated("mist", r.mist, {.min = 0, .max = 50, .unit = "m"},
             "Height of the mist that rain leaves over the ground; 0 is none");
}

template <class Visitor>
void describe(Visitor& v, Stage& s) {
  std::vector<Choice<std::size_t>> names;
  for (const SettingRow& row : settings()) names.push_back({row.name, names.size(), row.doc});
  v.choice("setting", s.setting, names, "The surroundings, which bring their own light and ground");
  v.object("camera", s.camera, "The camera");
  v.object(
      "wind", s.wind,
      "The wind over the land, in which trees without a wave of their own sway by their wood and leaves");
  for (std::size_t i = 0; i < names.size(); ++i) {
    const SettingRow& row = settings()[i];
    // Only who writes the schema asks for it: it takes longer than reading.
    std::string schema = std::is_same_v<Visitor, SchemaWriter> ? row.schema() : std::string();
    v.custom(row.block, s.blocks[i], row.read, schema, row.block_doc);
  }
  v.object("floor", s.floor, "The ground of the sea and the lawn, for underwater, meadow and garden");
  v.animated(
      "year", s.year, {.min = -1000, .max = 1000, .unit = "years", .sense = "winter is 0, summer 0.5"},
      "Time of the year of lawns and forest floors, and of every `season` that has none of its own: 0 new "
      "year, 0.5 midsummer; not given: always summer");
  v.object("rain", s.rain,
           "Rain with wet things and puddles, for meadow, garden and forest; without it all is dry");
  v.object("snow", s.snow, "Snow and hoarfrost on everything, for meadow, garden and forest");
}

template <class Visitor>
void describe(Visitor& v, Preset& p) {
  v.text("title", p.title, "A name for the preset, shown in lists but not in the picture");
  v.text(
      "base", p.base,
      "Another preset, named as seen from this one's folder, whose values stand wherever this one has none");
  v.integer("seed", p.seed, {.min = 0, .max = 9e15},
            "Seed of everything random: another number gives another reef, tree or wood by the same rules");
  v.object("film", p.film, "Length, size and quality of the film");
  v.object("scene", p.stage, "Everything but the organisms: surroundings, light and camera");
  v.list("events", p.events, Count{0, 1000},
         "What happens once in the lives of the trees of the kind tree: storms, fellings, prunings");
  v.object("plan", p.plan,
           "A plan of rooms and ways that a grammar lays out by the preset's seed; the ground of a garden "
           "follows it");
  v.object(
      "stand", p.stand,
      "The trees of a piece of land over centuries, simulated year by year; `frond stand` draws its figures");
  v.inheriting_list({}, p.organisms, organism_kinds(),
                    "What grows and stands in the scene, one entry for each kind of thing");
}

}  // namespace frond
