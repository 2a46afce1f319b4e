#include "grammar/symbols.h"

#include <array>

namespace frond {

namespace {

constexpr std::array kSymbols{
    TurtleSymbol{"F", Act::draw, Act::draw,
                 "forward, drawing: F(length), F(length, width at the end); a vertex inside { }"},
    TurtleSymbol{"f", Act::move, Act::move, "forward without drawing: f(length); a vertex inside { }"},
    TurtleSymbol{"G", Act::draw_free, Act::draw_free, "as F, but never a vertex"},
    TurtleSymbol{"g", Act::move_free, Act::move_free, "as f, but never a vertex"},
    TurtleSymbol{"+", Act::yaw_left, Act::yaw_right, "turn left about the up vector: +(degrees)"},
    TurtleSymbol{"-", Act::yaw_right, Act::yaw_left, "turn right about the up vector: -(degrees)"},
    TurtleSymbol{"&", Act::pitch_down, Act::pitch_up, "pitch down about the left vector: &(degrees)"},
    TurtleSymbol{"^", Act::pitch_up, Act::pitch_down, "pitch up about the left vector: ^(degrees)"},
    TurtleSymbol{"\\", Act::roll_left, Act::roll_right, "roll left about the heading: \\(degrees)"},
    TurtleSymbol{"/", Act::roll_right, Act::roll_left, "roll right about the heading: /(degrees)"},
    TurtleSymbol{"|", Act::turn_back, Act::turn_back, "half turn about the up vector"},
    TurtleSymbol{"*", Act::none, Act::roll_back, "Houdini: half roll about the heading"},
    TurtleSymbol{"$", Act::level, Act::level,
                 "roll until the left vector is horizontal; $(x,y,z) aims at a point first"},
    TurtleSymbol{"@v", Act::level, Act::none, "as $"},
    TurtleSymbol{"@R", Act::set_heading, Act::none, "set the heading: @R(x,y,z)"},
    TurtleSymbol{"@M", Act::set_position, Act::none, "set the position: @M(x,y,z)"},
    TurtleSymbol{"[", Act::push, Act::push, "a branch starts: keep the state"},
    TurtleSymbol{"]", Act::pop, Act::pop, "the branch ends: back to the state kept"},
    TurtleSymbol{"{", Act::open_polygon, Act::open_polygon, "a polygon starts"},
    TurtleSymbol{"}", Act::close_polygon, Act::close_polygon, "the polygon ends and is filled"},
    TurtleSymbol{".", Act::vertex, Act::vertex, "a vertex of the polygon here"},
    TurtleSymbol{"!", Act::narrow, Act::scale_width,
                 "width times width_scale; !(w) sets it (Houdini: multiplies)"},
    TurtleSymbol{"#", Act::widen, Act::next_color,
                 "width divided by width_scale; #(w) sets it (Houdini: colour)"},
    TurtleSymbol{"_", Act::widen, Act::divide_length, "as # (Houdini: divides the step)"},
    TurtleSymbol{"\"", Act::scale_length, Act::scale_length, "step times length_scale; \"(s) times s"},
    TurtleSymbol{"'", Act::next_color, Act::next_color, "next colour; '(n) sets it"},
    TurtleSymbol{";", Act::next_color, Act::scale_angle,
                 "next colour; ;(n) sets it (Houdini: scales the angle)"},
    TurtleSymbol{",", Act::previous_color, Act::previous_color, "colour before; ,(n) sets it"},
    TurtleSymbol{"~", Act::organ, Act::random_turn,
                 "an organ: the shape named by the module that follows (Houdini: random turn)"},
    TurtleSymbol{"@", Act::none, Act::divide_angle, "Houdini: divides the angle"},
    TurtleSymbol{"@~", Act::random_turn, Act::none,
                 "turn, pitch and roll at random: @~(most degrees), 180 without"},
    TurtleSymbol{"@w", Act::scale_width, Act::none, "width times the parameter: @w(s)"},
    TurtleSymbol{"@a", Act::scale_angle, Act::none, "the angle of bare turns times the parameter: @a(s)"},
    TurtleSymbol{"@O", Act::sphere, Act::none, "a sphere: @O(diameter), the width without"},
    TurtleSymbol{"@o", Act::disc, Act::none, "a disc across the heading: @o(diameter)"},
    TurtleSymbol{"@Gs", Act::tube_start, Act::none, "a generalized cylinder starts here"},
    TurtleSymbol{"@Gc", Act::tube_point, Act::none,
                 "a point on the generalized cylinder; starts one where there is none"},
    TurtleSymbol{"@Ge", Act::tube_end, Act::none, "the generalized cylinder ends here"},
    TurtleSymbol{"@Ts", Act::set_elasticity, Act::none, "set how strongly branches bend: @Ts(elasticity)"},
    TurtleSymbol{"%", Act::cut, Act::cut, "drop the rest of the branch at the start of the next step"},
    TurtleSymbol{"?P", Act::query_position, Act::none,
                 "?P(x,y,z): filled with the turtle's position after each step"},
    TurtleSymbol{"?H", Act::query_heading, Act::none, "?H(x,y,z): filled with the heading after each step"},
    TurtleSymbol{"?U", Act::query_up, Act::none, "?U(x,y,z): filled with the up vector after each step"},
    TurtleSymbol{"?L", Act::query_left, Act::none, "?L(x,y,z): filled with the left vector after each step"},
    TurtleSymbol{"?E", Act::environment, Act::none,
                 "?E(what, answer…): filled by the environment after each step"},
    TurtleSymbol{"?", Act::guide, Act::divide_width, "follow the guide points (Houdini: divides the width)"},
};

}  // namespace

std::span<const TurtleSymbol> turtle_symbols() { return kSymbols; }

Act act_of(std::string_view name, Dialect dialect) {
  for (const TurtleSymbol& symbol : kSymbols)
    if (symbol.name == name) return dialect == Dialect::abop ? symbol.abop : symbol.houdini;
  return Act::none;
}

std::string_view long_symbol_at(std::string_view text, Dialect dialect) {
  std::string_view longest;
  for (const TurtleSymbol& symbol : kSymbols) {
    if (symbol.name.size() < 2 || symbol.name.size() <= longest.size() || !text.starts_with(symbol.name))
      continue;
    if (dialect == Dialect::houdini) continue;
    if (symbol.name[0] == '?' && !text.substr(symbol.name.size()).starts_with('(')) continue;
    longest = symbol.name;
  }
  return longest;
}

}  // namespace frond
