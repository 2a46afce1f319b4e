#pragma once

#include <span>
#include <utility>

#include "grammar/derive.h"
#include "grammar/rewrite.h"
#include "grammar/turtle_state.h"
#include "model/skeleton.h"

namespace frond {

/// A turtle that receives modules one by one and reports its actions to a sink. Any of these members of the
/// sink may be missing:
///
///     void segment(const Segment&, TurtleState&);       // the state is that at the start but for `mark`
///     void push(TurtleState&);  void pop(TurtleState&); // the state that is kept; the state it is back in
///     void polygon(std::span<const DVec3>, const TurtleState&);
///     void organ(SymbolId shape, const double* parameters, const TurtleState&);
///     void bare(SymbolId, const double* parameters, const TurtleState&);  // a symbol without meaning
///     void sign(Act, std::span<const double> parameters, const TurtleState&);   // spheres, tubes, questions
///     void end(const TurtleState&);                     // at the end of the word
///
/// Where a guide forks there are several turtles until the end of the branch. Each processes a module before
/// the next one comes; questions are answered by the first turtle.
template <class Sink>
class Turtle {
 public:
  Turtle(const Grammar& grammar, Seed seed, Sink& sink, const TurtleState& start)
      : grammar_(grammar), text_(grammar.text), sink_(sink), seed_(seed), now_(start) {
    jitters_ = text_.angle_jitter != 0 || text_.length_jitter != 0;
    at_.tables = grammar.tables;
    set_turn(now_.angle);
    if (!grammar.guide.points.empty()) flock_.push_back({now_, {}, {}, seed});
  }

  /// The next module. Interpretation rules are applied first.
  void feed(SymbolId symbol, const double* parameters) {
    if (grammar_.interpretation.of[symbol].empty() || wants_organ_)
      return act(symbol, parameters), void(++fed_);
    at_.seed = seed_.child("interpret").child(fed_++);
    auto emit = [&](SymbolId s, const double* p) { return act(s, p), true; };
    if (!expander_.run(symbol, parameters, text_.interpretation_depth, at_, emit) && !wrong_)
      wrong_ = Error{expander_.rule().where, expander_.fault()};
  }

  /// The error of an interpretation rule; the rest of its result was dropped.
  Errors trouble() const { return wrong_ ? Errors{*wrong_} : Errors{}; }

  /// How far the next modules have grown.
  void set_growth(const Unfolding& growth) {
    growth_ = growth, now_.grown = growth.age;
    for (Strand& strand : flock_) strand.now.grown = growth.age;
  }

  /// The name that replaces the position in the word as source of randomness for the next module.
  void set_name(std::uint64_t name) { fed_ = name, acted_ = Seed::mix(name); }

  /// The state of the turtle; of the first one if there are several.
  const TurtleState& state() const { return flock_.empty() ? now_ : flock_[0].now; }

  /// Ends the word; returns the final state.
  const TurtleState& finish() {
    if constexpr (requires { sink_.end(now_); }) {
      if (flock_.empty()) sink_.end(now_);
      for (const Strand& strand : flock_) sink_.end(strand.now);
    }
    return state();
  }

 private:
  /// The state that each of several turtles has of its own.
  struct Strand {
    TurtleState now;
    std::vector<DVec3> vertices = {};
    std::vector<std::size_t> polygons = {};
    Seed seed;
  };

  void act(SymbolId symbol, const double* parameters) {
    const Symbol& info = grammar_.symbols[symbol];
    if (skipped_ >= 0 && !leave_cut(info.act)) return;
    if (flock_.empty()) return act_alone(info, symbol, parameters);
    act_together(info, symbol, parameters);
  }

  void act_together(const Symbol& info, SymbolId symbol, const double* parameters) {
    bool organ = wants_organ_, question = info.act >= Act::query_position && info.act <= Act::environment;
    std::uint64_t acted = acted_;
    if (info.act == Act::pop && !organ) return pop_together();
    if (info.act == Act::push && !organ) flock_sizes_.push_back(flock_.size());
    for (std::size_t i = 0, count = question ? 1 : flock_.size(); i < count; ++i) {
      wants_organ_ = organ, acted_ = acted;
      exchange(i);
      std::span<const std::int32_t> targets;
      if (info.act == Act::guide && !organ)
        targets = follow(grammar_.guide, now_);
      else
        act_alone(info, symbol, parameters);
      exchange(i);
      if (!targets.empty()) fork(i, targets);
    }
  }

  /// Swaps turtle `i` of the flock with the current one.
  void exchange(std::size_t i) {
    Strand& strand = flock_[i];
    std::swap(now_, strand.now), std::swap(seed_, strand.seed);
    vertices_.swap(strand.vertices), polygons_.swap(strand.polygons);
  }

  /// One turtle per target: the turtle itself takes the first one.
  void fork(std::size_t i, std::span<const std::int32_t> targets) {
    for (std::size_t k = 1; k < targets.size(); ++k) {
      Strand other = flock_[i];
      other.seed = other.seed.child("fork", static_cast<std::uint64_t>(targets[k]));
      lead(grammar_.guide, other.now, targets[k]);
      flock_.push_back(std::move(other));
    }
    lead(grammar_.guide, flock_[i].now, targets[0]);
  }

  /// Turtles that forked off within a branch end with it.
  void pop_together() {
    if (flock_sizes_.empty()) return;
    flock_.resize(flock_sizes_.back());
    flock_sizes_.pop_back();
    for (std::size_t i = flock_.size(); i-- > 0;) exchange(i), pop(), exchange(i);
  }

  void act_alone(const Symbol& info, SymbolId symbol, const double* parameters) {
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
      case Act::move:
      case Act::move_free:
      case Act::draw_half:
      case Act::move_half:
        return forward(info, parameters);
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
      case Act::pitch_by_gravity:
      case Act::bend_by_gravity:
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

  /// After a `%` everything is skipped until the branch ends.
  bool leave_cut(Act act) {
    if (act == Act::push) ++skipped_;
    if (act == Act::pop && skipped_-- == 0) return true;
    return false;
  }

  double chance() { return seed_.child("jitter").child(acted_).range(-1, 1); }

  /// Turns `a` towards `b` (and `b` away from `a`); the angle of the last turn is remembered with its sine.
  void turn(DVec3& a, DVec3& b, bool given, const double* parameters, double sign) {
    double angle = given ? parameters[0] : now_.angle;
    if (jitters_ && text_.angle_jitter != 0) angle += text_.angle_jitter * chance();
    if (growth_.age < 1) angle = growth_.from + (angle - growth_.from) * growth_.age;
    if (angle != turn_angle_) set_turn(angle);
    double c = turn_cosine_, s = turn_sine_ * sign;
    DVec3 turned = a * c + b * s;
    b = b * c - a * s;
    a = turned;
  }

  void set_turn(double angle) {
    turn_angle_ = angle;
    turn_sine_ = sine(angle);
    turn_cosine_ = sine(angle + 90.0);
  }

  void forward(const Symbol& info, const double* parameters) {
    bool draws = draws_line(info.act), vertex = info.act != Act::draw_free && info.act != Act::move_free;
    double length = way_of(info, parameters, now_.length, text_.dialect);
    if (jitters_ && text_.length_jitter != 0) length *= 1 + text_.length_jitter * chance();
    if (growth_.age < 1) length *= growth_.stretch;
    DVec3 to = now_.position + now_.heading * length;
    if (draws)
      draw(to, length, info.arity > 1 ? parameters[1] : now_.width);
    else
      now_.mark = -1, now_.consume_width();
    now_.position = to;
    if (vertex && !polygons_.empty()) vertices_.push_back(to);
    if (draws && now_.elasticity != 0) bend(now_, pull(), now_.elasticity);
  }

  /// A segment that tapers to a width, which becomes the turtle's; in other dialects it is as wide as that.
  void draw(DVec3 to, double length, double width) {
    bool tapers = text_.dialect == Dialect::abop;
    if (text_.dialect == Dialect::lparser) width *= std::abs(length);
    Segment line{now_.position, to, tapers ? now_.consume_width() : width, width};
    if constexpr (requires { sink_.segment(line, now_); }) sink_.segment(line, now_);
    if (tapers) now_.width = width;
  }

  DVec3 pull() const {
    return now_.pull < 0 ? DVec3(text_.tropism) : *grammar_.guide.points[now_.pull].tropism;
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
      if (arity >= 3) now_.position = target, now_.mark = -1, now_.consume_width();
    } else if (act == Act::pitch_by_gravity || act == Act::bend_by_gravity) {
      double pull = arity > 0 ? parameters[0] : 0.2;
      if (act == Act::bend_by_gravity) return bend(now_, {0, -1, 0}, pull * growth_.age);
      pull = degrees(pull * std::hypot(now_.heading.x, now_.heading.z));
      turn(now_.heading, now_.up, true, &pull, -1);
    } else if (act == Act::random_turn) {
      double most = arity > 0 ? parameters[0] : 180.0;
      Seed seed = seed_.child("turn").child(acted_);
      double angles[3] = {seed.child(0).range(-most, most), seed.child(1).range(-most, most),
                          seed.child(2).range(-most, most)};
      turn(now_.heading, now_.left, true, angles, 1);
      turn(now_.heading, now_.up, true, angles + 1, 1);
      turn(now_.left, now_.up, true, angles + 2, 1);
    } else {
      if (arity >= 3) head_for(now_, act == Act::level ? target - now_.position : target);
      if (act == Act::level) level(now_, growth_.age);
    }
  }

  /// Sets or scales a quantity, as far as the module has grown.
  void set(double& quantity, double to) {
    double from = growth_.has_from ? growth_.from : quantity;
    quantity = growth_.age < 1 ? from + (to - from) * growth_.age : to;
  }
  void scale(double& quantity, double by) { quantity *= growth_.age < 1 ? 1 + (by - 1) * growth_.age : by; }

  void style(Act act, bool given, double value) {
    if (changes_width(act)) now_.consume_width();
    if (act == Act::next_color || act == Act::previous_color) {
      now_.color = given ? color_index(value) : now_.color + (act == Act::next_color ? 1 : -1);
    } else if (act == Act::set_elasticity) {
      if (given) set(now_.elasticity, value);
    } else {
      // The others stand in pairs: what scales something, and what divides it.
      static constexpr std::pair<double TurtleState::*, double GrammarText::*> kScaled[] = {
          {&TurtleState::width, &GrammarText::width_scale},
          {&TurtleState::width, &GrammarText::width_scale},
          {&TurtleState::length, &GrammarText::length_scale},
          {&TurtleState::angle, &GrammarText::angle_scale}};
      int place = static_cast<int>(act) - static_cast<int>(Act::narrow);
      auto [quantity, usual] = kScaled[place / 2];
      if (act <= Act::widen && given) return set(now_.*quantity, value);
      double by = given ? value : text_.*usual;
      // With a parameter those of LParser multiply.
      bool divides = place % 2 == 1 && (!given || text_.dialect != Dialect::lparser);
      scale(now_.*quantity, divides ? 1 / by : by);
    }
  }

  static constexpr double kHalfTurn = 180;

  const Grammar& grammar_;
  const GrammarText& text_;
  Sink& sink_;
  Seed seed_;
  Evaluation at_;
  Expander expander_{grammar_, grammar_.interpretation};
  std::optional<Error> wrong_;
  TurtleState now_;
  std::vector<TurtleState> stack_;
  std::vector<DVec3> vertices_;           // of all open polygons
  std::vector<std::size_t> polygons_;     // the first vertex of each
  std::vector<Strand> flock_;             // all turtles, if there is a guide
  std::vector<std::size_t> flock_sizes_;  // size of the flock at each open bracket
  std::uint64_t fed_ = 0, acted_ = 0;
  Unfolding growth_;
  double turn_angle_ = 0, turn_sine_ = 0, turn_cosine_ = 1;
  int skipped_ = -1;  // number of brackets opened since a cut; -1: not after a cut
  bool wants_organ_ = false, jitters_ = false;
};

/// The turtle as set up by a grammar: at the origin, heading up.
TurtleState start_of(const Grammar& grammar);

/// Walks a whole word. Returns the final state; mistakes are appended to `errors`.
template <class Sink>
TurtleState walk(const Grammar& grammar, const Word& word, Seed seed, Sink& sink, Errors* errors = nullptr) {
  Turtle<Sink> turtle(grammar, seed, sink, start_of(grammar));
  const double* parameters = word.parameters.data();
  for (SymbolId symbol : word.symbols) {
    turtle.feed(symbol, parameters);
    parameters += grammar.symbols[symbol].arity;
  }
  if (errors) *errors = turtle.trouble();
  return turtle.finish();
}

/// Fills the parameters of the questions `?P` `?H` `?U` `?L` of a word with the turtle's values there, and
/// those of `?E` with the answers of the environment.
void answer_queries(const Grammar& grammar, Word& word, Seed seed, const Environment& environment);

}  // namespace frond
