#pragma once

#include <map>
#include <optional>
#include <span>
#include <vector>

#include "cpfg/cpfg.h"
#include "cpfg/cylinders.h"

// The turtle of cpfg: all that its symbols do to it. What asks for its way (frame.cpp) and what draws
// (figure.cpp) walk with it.

namespace frond::cpfg {

/// A `tropism:` or `torque:` line of a view: what the turtle turns toward, and how strongly.
struct CpfgTropism {
  DVec3 direction{0, 0, 0};  ///< of the length of its intensity
  double angle = 0, elasticity = 0, step = 0;
  bool is_torque = false;
};

/// What a view says of the turtle.
struct TurtleSettings {
  double angle = 45;  ///< of bare turns, degrees
  double scale = 1, scale_multiplier = 1;
  double width = 1, width_step = 0;  ///< a diameter
  int color = 128, color_step = 1;
  int colors = 256;              ///< how many there are; numbers beyond go round
  DVec3 old_direction{0, 1, 0};  ///< `tropism direction`, of length 1 or 0
  double old_elasticity = 0, elasticity_increment = 0;
  std::vector<CpfgTropism> tropisms;
  bool answers_after = false;      ///< `environment display: before`: queries are answered after a step
  bool draws_past_cut = true;      ///< `interpretation past %`
  std::map<char, DVec3> surfaces;  ///< where each surface `~x` ends, along left, heading and up
};

TurtleSettings turtle_settings(const CpfgModel& model);

/// Numbers that stand in a text, whatever is between them.
std::vector<double> numbers_in(std::string_view text);

/// All that brackets keep.
struct CpfgTurtleState : CylinderState {
  DVec3 last_heading{0, 1, 0}, last_up{0, 0, -1};  ///< of the last segment, which twist is reckoned from
  double scale = 1;                                ///< of lengths, and of widths that are set
  double width = 1, elasticity = 0;
  std::vector<double> elasticities;
  int back = 128;            ///< colour of the back side
  std::optional<int> sides;  ///< of cylinders, `@!`
  std::int32_t place = -1;   ///< the control place that a cylinder comes from, see figure.cpp
  int depth = 0;             ///< of brackets
};

class CpfgTurtle {
 public:
  CpfgTurtle(const TurtleSettings& settings, const CpfgDrawing& drawing);

  CpfgTurtleState state;

  /// Does what the module at a place says, with those that belong to it, and gives the next place.
  std::size_t step(std::size_t at);

  const std::vector<CpfgModule>& modules() const { return drawing_.word.modules; }
  std::span<const float> parameters(std::size_t at) const;
  /// The module at a place if it has no more places before it: `\0` beyond the end.
  char symbol(std::size_t at) const { return at < modules().size() ? modules()[at].symbol : '\0'; }

 private:
  void turn(char symbol, double angle);
  bool step_value(char symbol, std::span<const float> values);
  void step_special(std::size_t at);
  std::size_t step_pair(std::size_t at);
  int color_of(double number) const;
  void set_elasticity(char how, std::span<const float> values);
  void set_rises(std::span<const float> values);
  void set_tangents(std::span<const float> values);
  void set_part_scale(double scale);
  void aim(std::span<const float> values);
  void carry_frame();
  void keep_frame();
  void level();
  void place_surface(std::size_t at);
  void move(double length);
  void pull_heading();
  void roll_up();

  const TurtleSettings& settings_;
  const CpfgDrawing& drawing_;
  std::vector<CpfgTurtleState> stack_;
  double part_scale_ = 1;      ///< of the L-system that the turtle is within
  std::vector<double> parts_;  ///< of those around it
};

/// Where a cut that begins behind a `%` ends: at the branch's `]`, the `$` of the part that it lies in, a
/// `%(…)` or the end.
std::size_t cut_end(const CpfgWord& word, std::size_t at);

/// How many modules behind one, before `end`, the turtle reads with it: the surface of a `~`, what a `?`
/// asks, the letters of an `@`. 0 where they mean nothing there and are read for themselves.
std::size_t read_with(const CpfgWord& word, std::size_t at, std::size_t end);

/// Whether a word asks for the turtle: `?P`, `?H`, `?L`, `?U`, `?Q`.
bool has_queries(const CpfgWord& word);

/// Walks along the drawing of a word and writes position, heading, left or up into its queries' parameters.
void answer_queries(const TurtleSettings& settings, const CpfgDrawing& drawing, CpfgWord& word);

}  // namespace frond::cpfg
