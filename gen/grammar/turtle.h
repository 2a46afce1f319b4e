#pragma once

#include <span>

#include "grammar/derive.h"
#include "grammar/rewrite.h"
#include "model/skeleton.h"

namespace frond {

/// Where the turtle is and how it draws. Right-handed: heading x left = up.
struct TurtleState {
  DVec3 position{0, 0, 0};
  DVec3 heading{0, 1, 0}, left{-1, 0, 0}, up{0, 0, 1};
  double length = 1, width = 0.1, angle = 45, elasticity = 0;
  int color = 0;
  int depth = 0;           ///< brackets open
  double grown = 1;        ///< 0..1: how far the module at hand has grown, in between two steps
  std::int32_t mark = -1;  ///< the sink's own: a bracket keeps and restores it; -1 after a move
  std::int32_t tube = -1;  ///< the sink's own: the last point of a generalized cylinder, -1 outside of one
  std::int32_t base = -1;  ///< the sink's own: as mark, but a move leaves it alone
};

/// A line that the turtle drew, before it moves on; widths are diameters.
struct Segment {
  DVec3 from, to;
  double width_from, width_to;
};

/// A module in between two steps, on its way from what its parent was to what it will be.
struct Unfolding {
  double age = 1;      ///< 0..1: turns, widths and organs have grown so far
  double stretch = 1;  ///< what lengths are multiplied by
  double from = 0;     ///< where its first parameter comes from, if `has_from`
  bool has_from = false;
};

/// A turtle that is fed modules one by one and tells a sink what it does. Of these members of the sink those
/// are called that it has:
///
///     void segment(const Segment&, TurtleState&);       // the state is that at the start but for `mark`
///     void push(TurtleState&);  void pop(TurtleState&); // the state that is kept; the state it is back in
///     void polygon(std::span<const DVec3>, const TurtleState&);
///     void organ(SymbolId shape, const double* parameters, const TurtleState&);
///     void bare(SymbolId, const double* parameters, const TurtleState&);  // a symbol without meaning
///     void sign(Act, std::span<const double> parameters, const TurtleState&);   // spheres, tubes,
///     questions, guides
template <class Sink>
class Turtle {
 public:
  Turtle(const Grammar& grammar, Seed seed, Sink& sink, const TurtleState& start)
      : grammar_(grammar), text_(grammar.text), sink_(sink), seed_(seed), now_(start) {
    jitters_ = text_.angle_jitter != 0 || text_.length_jitter != 0;
    at_.tables = grammar.tables;
    set_turn(now_.angle);
  }

  /// The next module. Interpretation rules are applied first.
  void feed(SymbolId symbol, const double* parameters) {
    if (grammar_.interpretation.of[symbol].empty() || wants_organ_)
      return act(symbol, parameters), void(++fed_);
    at_.seed = seed_.child("interpret").child(fed_++);
    auto emit = [&](SymbolId s, const double* p) { return act(s, p), true; };
    expand(grammar_, grammar_.interpretation, symbol, parameters, text_.interpretation_depth, at_, emit);
  }

  /// How far the modules fed from now on have grown.
  void set_growth(const Unfolding& growth) { growth_ = growth, now_.grown = growth.age; }

  /// What the randomness of the module fed next goes by, instead of its place in the word.
  void set_name(std::uint64_t name) { fed_ = name, acted_ = Seed::mix(name); }

  const TurtleState& state() const { return now_; }

 private:
  void act(SymbolId symbol, const double* parameters) {
    const Symbol& info = grammar_.symbols[symbol];
    if (skipped_ >= 0 && !leave_cut(info.act)) return;
    if (wants_organ_) return place_organ(symbol, parameters);
    bool given = info.arity > 0;
    ++acted_;
    switch (info.act) {
      case Act::none:
        if constexpr (requires { sink_.bare(symbol, parameters, now_); })
          sink_.bare(symbol, parameters, now_);
        return;
      case Act::draw:
      case Act::draw_free:
        return forward(info.act == Act::draw, true, info.arity, parameters);
      case Act::move:
      case Act::move_free:
        return forward(info.act == Act::move, false, info.arity, parameters);
      case Act::yaw_left:
        return turn(now_.heading, now_.left, given, parameters, 1);
      case Act::yaw_right:
        return turn(now_.heading, now_.left, given, parameters, -1);
      case Act::pitch_down:
        return turn(now_.heading, now_.up, given, parameters, -1);
      case Act::pitch_up:
        return turn(now_.heading, now_.up, given, parameters, 1);
      case Act::roll_left:
        return turn(now_.left, now_.up, given, parameters, -1);
      case Act::roll_right:
        return turn(now_.left, now_.up, given, parameters, 1);
      case Act::push:
        return push();
      case Act::pop:
        return pop();
      default:
        return act_seldom(info, parameters);
    }
  }

  void act_seldom(const Symbol& info, const double* parameters) {
    bool given = info.arity > 0;
    switch (info.act) {
      case Act::turn_back:
        if (growth_.age < 1) return turn(now_.heading, now_.left, true, &kHalfTurn, 1);
        now_.heading = -now_.heading, now_.left = -now_.left;
        return;
      case Act::roll_back:
        now_.left = -now_.left, now_.up = -now_.up;
        return;
      case Act::open_polygon:
        polygons_.push_back(vertices_.size());
        return;
      case Act::close_polygon:
        return close_polygon();
      case Act::vertex:
        if (!polygons_.empty()) vertices_.push_back(now_.position);
        return;
      case Act::organ:
        wants_organ_ = true;
        return;
      case Act::cut:
        skipped_ = 0;
        return;
      case Act::level:
      case Act::random_turn:
      case Act::set_heading:
      case Act::set_position:
        return place(info.act, info.arity, parameters);
      default:
        if (changes_style(info.act)) return style(info.act, given, given ? parameters[0] : 0);
        if constexpr (requires { sink_.sign(info.act, std::span<const double>(), now_); })
          sink_.sign(info.act, std::span<const double>(parameters, static_cast<std::size_t>(info.arity)),
                     now_);
    }
  }

  /// Behind a `%` nothing is done until the branch ends.
  bool leave_cut(Act act) {
    if (act == Act::push) ++skipped_;
    if (act == Act::pop && skipped_-- == 0) return true;
    return false;
  }

  double chance() { return seed_.child("jitter").child(acted_).range(-1, 1); }

  /// Turns `a` towards `b` (and `b` away from `a`); the angle of the last turn is remembered with its sine.
  void turn(DVec3& a, DVec3& b, bool given, const double* parameters, double way) {
    double angle = given ? parameters[0] : now_.angle;
    if (jitters_ && text_.angle_jitter != 0) angle += text_.angle_jitter * chance();
    if (growth_.age < 1) angle = growth_.from + (angle - growth_.from) * growth_.age;
    if (angle != turn_angle_) set_turn(angle);
    double c = turn_cosine_, s = turn_sine_ * way;
    DVec3 turned = a * c + b * s;
    b = b * c - a * s;
    a = turned;
  }

  void set_turn(double angle) {
    turn_angle_ = angle;
    turn_sine_ = sine(angle);
    turn_cosine_ = sine(angle + 90.0);
  }

  void forward(bool vertex, bool draws, int arity, const double* parameters) {
    double length = arity > 0 ? parameters[0] : now_.length;
    if (jitters_ && text_.length_jitter != 0) length *= 1 + text_.length_jitter * chance();
    if (growth_.age < 1) length *= growth_.stretch;
    DVec3 to = now_.position + now_.heading * length;
    if (draws) {
      double width = arity > 1 ? parameters[1] : now_.width;
      if constexpr (requires { sink_.segment(Segment{}, now_); })
        sink_.segment(Segment{now_.position, to, now_.width, width}, now_);
      now_.width = width;
    } else {
      now_.mark = -1;
    }
    now_.position = to;
    if (vertex && !polygons_.empty()) vertices_.push_back(to);
    if (draws && now_.elasticity != 0) bend();
  }

  /// The pull on a drawn segment (ABOP 2.3.3): turned by e|H x T| about H x T.
  void bend() {
    DVec3 axis = glm::cross(now_.heading, DVec3(text_.tropism));
    double strength = glm::length(axis);
    if (!(strength > 0)) return;
    axis /= strength;
    double angle = now_.elasticity * strength, c = std::cos(angle), s = std::sin(angle);
    for (DVec3* v : {&now_.heading, &now_.left, &now_.up})
      *v = *v * c + glm::cross(axis, *v) * s + axis * (glm::dot(axis, *v) * (1 - c));
  }

  void push() {
    if constexpr (requires { sink_.push(now_); }) sink_.push(now_);
    stack_.push_back(now_);
    ++now_.depth;
  }

  void pop() {
    if (stack_.empty()) return;
    now_ = stack_.back();
    now_.grown = growth_.age;
    stack_.pop_back();
    if constexpr (requires { sink_.pop(now_); }) sink_.pop(now_);
  }

  void close_polygon() {
    if (polygons_.empty()) return;
    std::size_t first = polygons_.back();
    polygons_.pop_back();
    if constexpr (requires { sink_.polygon(std::span<const DVec3>(), now_); })
      if (vertices_.size() - first >= 3)
        sink_.polygon(std::span<const DVec3>(vertices_).subspan(first), now_);
    vertices_.resize(first);
  }

  void place_organ(SymbolId symbol, const double* parameters) {
    wants_organ_ = false;
    if constexpr (requires { sink_.organ(symbol, parameters, now_); }) sink_.organ(symbol, parameters, now_);
  }

  void place(Act act, int arity, const double* parameters) {
    DVec3 target = arity >= 3 ? DVec3(parameters[0], parameters[1], parameters[2]) : DVec3(0);
    if (act == Act::set_position) {
      if (arity >= 3) now_.position = target, now_.mark = -1;
    } else if (act == Act::random_turn) {
      double most = arity > 0 ? parameters[0] : 180.0;
      Seed seed = seed_.child("turn").child(acted_);
      double angles[3] = {seed.child(0).range(-most, most), seed.child(1).range(-most, most),
                          seed.child(2).range(-most, most)};
      turn(now_.heading, now_.left, true, angles, 1);
      turn(now_.heading, now_.up, true, angles + 1, 1);
      turn(now_.left, now_.up, true, angles + 2, 1);
    } else {
      if (arity >= 3) head_for(act == Act::level ? target - now_.position : target);
      if (act == Act::level) level();
    }
  }

  /// Swings the heading onto a direction by the shortest way.
  void head_for(DVec3 direction) {
    double length = glm::length(direction);
    if (!(length > 0)) return;
    direction /= length;
    DVec3 axis = glm::cross(now_.heading, direction);
    double s = glm::length(axis), c = glm::dot(now_.heading, direction);
    axis = s > 1e-12 ? axis / s : now_.up;
    if (s <= 1e-12) s = 0, c = c < 0 ? -1 : 1;
    for (DVec3* v : {&now_.left, &now_.up})
      *v = *v * c + glm::cross(axis, *v) * s + axis * (glm::dot(axis, *v) * (1 - c));
    now_.heading = direction;
  }

  /// Rolls until the left vector is horizontal and up points up; a vertical heading stays as it is.
  void level() {
    DVec3 left = glm::cross(DVec3(0, 1, 0), now_.heading);
    double length = glm::length(left);
    if (length < 1e-9) return;
    left /= length;
    if (growth_.age < 1) {  // the part of the roll that is done
      double roll = std::atan2(glm::dot(left, now_.up), glm::dot(left, now_.left)) * growth_.age;
      left = now_.left * std::cos(roll) + now_.up * std::sin(roll);
    }
    now_.left = left;
    now_.up = glm::cross(now_.heading, now_.left);
  }

  /// Sets or scales a quantity, as far as the module has grown.
  void set(double& quantity, double to) {
    double from = growth_.has_from ? growth_.from : quantity;
    quantity = growth_.age < 1 ? from + (to - from) * growth_.age : to;
  }
  void scale(double& quantity, double by) { quantity *= growth_.age < 1 ? 1 + (by - 1) * growth_.age : by; }

  void style(Act act, bool given, double value) {
    double width_by = given ? value : text_.width_scale, length_by = given ? value : text_.length_scale;
    double angle_by = given ? value : 0.9;
    switch (act) {
      case Act::narrow:
        return given ? set(now_.width, value) : scale(now_.width, text_.width_scale);
      case Act::widen:
        return given ? set(now_.width, value) : scale(now_.width, 1 / text_.width_scale);
      case Act::scale_width:
        return scale(now_.width, width_by);
      case Act::divide_width:
        return scale(now_.width, 1 / width_by);
      case Act::scale_length:
        return scale(now_.length, length_by);
      case Act::divide_length:
        return scale(now_.length, 1 / length_by);
      case Act::scale_angle:
        return scale(now_.angle, angle_by);
      case Act::divide_angle:
        return scale(now_.angle, 1 / angle_by);
      case Act::next_color:
        now_.color = given ? static_cast<int>(value) : now_.color + 1;
        return;
      case Act::previous_color:
        now_.color = given ? static_cast<int>(value) : now_.color - 1;
        return;
      case Act::set_elasticity:
        if (given) set(now_.elasticity, value);
        return;
      default:
        return;
    }
  }

  static constexpr double kHalfTurn = 180;

  const Grammar& grammar_;
  const GrammarText& text_;
  Sink& sink_;
  Seed seed_;
  Evaluation at_;
  TurtleState now_;
  std::vector<TurtleState> stack_;
  std::vector<DVec3> vertices_;        // of all polygons open
  std::vector<std::size_t> polygons_;  // the first vertex of each
  std::uint64_t fed_ = 0, acted_ = 0;
  Unfolding growth_;
  double turn_angle_ = 0, turn_sine_ = 0, turn_cosine_ = 1;
  int skipped_ = -1;  // brackets open since a cut; -1: not behind one
  bool wants_organ_ = false, jitters_ = false;
};

/// The turtle as a grammar sets it up: at the origin, heading up.
TurtleState start_of(const Grammar& grammar);

/// Walks a whole word. The state at its end.
template <class Sink>
TurtleState walk(const Grammar& grammar, const Word& word, Seed seed, Sink& sink) {
  Turtle<Sink> turtle(grammar, seed, sink, start_of(grammar));
  const double* parameters = word.parameters.data();
  for (SymbolId symbol : word.symbols) {
    turtle.feed(symbol, parameters);
    parameters += grammar.symbols[symbol].arity;
  }
  return turtle.state();
}

/// Fills the parameters of the questions `?P` `?H` `?U` `?L` of a word with what the turtle finds there, and
/// those of `?E` with what the environment answers.
void answer_queries(const Grammar& grammar, Word& word, Seed seed, const Environment& environment);

}  // namespace frond
