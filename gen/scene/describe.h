#pragma once

#include "organisms/describe.h"
#include "organisms/kinds.h"
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
void describe(Visitor& v, Floor& f) {
  v.number("relief", f.relief, {.min = 0, .max = 5, .unit = "m"}, "Height of the dunes");
  v.number("scale", f.scale, {.min = 0.1, .max = 100, .unit = "m"}, "From dune to dune");
  v.integer("stones", f.stones, {.min = 0, .max = 5000}, "Loose stones");
  v.number("stone_size", f.stone_size, {.min = 0.001, .max = 10, .unit = "m"}, "Of the largest of them");
  v.number("extent", f.extent, {.min = 0.1, .max = 30, .unit = "m"}, "How far from the middle they lie");
}

template <class Visitor>
void describe(Visitor& v, Stage& s) {
  std::vector<Choice<std::size_t>> names;
  for (const SettingRow& row : settings()) names.push_back({row.name, names.size(), row.doc});
  v.choice("setting", s.setting, names, "The surroundings");
  v.object("camera", s.camera, "The camera");
  for (std::size_t i = 0; i < names.size(); ++i) {
    const SettingRow& row = settings()[i];
    // Only who writes the schema asks for it: it takes longer than reading.
    std::string schema = std::is_same_v<Visitor, SchemaWriter> ? row.schema() : std::string();
    v.custom(row.block, s.blocks[i], row.read, schema, row.block_doc);
  }
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
  v.inheriting_list({}, p.organisms, organism_kinds(), "What grows");
}

}  // namespace frond
