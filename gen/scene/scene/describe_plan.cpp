#include "scene/describe.h"

#include "organisms/describe_grammar.h"

namespace frond {

namespace {

constexpr Choice<RoomGround> kRoomGrounds[] = {{"lawn", RoomGround::lawn, "grass as everywhere"},
                                               {"gravel", RoomGround::gravel, "as on the ways"},
                                               {"earth", RoomGround::earth, "a bed"}};

/// The cells of a plan or of a room along a side.
constexpr Range kPlanCells{.min = 1, .max = 64, .unit = "cells"};

}  // namespace

void describe(Properties& v, RoomKind& r) {
  v.text("symbol", r.symbol, "Symbol of the grammar that opens such a room");
  v.required("symbol");
  v.text("name", r.name, "Name by which `place.in` and `place.along` call such rooms; kinds may share one");
  v.required("name");
  v.size(
      "size", r.size, kPlanCells,
      "How many cells such a room has across and deep, as one comes in, where its symbol has no parameters");
  v.number("inset", r.inset, metres(0.05, 10),
           "Distance from the edge of a room's cells to that of the room");
  v.choice("ground", r.ground, kRoomGrounds, "What covers the ground of such a room, in a garden");
}

void describe(Properties& v, PlanText& p) {
  v.object("grammar", p.grammar,
           "The grammar whose word is walked over the cells: F a way, + - | turns, [ ] branches, and rooms");
  v.size("size", p.size, kPlanCells, "How many cells the plan has along x and along z");
  v.number("cell", p.cell, metres(0.5, 20), "Side of a cell");
  v.number("way", p.way, metres(0.1, 20), "Width of the ways");
  v.number("opening", p.opening, metres(0.1, 20),
           "Width of the gate and of the openings by which ways come into rooms");
  v.list("rooms", p.rooms, "The kinds of rooms");
}

}  // namespace frond
