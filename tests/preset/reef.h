#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "preset/reader.h"

// A small preset with a property of every kind.
namespace frond::reef {

enum class Quality { draft, good, best };
inline constexpr Choice<Quality> kQualities[] = {{"draft", Quality::draft, "quick"},
                                                 {"good", Quality::good, "as it should be"},
                                                 {"best", Quality::best, ""}};

struct Film {
  int frames = 1;
  std::array<int, 2> size = {640, 360};
  Quality quality = Quality::good;
};

inline void describe(Properties& v, Film& f) {
  v.integer("frames", f.frames, {.min = 1, .max = 100000}, "How many pictures");
  v.size("size", f.size, {.min = 16, .max = 16384, .unit = "pixels"}, "Width and height");
  v.choice("quality", f.quality, kQualities, "How long to calculate");
}

struct Wave {
  double speed = 1;
  float amplitude = 0.39269908f;
  bool loop = true;
};

inline void describe(Properties& v, Wave& w) {
  v.number("speed", w.speed, {.min = 0, .max = 10}, "Swings a second");
  v.angle("amplitude", w.amplitude, {.min = 0, .max = 90}, "How far a tip leans");
  v.boolean("loop", w.loop, "");
}

struct Rule {
  std::string rule;
  std::optional<int> limit;
};

inline void describe(Properties& v, Rule& r) {
  v.shorthand("rule");
  v.text("rule", r.rule, "A production");
  v.required("rule");
  v.integer("limit", r.limit, {.min = 0}, "How often it may be used");
}

struct Coral {
  std::vector<Rule> rules;
  std::vector<std::pair<std::string, std::string>> constants;
  Curve thickness{{{0, 1}, {1, 0.25f}}};
  Color base{1, 0.5f, 0};
  double size = 1;
};

inline void describe(Properties& v, Coral& c) {
  v.list("rules", c.rules, "What grows");
  v.required("rules");
  v.pairs("constants", c.constants, "Names in the rules");
  v.curve("thickness", c.thickness, "Radius along a branch");
  v.color("base", c.base, "Color at the root");
  v.number("size", c.size, {.min = 0, .max = 10, .above_min = true, .unit = "metres"}, "Height");
}

struct Rock {
  Vec3 size{1, 1, 1};
  std::vector<DVec3> blobs;
  std::vector<double> weights;
};

inline void describe(Properties& v, Rock& r) {
  v.vector("size", r.size, {.min = 0.5, .max = 2}, "Radii");
  v.list("blobs", r.blobs, "Centers");
  v.list("weights", r.weights, {.min = 1, .max = 3}, "Of the blobs");
}

struct Organism {
  std::string name;
  int count = 1;
  Wave wave;
  std::variant<std::monostate, Coral, Rock> params;
};

inline void describe(Properties& v, Organism& o) {
  v.text("name", o.name, "How messages call it");
  v.integer("count", o.count, {.min = 0}, "How many");
  v.object("wave", o.wave, "How it sways");
}

template <class Params>
constexpr Kind<Organism> make_kind(std::string_view name, std::string_view doc) {
  return {name, doc,
          [](Properties& v, Organism& organism) { describe(v, organism.params.emplace<Params>()); }};
}

inline constexpr Kind<Organism> kKinds[] = {make_kind<Coral>("coral", "Branches by rules"),
                                            make_kind<Rock>("rock", "Blobs")};

/// A custom property: "left" or a number of turns.
inline bool read_turn(Reader& reader, const Value& value, double& turn) {
  if (value.is(Value::Type::number)) return turn = value.number, true;
  if (value.is(Value::Type::text) && value.text == "left") return turn = 0.25, true;
  return reader.fault(value, "\"left\" or a number"), false;
}

struct Preset {
  std::string title;
  std::uint64_t seed = 0;
  Film film;
  Animated<double> zoom{1.0};
  Animated<double> turn{0.0};
  Animated<Vec3> location{Vec3(0, 1, -5)};
  std::optional<Vec2> focus;
  std::optional<Color> fog;
  double custom = 0;
  std::vector<std::string> tags;
  std::optional<Wave> swell;
  Organism ground;
  std::vector<Organism> stones;
  std::vector<Organism> organisms;
};

inline void describe(Properties& v, Preset& p) {
  v.text("title", p.title, "What it shows");
  v.required("title");
  v.integer("seed", p.seed, {}, "Another number, another picture");
  v.object("film", p.film, "The film");
  v.animated("zoom", p.zoom, {.min = 0.1, .max = 10}, "Of the camera");
  v.animated("turn", p.turn, {.min = -180, .max = 180, .unit = "degrees"}, "Of the camera");
  v.animated("location", p.location, "Of the camera");
  v.vector("focus", p.focus, "In the picture");
  v.color("fog", p.fog, "");
  v.custom("custom", p.custom, &read_turn, R"({"anyOf": [{"type": "number"}, {"const": "left"}]})",
           "Or left");
  v.list("tags", p.tags, "");
  v.object("swell", p.swell, "Of the sea");
  v.tagged("ground", p.ground, kKinds, "What all stand on");
  v.tagged_list("stones", p.stones, kKinds, "Others");
  v.inheriting_list({}, p.organisms, kKinds, "What grows");
}

/// A text that uses everything and has no fault.
inline constexpr std::string_view kGood = R"({
  "$schema": "x.json",
  "title": "Reef", // a comment
  "seed": 7,
  "film": {"frames": 24, "size": [320, 200], "quality": "best"},
  "zoom": [[0, 1], [2.5, 3]], "turn": -90, "location": [[0, [1, 2, 3]], [1, [4, 5, 6]]],
  "focus": [0.5, 0.25], "fog": "#ff8000", "custom": "left", "tags": ["a", "\u00e9\ud83d\ude00"],
  "swell": {"speed": 2},
  "ground": {"kind": "rock", "size": [1, 1.5, 2], "blobs": [[0, 0, 0]]},
  "stones": [{"kind": "rock", "weights": [1, 2]}],
  /* all corals
     alike */
  "defaults": {"wave": {"speed": 0.5, "amplitude": 45}, "count": 3, "rules": ["A -> B"], "weights": [3]},
  "force": ["wave/amplitude", "base"],
  "organisms": [
    {"kind": "coral", "name": "one", "wave": {"speed": 4, "amplitude": 10}, "base": [1, 0, 0]},
    {"kind": "coral", "rules": ["A -> C", {"rule": "C -> A", "limit": 2}], "constants": {"r": 0.9, "q": "1-r"}},
    {"kind": "rock", "count": 1, "size": [0.5, 0.5, 0.5]}
  ]
}
)";

}  // namespace frond::reef
