#pragma once

#include "organisms/bridge/bridge.h"
#include "preset/reader.h"

// The properties of bridges, as presets spell them; see preset/describe.h.

namespace frond {

inline constexpr Choice<BridgeStyle> kBridgeStyles[] = {
    {"wood", BridgeStyle::wood, "planks on stringers, a railing of posts and rails"},
    {"stone", BridgeStyle::stone, "a vault of voussoirs, walls, paving and a parapet with piers"}};

template <class Visitor>
void describe(Visitor& v, BridgeParams& b) {
  BridgeShape& s = b.shape;
  v.choice("style", s.style, kBridgeStyles, "What it is built of");
  v.number("length", s.length, {.min = 1, .max = 60, .unit = "m"}, "From foot to foot");
  v.number("width", s.width, {.min = 0.6, .max = 12, .unit = "m"}, "Of the deck, over all");
  v.number("height", s.height, {.min = 0.05, .max = 20, .unit = "m"},
           "Of the deck at mid-span above its feet");
  v.number(
      "crown", s.crown, {.min = 0, .max = 0.5},
      "Where the middle control point of each half lies, as a share of the length: 0.1 nearly pointed to 0.5 "
      "upright at its feet; 0: at random between the two");
  v.number("thickness", s.thickness, {.min = 0.05, .max = 5, .unit = "m"},
           "Of the deck at mid-span; held to what the bend of the arch allows");
  v.integer("posts", s.posts, {.min = 1, .max = 60}, "Of each railing on each half");
  v.number("post", s.post, {.min = 0.02, .max = 1.5, .unit = "m"}, "Width of a post");
  v.number("rail_height", s.rail_height, {.min = 0.15, .max = 3, .unit = "m"},
           "Of the hand rail above the deck");
  v.number("rail", s.rail, {.min = 0.02, .max = 0.6, .unit = "m"}, "Width of the hand rail");
  v.number("lower_rail", s.lower_rail, {.min = 0, .max = 2, .unit = "m"},
           "Height of the lower rail above the deck; 0: none (wood)");
  v.integer("balusters", s.balusters, {.min = 0, .max = 30}, "Thin bars between each two posts (wood)");
  v.number("plank", s.plank, {.min = 0.04, .max = 1, .unit = "m"},
           "Width of a plank, length of a paving stone");
  v.number("gap", s.gap, {.min = 0.001, .max = 0.1, .unit = "m"}, "Between planks, between stones");
  v.number("foundation", s.foundation, {.min = 0, .max = 10, .unit = "m"},
           "How deep it reaches below its feet");
  v.color("color", b.color, "Of the wood or the stone; by itself as the style has it");
  v.color("second", b.second, "Of weathered wood, of the mortar");
  v.number("variation", b.variation, {.min = 0, .max = 0.9},
           "How much planks or stones differ in brightness");
  v.number("weathering", b.weathering, {.min = 0, .max = 1}, "0 new to 1 old");
  v.number("moss", b.moss, {.min = 0, .max = 1}, "How much grows on it");
  v.number("gloss", b.gloss, {.min = 0, .max = 1}, "0 raw to 1 oiled");
}

}  // namespace frond
