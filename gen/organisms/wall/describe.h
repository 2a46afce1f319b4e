#pragma once

#include "organisms/wall/wall.h"
#include "preset/reader.h"

// The properties of walls, as presets spell them; see preset/describe.h.

namespace frond {

inline constexpr Choice<WallHole> kWallHoles[] = {{"window", WallHole::window, "with frame and panes"},
                                                  {"door", WallHole::door, "down to the ground, of planks"},
                                                  {"gap", WallHole::gap, "nothing stands in it"}};

template <class Visitor>
void describe(Visitor& v, WallOpening& o) {
  v.choice("kind", o.kind, kWallHoles, "What stands in it");
  v.number("at", o.at, {.min = -50, .max = 50, .unit = "m"}, "Its middle, from the middle of the wall");
  v.number("sill", o.sill, {.min = 0, .max = 50, .unit = "m"}, "Height of its lower edge; not of a door");
  v.number("width", o.width, {.min = 0.2, .max = 20, .unit = "m"}, "Of the hole");
  v.number("height", o.height, {.min = 0.2, .max = 20, .unit = "m"}, "Of the hole");
}

template <class Visitor>
void describe(Visitor& v, WallParams& w) {
  WallShape& s = w.shape;
  v.number("width", s.width, {.min = 0.1, .max = 30, .unit = "m"}, "Length of the wall");
  v.number("height", s.height, {.min = 0.1, .max = 15, .unit = "m"}, "Without the coping; whole courses");
  v.number("thickness", s.thickness, {.min = 0.05, .max = 2, .unit = "m"}, "From face to face");
  v.vector("brick", s.brick, {.min = 0.03, .max = 1, .unit = "m"}, "Length, height and depth of a brick");
  v.number("joint", s.joint, {.min = 0.002, .max = 0.03, .unit = "m"}, "Mortar between bricks");
  v.number("recess", s.recess, {.min = 0, .max = 0.02, .unit = "m"},
           "How far the mortar lies behind the bricks' faces");
  v.number("wear", s.wear, {.min = 0, .max = 1}, "0 as new, 1: bricks chipped and askew");
  v.number("ruin", s.ruin, {.min = 0, .max = 0.95}, "Share of its height that has fallen down at most");
  v.boolean("coping", s.coping, "A top course of bricks on edge, where nothing has fallen down");
  v.list("openings", s.openings, "Windows, doors, gaps");
  v.list("bricks", w.bricks, Count{1, 64}, "Colours of the bricks");
  v.color("mortar", w.mortar, "Of the joints");
  v.color("stone", w.stone, "Of sills and lintels");
  v.color("paint", w.paint, "Of windows and doors");
  v.number("weathering", w.weathering, {.min = 0, .max = 1}, "Soot, damp and moss");
}

}  // namespace frond
