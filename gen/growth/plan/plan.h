#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/result.h"
#include "core/vec.h"
#include "grammar/grammar.h"

// Plans by grammars
// =================
// A grammar's word is walked by a turtle on a grid of square cells, and what it leaves is a plan: ways,
// rooms, and the steps by which one gets from one to another. Every cell is a way, of one room, or free.
//
//     F, F(n)    a way of one cell, or of n cells, straight on
//     + - |      a quarter turn left, right; a half turn. A parameter is an angle, rounded to quarters
//     [ ]        a branch: the turtle comes back to where it began
//     B, B(w,d)  a room whose symbol is B, straight ahead: w cells across and d deep, or as its kind says.
//                The turtle steps into its middle, and leaves it by its next F
//
// A step onto a cell beyond the grid or of a room, and a room that is not wholly on free cells, are not made;
// the rest of that branch is then passed over. A step onto a way joins it. So every way and every room can be
// reached from the gate, whatever the grammar. Other symbols do nothing.
//
// The turtle starts in the middle of the front, heading for the back; its first cell is a way. Grammars that
// make levels of games: Dormans 2010 (Adventures in level design), who rewrites graphs and shapes; turtles
// that lay streets: Parish and Müller 2001 (Procedural modeling of cities).

namespace frond {

/// What covers the ground of a room.
enum class RoomGround { lawn, gravel, earth };

/// A kind of room.
struct RoomKind {
  std::string symbol;             ///< of the grammar, that opens one
  std::string name;               ///< by which presets place things in it
  std::array<int, 2> size{2, 2};  ///< cells across and deep, 1..64
  double inset = 0.3;             ///< metres between its cells' edge and its own, > 0
  RoomGround ground = RoomGround::lawn;
};

/// A plan as its author writes it.
struct PlanText {
  GrammarText grammar;
  std::array<int, 2> size{9, 9};  ///< cells along x and along z, 1..64
  double cell = 2;                ///< metres, the side of a cell
  double way = 1.1;               ///< metres, the width of ways
  double opening = 1.3;           ///< metres, the width of the gate and of the openings of rooms
  std::vector<RoomKind> rooms;
};

/// A cell: column from -x to +x, row from the front (+z) to the back.
using PlanCell = glm::ivec2;

/// A rectangle of cells.
struct PlanRoom {
  std::size_t kind = 0;      ///< index in PlanText::rooms
  PlanCell low{0}, high{0};  ///< its first and last cells
  int facing = 0;            ///< quarter turns to the left from the heading to the back, as one came in

  bool holds(PlanCell c) const { return c.x >= low.x && c.x <= high.x && c.y >= low.y && c.y <= high.y; }
  PlanCell middle() const { return (low + high) / 2; }
};

/// A step between neighbouring cells, which ways and openings follow from.
struct PlanStep {
  PlanCell from{0}, to{0};
};

/// What a word has laid out.
struct GroundPlan {
  static constexpr int kFree = -2, kWay = -1;

  std::array<int, 2> size{0, 0};
  std::vector<int> cells;  ///< kFree, kWay or the number of a room; row by row
  std::vector<PlanRoom> rooms;
  std::vector<PlanStep> steps;  ///< the first comes in through the gate, from row -1

  bool inside(PlanCell c) const { return c.x >= 0 && c.y >= 0 && c.x < size[0] && c.y < size[1]; }
  int at(PlanCell c) const { return inside(c) ? cells[c.y * size[0] + c.x] : kFree; }
};

/// Compiles the grammar of a plan, which knows the symbols of its rooms; words have 100,000 modules at most.
Result<Grammar> compile_plan(const PlanText& text);

/// Derives the word and walks it. `grammar` is that of compile_plan().
Result<GroundPlan> derive_plan(const PlanText& text, const Grammar& grammar, Seed seed);

/// Faults of a plan's measures, each at a pointer below the plan: symbols of rooms that mean something else,
/// ways wider than openings, and those than what an inset leaves, and plans that reach farther than `reach`
/// metres from the middle.
Errors plan_faults(const PlanText& text, double reach);

}  // namespace frond
