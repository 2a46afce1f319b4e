#include "grammar/figure.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "grammar/between.h"
#include "grammar/stream.h"

namespace frond {

namespace {

template <class V>
bool finite(const V& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

struct Measure {
  TurtleStats stats;
  bool drawn = false;

  void segment(const Segment& s, TurtleState&) {
    if (!drawn) stats.low = stats.high = s.from;
    drawn = true;
    ++stats.segments;
    stats.total_length += glm::distance(s.from, s.to);
    stats.low = glm::min(stats.low, glm::min(s.from, s.to));
    stats.high = glm::max(stats.high, glm::max(s.from, s.to));
  }
  void push(TurtleState& state) { stats.max_stack_depth = std::max(stats.max_stack_depth, state.depth + 1); }
  void polygon(std::span<const DVec3>, const TurtleState&) { ++stats.polygons; }
  void end(const TurtleState& state) { stats.end_positions.push_back(state.position); }

  /// A line that is not finite leaves its mark on the total length.
  Errors find_infinite(const TurtleState& end) const {
    bool good =
        std::isfinite(stats.total_length) && finite(end.heading) && finite(end.left) && finite(end.up);
    for (DVec3 place : stats.end_positions) good &= finite(place);
    return good ? Errors{} : out_of_range();
  }

  TurtleStats finish(const TurtleState& end) {
    stats.end_position = end.position;
    stats.end_heading = end.heading;
    stats.end_left = end.left;
    stats.end_up = end.up;
    return stats;
  }
};

constexpr float kThinnest = 1e-6f;

/// Gathers a figure; `mark` of the turtle is the node it stands on.
struct Builder {
  const Grammar& grammar;
  Figure figure;
  std::array<bool, 256> sites{};  // symbols that are organs without a ~
  std::uint64_t next_site = 0, next_outline = 0;

  void module(std::uint64_t name) { next_site = next_outline = name; }

  void bare(SymbolId symbol, const double* parameters, const TurtleState& state) {
    if (sites[symbol]) organ(symbol, parameters, state);
  }

  void segment(const Segment& s, TurtleState& state) {
    Vec3 to(s.to);
    if (state.mark < 0) add(Vec3(s.from), s.width_from, Skeleton::kRoot, state);
    if (to == figure.skeleton.position[static_cast<std::size_t>(state.mark)]) return;
    add(to, s.width_to, state.mark, state);
  }

  void add(Vec3 at, double width, std::int32_t below, TurtleState& state) {
    float radius = std::max(kThinnest, static_cast<float>(width / 2));
    auto order = static_cast<std::uint16_t>(std::min(state.depth, 65535));
    state.mark = state.base = figure.skeleton.add(at, radius, below, order);
    figure.color.push_back(state.color);
  }

  void polygon(std::span<const DVec3> points, const TurtleState& state) {
    Outline outline{{}, state.color, state.base, next_outline++};
    for (DVec3 point : points)  // `F.` names its end twice
      if (outline.points.empty() || outline.points.back() != Vec3(point)) outline.points.emplace_back(point);
    if (outline.points.size() > 3 && outline.points.front() == outline.points.back())
      outline.points.pop_back();
    if (outline.points.size() >= 3) figure.outlines.push_back(std::move(outline));
  }

  void organ(SymbolId shape, const double* parameters, const TurtleState& state) {
    const Symbol& symbol = grammar.symbols[shape];
    Vec3 scale(1);
    if (symbol.arity >= 3)
      scale = Vec3(parameters[0], parameters[1], parameters[2]);
    else if (symbol.arity >= 1)
      scale = Vec3(static_cast<float>(parameters[0]));
    place(symbol.name, scale, state);
    if (symbol.arity == 2 || symbol.arity == 4) figure.sites.back().stage = parameters[symbol.arity - 1];
  }

  void sign(Act act, std::span<const double> parameters, TurtleState& state) {
    if (act == Act::tube_start || act == Act::tube_point || act == Act::tube_end) return tube(act, state);
    if (act != Act::sphere && act != Act::disc) return;
    double size = parameters.empty() ? state.width : parameters[0];
    place(act == Act::sphere ? "@O" : "@o", Vec3(static_cast<float>(size)), state);
  }

  /// A point of a generalized cylinder: joined to the one before, whatever moves lie between.
  void tube(Act act, TurtleState& state) {
    Vec3 here(state.position);
    auto at = [&](std::int32_t node) { return figure.skeleton.position[static_cast<std::size_t>(node)]; };
    std::int32_t before = act == Act::tube_start ? -1 : state.tube;
    if (before >= 0 && at(before) == here)
      state.mark = before;
    else if (state.mark < 0 || at(state.mark) != here)
      add(here, state.width, before < 0 ? Skeleton::kRoot : before, state);
    state.tube = act == Act::tube_end ? -1 : state.mark;
  }

  void place(std::string name, Vec3 scale, const TurtleState& s) {
    scale *= static_cast<float>(s.grown);
    figure.sites.push_back({std::move(name), Vec3(s.position), Vec3(s.heading), Vec3(s.left), Vec3(s.up),
                            scale, s.color, s.base, next_site++});
  }
};

/// Writes the answers to the questions into the word that is being walked.
struct Answers {
  double* first;
  double* last;
  const Environment& environment;

  void sign(Act act, std::span<const double> parameters, const TurtleState& state) {
    std::ptrdiff_t place = parameters.data() - first;
    if (place < 0 || place >= last - first) return;  // the module was made by an interpretation rule
    if (act == Act::environment && environment) environment(state, {first + place, parameters.size()});
    const DVec3* answer = act == Act::query_position  ? &state.position
                          : act == Act::query_heading ? &state.heading
                          : act == Act::query_up      ? &state.up
                          : act == Act::query_left    ? &state.left
                                                      : nullptr;
    for (std::size_t i = 0; answer && i < parameters.size() && i < 3; ++i)
      first[static_cast<std::size_t>(place) + i] = (*answer)[static_cast<int>(i)];
  }
};

}  // namespace

Errors out_of_range() {
  return {{"",
           "the turtle walks beyond all that can be drawn: a length, a width or an angle grows too large; "
           "use fewer steps or smaller factors"}};
}

Errors check_places(const Figure& f) {
  constexpr float kFarthest = 1e18f;
  auto near = [](Vec3 p) { return finite(p) && glm::all(glm::lessThan(glm::abs(p), Vec3(kFarthest))); };
  bool good = true;
  for (const Vec3& p : f.skeleton.position) good &= near(p);
  for (float radius : f.skeleton.radius) good &= radius < kFarthest;
  for (const Outline& outline : f.outlines)
    for (const Vec3& p : outline.points) good &= near(p);
  for (const Site& s : f.sites)
    good &= near(s.position) && near(s.scale) && finite(s.heading) && finite(s.up);
  return good ? Errors{} : out_of_range();
}

TurtleState start_of(const Grammar& grammar) {
  TurtleState start;
  start.length = grammar.text.length;
  start.width = grammar.text.width;
  start.angle = grammar.text.angle;
  start.elasticity = grammar.text.elasticity;
  if (grammar.text.dialect == Dialect::lparser) start.color = 2;
  start.position = grammar.text.start;
  head_for(start, grammar.text.start_heading);
  return start;
}

TurtleStats stats_of(const Grammar& grammar, const Word& word, Seed seed) {
  Measure measure;
  TurtleState end = walk(grammar, word, seed, measure);
  return measure.finish(end);
}

Result<TurtleStats> stats_of(const Grammar& grammar, double steps, Seed seed, const Limits& limits) {
  Measure measure;
  Result<TurtleState> end = draw_between(grammar, steps, seed, measure, limits);
  if (!end) return end.errors();
  if (Errors errors = measure.find_infinite(*end); !errors.empty()) return errors;
  return measure.finish(*end);
}

Figure figure_of(const Grammar& grammar, const Word& word, Seed seed) {
  Builder builder{grammar, {}, {}};
  walk(grammar, word, seed, builder);
  return std::move(builder.figure);
}

Result<Figure> figure_of(const Grammar& grammar, double steps, Seed seed, const Limits& limits,
                         std::span<const std::string> organs, bool named) {
  Builder builder{grammar, {}, {}};
  for (std::size_t i = 0; i < grammar.symbols.size(); ++i)
    builder.sites[i] = std::find(organs.begin(), organs.end(), grammar.symbols[i].name) != organs.end();
  Result<TurtleState> end = draw_between(grammar, steps, seed, builder, limits, named);
  if (!end) return end.errors();
  if (Errors errors = check_places(builder.figure); !errors.empty()) return errors;
  return std::move(builder.figure);
}

Result<Skeleton> skeleton_of(const Grammar& grammar, const Word& word, Seed seed) {
  Builder builder{grammar, {}, {}};
  Errors errors;
  walk(grammar, word, seed, builder, &errors);
  if (errors.empty()) errors = check_places(builder.figure);
  if (!errors.empty()) return errors;
  return std::move(builder.figure.skeleton);
}

void answer_queries(const Grammar& grammar, Word& word, Seed seed, const Environment& environment) {
  Answers answers{word.parameters.data(), word.parameters.data() + word.parameters.size(), environment};
  walk(grammar, word, seed, answers);
}

}  // namespace frond
