#pragma once

#include "organisms/describe.h"
#include "scene/preset.h"

// The outline of presets; see preset/describe.h.

namespace frond {

inline constexpr Choice<Quality> kQualities[] = {{"draft", Quality::draft, "a few seconds a frame"},
                                                 {"good", Quality::good, "smooth edges, soft shadows"},
                                                 {"best", Quality::best, "everything, slow"}};

inline constexpr Choice<Setting> kSettings[] = {
    {"underwater", Setting::underwater, "a sea floor in blue water"},
    {"studio", Setting::studio, "soft light before a plain wall"},
    {"meadow", Setting::meadow, "grass under a summer sky"},
    {"garden", Setting::garden, "a lawn with pond and path at any hour of the day"},
    {"forest", Setting::forest, "wooded hills at any hour of the day"}};

/// The sides of a picture, and the hours of a day.
inline constexpr Range kSides{.min = 16, .max = 16384, .unit = "pixels"};
inline constexpr Range kHours{.min = 0, .max = 24, .unit = "h", .sense = "dawn is 6, noon 12, dusk 19"};

template <class Visitor>
void describe(Visitor& v, Film& f) {
  v.integer("frames", f.frames, {.min = 1, .max = 100000}, "1: a still");
  v.number("fps", f.fps, {.min = 0.1, .max = 1000}, "Frames a second");
  v.size("size", f.size, kSides, "Width and height");
  v.choice("quality", f.quality, kQualities, "How carefully the pictures are rendered");
}

template <class Visitor>
void describe(Visitor& v, Camera& c) {
  v.animated("location", c.location, {.min = -1000, .max = 1000, .unit = "m"}, "Where it stands");
  v.animated("look_at", c.look_at, {.min = -1000, .max = 1000, .unit = "m"}, "What it looks at");
  v.animated("angle", c.angle, {.min = 1, .max = 160, .unit = "degrees"}, "Width of the view");
  v.boolean("follow", c.follow, "Heights count from the ground below, not from y = 0");
}

template <class Visitor>
void describe(Visitor& v, Water& w) {
  v.color("near", w.near, "What distance fades to");
  v.color("deep", w.deep, "Of the depth below the horizon");
  v.number("visibility", w.visibility, {.min = 0.5, .max = 1000, .unit = "m"},
           "Until two thirds of a colour are lost");
  v.direction("sun", w.sun, "Toward the sun");
  v.number("caustics", w.caustics, {.min = 0, .max = 1.5}, "How strongly waves focus the light");
  v.number("shafts", w.shafts, {.min = 0, .max = 1}, "Beams of light");
  v.integer("particles", w.particles, {.min = 0, .max = 1000}, "Specks that drift before the camera");
}

template <class Visitor>
void describe(Visitor& v, Studio& s) {
  v.color("wall", s.wall, "Of wall and floor");
  v.number("distance", s.distance, {.min = 0.01, .max = 1000, .unit = "m"},
           "From the middle to the wall behind it");
  v.direction("key", s.key, "Toward the main light");
  v.number("softness", s.softness, {.min = 0, .max = 3}, "Of shadows");
}

template <class Visitor>
void describe(Visitor& v, Meadow& m) {
  v.color("zenith", m.zenith, "Of the sky above");
  v.color("horizon", m.horizon, "Of the sky far off, and of the haze");
  v.color("grass", m.grass, "Of the grass");
  v.direction("sun", m.sun, "Toward the sun");
  v.number("haze", m.haze, {.min = 1, .max = 100000, .unit = "m"}, "Until two thirds of a colour are lost");
  v.number("clouds", m.clouds, {.min = 0, .max = 1}, "How much of the sky they cover");
  v.number("blade", m.blade, {.min = 0, .max = 5, .unit = "m"}, "Length of the grass; 0: none stands");
  v.number("blades", m.blades, {.min = 0, .max = 20000, .unit = "1/m2"}, "How dense the grass is");
  v.number("extent", m.extent, {.min = 0.1, .max = 200, .unit = "m"},
           "How far from the middle single blades stand");
  v.number("flowers", m.flowers, {.min = 0, .max = 0.2}, "Share of the blades that bear a flower");
}

template <class Visitor>
void describe(Visitor& v, PondShape& p) {
  v.vector("center", p.center, {.min = -28, .max = 28, .unit = "m"}, "x, z of its middle");
  v.vector("size", p.size, {.min = 0, .max = 20, .unit = "m"},
           "From the middle to the shore along x and z; 0: none");
  v.number("depth", p.depth, {.min = 0.1, .max = 5, .unit = "m"}, "Of the bed below the lawn");
  v.number("level", p.level, {.min = -2, .max = 0, .unit = "m"}, "Of the water, above the lawn");
}

template <class Visitor>
void describe(Visitor& v, PathShape& p) {
  v.list("points", p.points, "x, z in metres of a smooth curve; fewer than two: no path");
  v.number("width", p.width, {.min = 0.1, .max = 20, .unit = "m"}, "From edge to edge");
}

template <class Visitor>
void describe(Visitor& v, Garden& g) {
  v.number("hour", g.hour, kHours, "Of the day: 6 dawn, 12 noon, 19 dusk");
  v.angle("south", g.south, {.min = -360, .max = 360},
          "Where the sun stands at noon: 0 toward +z, 90 toward +x");
  v.object("pond", g.pond, "The pond");
  v.object("path", g.path, "The gravel path");
  v.integer("lilies", g.lilies, {.min = 0, .max = 2000}, "Leaves of water lilies on the pond");
  v.number("gravel", g.gravel, {.min = 0.02, .max = 1, .unit = "m"}, "Size of the stones on the path");
  v.color("gravel_color", g.gravel_color, "Of the stones on the path");
}

template <class Visitor>
void describe(Visitor& v, TerrainShape& t) {
  v.number("size", t.size, {.min = 2, .max = 4000, .unit = "m"}, "Of the square of land that is sown");
  v.number("hills", t.hills, {.min = 0, .max = 500, .unit = "m"}, "From valley to top");
  v.number("hill_size", t.hill_size, {.min = 1, .max = 5000, .unit = "m"}, "From hill to hill");
  v.number("rough", t.rough, {.min = 0, .max = 1}, "0 rolling, 1 broken");
  v.object("path", t.path, "A path, kept clear");
}

template <class Visitor>
void describe(Visitor& v, Forest& f) {
  v.number("hour", f.hour, kHours, "Of the day: 6 dawn, 12 noon, 19 dusk");
  v.angle("south", f.south, {.min = -360, .max = 360},
          "Where the sun stands at noon: 0 toward +z, 90 toward +x");
  v.number("mist", f.mist, {.min = 0, .max = 200, .unit = "m"}, "How high it fills the valleys; 0: none");
  v.object("terrain", f.terrain, "The land");
  v.color("litter", f.litter, "Of fallen leaves and earth");
  v.number("moss", f.moss, {.min = 0, .max = 1}, "Share of the ground that is green");
}

template <class Visitor>
void describe(Visitor& v, Floor& f) {
  v.number("relief", f.relief, {.min = 0, .max = 5, .unit = "m"}, "Height of the dunes");
  v.number("scale", f.scale, {.min = 0.1, .max = 100, .unit = "m"}, "From dune to dune");
  v.integer("stones", f.stones, {.min = 0, .max = 5000}, "Loose stones");
  v.number("stone_size", f.stone_size, {.min = 0.001, .max = 10, .unit = "m"}, "Of the largest of them");
  v.number("extent", f.extent, {.min = 0.1, .max = 30, .unit = "m"}, "How far from the middle they lie");
}

template <class Visitor>
void describe(Visitor& v, Stage& s) {
  v.choice("setting", s.setting, kSettings, "The surroundings");
  v.object("camera", s.camera, "The camera");
  v.object("water", s.water, "The water, for underwater");
  v.object("studio", s.studio, "Wall and light, for studio");
  v.object("meadow", s.meadow, "Sky and grass, for meadow");
  v.object("garden", s.garden, "Hour, pond and path, for garden; lawn and sky are the meadow's");
  v.object("forest", s.forest, "Hour and land, for forest; clouds and haze are the meadow's");
  v.object("floor", s.floor, "The ground");
}

template <class Visitor>
void describe(Visitor& v, Preset& p) {
  v.text("title", p.title, "Shown nowhere in the picture");
  v.text("base", p.base,
         "Another preset, as seen from this one's folder, whose values stand where this one has none");
  v.integer("seed", p.seed, {.min = 0, .max = 9e15}, "Another number, another reef");
  v.object("film", p.film, "Length, size and quality");
  v.object("scene", p.stage, "Everything but the organisms");
  v.inheriting_list({}, p.organisms, kOrganismKinds, "What grows");
}

}  // namespace frond
