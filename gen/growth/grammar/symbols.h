#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace frond {

/// Where tools disagree on a symbol: as in *The Algorithmic Beauty of Plants* and cpfg, as in Houdini (`+`
/// and
/// `-` mirrored; `!` `"` `;` scale width, length and angle), or as in LParser (rolls are `<` and `>`; widths
/// are shares of lengths).
enum class Dialect { abop, houdini, lparser };

/// The turtle's action for a symbol.
// clang-format off
enum class Act : std::uint8_t {
  none, draw, move, draw_free, move_free, draw_half, move_half, yaw_left, yaw_right, pitch_down, pitch_up, roll_left,
  roll_right, push, pop, turn_back, roll_back, open_polygon, close_polygon, vertex, organ, cut, level, random_turn,
  pitch_by_gravity, bend_by_gravity, set_heading, set_position,
  // how it draws from here on: pairs that scale and divide, then the rest
  narrow, widen, scale_width, divide_width, scale_length, divide_length, scale_angle, divide_angle, next_color,
  previous_color, set_elasticity,
  // what is left to the sink
  sphere, disc, tube_start, tube_point, tube_end, query_position, query_heading, query_up, query_left, environment,
  guide,
};
// clang-format on

constexpr bool draws_line(Act act) {
  return act == Act::draw || act == Act::draw_free || act == Act::draw_half;
}
constexpr bool goes_half(Act act) { return act == Act::draw_half || act == Act::move_half; }
constexpr bool goes_forward(Act act) { return act >= Act::draw && act <= Act::move_half; }
constexpr bool changes_width(Act act) { return act >= Act::narrow && act <= Act::divide_width; }
constexpr bool changes_style(Act act) { return act >= Act::narrow && act <= Act::set_elasticity; }

/// A symbol with a meaning for the turtle; every other symbol does nothing.
struct TurtleSymbol {
  std::string_view name;
  Act abop, houdini, lparser;
  std::string_view doc;
};

/// The alphabet of the turtle: to add a symbol, add a row.
std::span<const TurtleSymbol> turtle_symbols();

/// The turtle's action for the symbol of that name.
Act act_of(std::string_view name, Dialect dialect);

/// Whether the name is a symbol of several letters from the alphabet, such as `@Gc`. Those that start with
/// `?` count only before a `(`.
std::string_view long_symbol_at(std::string_view text, Dialect dialect);

}  // namespace frond
