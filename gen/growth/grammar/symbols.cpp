#include "grammar/symbols.h"

namespace frond {

namespace {

constexpr TurtleSymbol kSymbols[] = {
    {"F", Act::draw, Act::draw, Act::draw,
     "forward, drawing: F(length), F(length, width at the end); a vertex inside { }"},
    {"f", Act::move, Act::move, Act::move, "forward without drawing: f(length); a vertex inside { }"},
    {"G", Act::draw_free, Act::draw_free, Act::none, "as F, but never a vertex"},
    {"g", Act::move_free, Act::none, Act::move_free,
     "as f, but never a vertex (Houdini: starts a group, which does nothing)"},
    {"H", Act::none, Act::draw_half, Act::none, "Houdini: as F, half as far"},
    {"h", Act::none, Act::move_half, Act::none, "Houdini: as f, half as far"},
    {"Z", Act::none, Act::none, Act::draw_half, "LParser: as F, half a step; Z(length)"},
    {"z", Act::none, Act::none, Act::move_half, "LParser: as f, half a step; z(length)"},
    {"+", Act::yaw_left, Act::yaw_right, Act::yaw_left, "turn left about the up vector: +(degrees)"},
    {"-", Act::yaw_right, Act::yaw_left, Act::yaw_right, "turn right about the up vector: -(degrees)"},
    {"&", Act::pitch_down, Act::pitch_down, Act::pitch_down, "pitch down about the left vector: &(degrees)"},
    {"^", Act::pitch_up, Act::pitch_up, Act::pitch_up, "pitch up about the left vector: ^(degrees)"},
    {"\\", Act::roll_left, Act::roll_right, Act::none, "roll left about the heading: \\(degrees)"},
    {"/", Act::roll_right, Act::roll_left, Act::none, "roll right about the heading: /(degrees)"},
    {"<", Act::none, Act::none, Act::roll_left, "LParser: roll left: <(degrees)"},
    {">", Act::none, Act::none, Act::roll_right, "LParser: roll right: >(degrees)"},
    {"|", Act::turn_back, Act::turn_back, Act::turn_back, "half turn about the up vector"},
    {"*", Act::none, Act::roll_back, Act::none, "Houdini: half roll about the heading"},
    {"$", Act::level, Act::level, Act::level,
     "roll until the left vector is horizontal; $(x,y,z) aims at a point first"},
    {"t", Act::none, Act::none, Act::pitch_by_gravity,
     "LParser: pitch down by gravity: t(radians that a level heading turns), 0.2 without"},
    {"T", Act::none, Act::bend_by_gravity, Act::none,
     "Houdini: bend toward the ground: T(radians that a level heading turns), 0.2 without"},
    {"@v", Act::level, Act::none, Act::none, "as $"},
    {"@R", Act::set_heading, Act::none, Act::none, "set the heading: @R(x,y,z)"},
    {"@M", Act::set_position, Act::none, Act::none, "set the position: @M(x,y,z)"},
    {"[", Act::push, Act::push, Act::push, "a branch starts: keep the state"},
    {"]", Act::pop, Act::pop, Act::pop, "the branch ends: back to the state kept"},
    {"{", Act::open_polygon, Act::open_polygon, Act::open_polygon, "a polygon starts"},
    {"}", Act::close_polygon, Act::close_polygon, Act::close_polygon, "the polygon ends and is filled"},
    {".", Act::vertex, Act::vertex, Act::vertex, "a vertex of the polygon here"},
    {"!", Act::narrow, Act::scale_width, Act::scale_width,
     "width times width_scale; !(w) sets it (Houdini, LParser: multiplies)"},
    {"#", Act::widen, Act::next_color, Act::none,
     "width divided by width_scale; #(w) sets it (Houdini: colour)"},
    {"_", Act::widen, Act::divide_length, Act::none, "as # (Houdini: divides the step)"},
    {"\"", Act::scale_length, Act::scale_length, Act::divide_length,
     "step times length_scale; \"(s) times s (LParser: bare, divided by length_scale)"},
    {"'", Act::next_color, Act::next_color, Act::scale_length,
     "next colour; '(n) sets it (LParser: step times length_scale)"},
    {";", Act::next_color, Act::scale_angle, Act::divide_angle,
     "next colour; ;(n) sets it (Houdini: scales the angle; LParser: bare, divides it)"},
    {":", Act::none, Act::none, Act::scale_angle,
     "LParser: angle of bare turns times angle_scale; :(s) times s"},
    {"c", Act::none, Act::none, Act::next_color, "LParser: next colour; c(n) sets it"},
    {",", Act::previous_color, Act::previous_color, Act::none, "colour before; ,(n) sets it"},
    {"~", Act::organ, Act::random_turn, Act::random_turn,
     "an organ: the shape named by the module that follows (Houdini, LParser: random turn)"},
    {"@", Act::none, Act::divide_angle, Act::none, "Houdini: divides the angle"},
    {"@~", Act::random_turn, Act::none, Act::none,
     "turn, pitch and roll at random: @~(most degrees), 180 without"},
    {"@w", Act::scale_width, Act::none, Act::none, "width times the parameter: @w(s)"},
    {"@a", Act::scale_angle, Act::none, Act::none, "the angle of bare turns times the parameter: @a(s)"},
    {"@O", Act::sphere, Act::none, Act::none, "a sphere: @O(diameter), the width without"},
    {"@o", Act::disc, Act::none, Act::none, "a disc across the heading: @o(diameter)"},
    {"@Gs", Act::tube_start, Act::none, Act::none, "a generalized cylinder starts here"},
    {"@Gc", Act::tube_point, Act::none, Act::none,
     "a point on the generalized cylinder; starts one where there is none"},
    {"@Ge", Act::tube_end, Act::none, Act::none, "the generalized cylinder ends here"},
    {"@Ts", Act::set_elasticity, Act::none, Act::none, "set how strongly branches bend: @Ts(elasticity)"},
    {"%", Act::cut, Act::cut, Act::roll_back,
     "drop the rest of the branch at the start of the next step (LParser: half roll)"},
    {"?P", Act::query_position, Act::query_position, Act::none,
     "?P(x,y,z): filled with the turtle's position after each step"},
    {"?H", Act::query_heading, Act::none, Act::none, "?H(x,y,z): filled with the heading after each step"},
    {"?U", Act::query_up, Act::none, Act::none, "?U(x,y,z): filled with the up vector after each step"},
    {"?L", Act::query_left, Act::none, Act::none, "?L(x,y,z): filled with the left vector after each step"},
    {"?E", Act::environment, Act::none, Act::none,
     "?E(what, answer…): filled by the environment after each step"},
    {"?", Act::guide, Act::divide_width, Act::divide_width,
     "follow the guide points (Houdini: divides the width; LParser: bare, too)"},
};

}  // namespace

std::span<const TurtleSymbol> turtle_symbols() { return kSymbols; }

Act act_of(std::string_view name, Dialect dialect) {
  for (const TurtleSymbol& symbol : kSymbols)
    if (symbol.name == name)
      return dialect == Dialect::abop      ? symbol.abop
             : dialect == Dialect::houdini ? symbol.houdini
                                           : symbol.lparser;
  return Act::none;
}

std::string_view long_symbol_at(std::string_view text, Dialect dialect) {
  std::string_view longest;
  for (const TurtleSymbol& symbol : kSymbols) {
    if (symbol.name.size() < 2 || symbol.name.size() <= longest.size() || !text.starts_with(symbol.name))
      continue;
    if (dialect != Dialect::abop) continue;
    if (symbol.name[0] == '?' && !text.substr(symbol.name.size()).starts_with('(')) continue;
    longest = symbol.name;
  }
  return longest;
}

}  // namespace frond
