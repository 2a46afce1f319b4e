#include "plan/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "grammar/derive.h"

namespace frond {

namespace {

constexpr std::uint64_t kMostModules = 100'000;
constexpr PlanCell kHeadings[] = {
    {0, 1}, {-1, 0}, {0, -1}, {1, 0}};  // to the back, and turning left from there

int quarters(int turns) { return ((turns % 4) + 4) % 4; }

/// The turtle, which lays out a plan.
class Walker {
 public:
  Walker(const PlanText& text, const Grammar& grammar, GroundPlan& plan)
      : text_(text), grammar_(grammar), plan_(plan) {
    PlanCell gate((text.size[0] - 1) / 2, 0);
    plan_.cells.assign(static_cast<std::size_t>(text.size[0] * text.size[1]), GroundPlan::kFree);
    mark(gate) = GroundPlan::kWay;
    plan_.steps.push_back({gate - kHeadings[0], gate});
    now_.at = gate;
  }

  void walk(const Word& word) {
    const double* parameters = word.parameters.data();
    for (SymbolId id : word.symbols) {
      const Symbol& symbol = grammar_.symbols[id];
      act(symbol, parameters);
      parameters += symbol.arity;
    }
  }

 private:
  struct State {
    PlanCell at{0};
    int heading = 0;
    bool stuck = false;  // a step was not made: the rest of the branch is passed over
  };

  int& mark(PlanCell c) { return plan_.cells[static_cast<std::size_t>(c.y * plan_.size[0] + c.x)]; }
  PlanCell ahead() const { return kHeadings[now_.heading]; }

  void act(const Symbol& symbol, const double* parameters) {
    if (symbol.act == Act::push) return kept_.push_back(now_);
    if (symbol.act == Act::pop) {
      if (!kept_.empty()) now_ = kept_.back(), kept_.pop_back();
      return;
    }
    if (now_.stuck) return;
    auto whole = [&](int i, double otherwise, double unit, double most) {
      double given = symbol.arity > i ? parameters[i] / unit : otherwise;
      return std::isfinite(given) ? static_cast<int>(std::lround(std::clamp(given, -most, most))) : 0;
    };
    if (symbol.act == Act::yaw_left) now_.heading = quarters(now_.heading + whole(0, 1, 90, 1e6));
    if (symbol.act == Act::yaw_right) now_.heading = quarters(now_.heading - whole(0, 1, 90, 1e6));
    if (symbol.act == Act::turn_back) now_.heading = quarters(now_.heading + 2);
    if (symbol.act == Act::draw)
      for (int left = whole(0, 1, 1, 64); left > 0 && !now_.stuck; --left) now_.stuck = !step();
    auto kind = std::ranges::find(text_.rooms, symbol.name, &RoomKind::symbol);
    if (kind == text_.rooms.end()) return;
    PlanCell size(whole(0, kind->size[0], 1, 64), whole(1, kind->size[1], 1, 64));
    now_.stuck = !open(static_cast<std::size_t>(kind - text_.rooms.begin()), size);
  }

  /// The last cell straight on that is still of the turtle's room, or its own.
  PlanCell threshold() const {
    int here = plan_.at(now_.at);
    PlanCell last = now_.at;
    while (here >= 0 && plan_.at(last + ahead()) == here) last += ahead();
    return last;
  }

  bool step() {
    PlanCell from = threshold(), to = from + ahead();
    if (!plan_.inside(to) || plan_.at(to) >= 0) return false;
    mark(to) = GroundPlan::kWay;
    plan_.steps.push_back({from, to});
    now_.at = to;
    return true;
  }

  bool open(std::size_t kind, PlanCell size) {
    if (size.x < 1 || size.y < 1) return false;
    PlanCell from = threshold(), first = from + ahead(), right = kHeadings[quarters(now_.heading - 1)];
    PlanCell corner = first - right * ((size.x - 1) / 2),
             other = corner + right * (size.x - 1) + ahead() * (size.y - 1);
    PlanRoom room{kind, glm::min(corner, other), glm::max(corner, other), now_.heading};
    if (!plan_.inside(room.low) || !plan_.inside(room.high)) return false;
    auto each = [&](auto what) {
      for (int y = room.low.y; y <= room.high.y; ++y)
        for (int x = room.low.x; x <= room.high.x; ++x) what(mark({x, y}));
    };
    bool free = true;
    each([&](int cell) { free = free && cell == GroundPlan::kFree; });
    if (!free) return false;
    each([&](int& cell) { cell = static_cast<int>(plan_.rooms.size()); });
    plan_.rooms.push_back(room);
    plan_.steps.push_back({from, first});
    now_.at = room.middle();
    return true;
  }

  const PlanText& text_;
  const Grammar& grammar_;
  GroundPlan& plan_;
  State now_;
  std::vector<State> kept_;
};

}  // namespace

Result<Grammar> compile_plan(const PlanText& text) {
  GrammarText grammar = text.grammar;
  for (const RoomKind& kind : text.rooms) {
    grammar.organs.push_back(kind.symbol);
    if (kind.symbol.size() > 1) grammar.symbols.push_back(kind.symbol);
  }
  grammar.limits.modules = std::min(grammar.limits.modules, kMostModules);
  return compile(grammar);
}

Result<GroundPlan> derive_plan(const PlanText& text, const Grammar& grammar, Seed seed) {
  Result<Word> word = derive(grammar, grammar.text.steps, seed, grammar.text.limits);
  if (!word) return word.errors();
  GroundPlan plan;
  plan.size = text.size;
  Walker(text, grammar, plan).walk(interpret(grammar, *word, seed));
  return plan;
}

Errors plan_faults(const PlanText& text, double reach) {
  Errors errors;
  auto fault = [&](std::string where, std::string what) {
    errors.push_back({std::move(where), std::move(what)});
  };
  double away = glm::length(text.cell / 2 * glm::dvec2(text.size[0], text.size[1]));
  if (away > reach)
    fault("/size", fmt::format("cells of {:g} m reach {:.3g} m from the middle; expected {:g} m at most, by "
                               "fewer or smaller ones",
                               text.cell, away, reach));
  if (text.way > text.opening)
    fault("/way", fmt::format("ways of {:g} m do not pass openings of {:g} m; expected narrower ways or a "
                              "wider opening",
                              text.way, text.opening));
  for (std::size_t i = 0; i < text.rooms.size(); ++i) {
    const RoomKind& kind = text.rooms[i];
    if (text.opening > text.cell - 2 * kind.inset)
      fault(fmt::format("/rooms/{}/inset", i),
            fmt::format("leaves {:g} m of a cell, too little for openings of {:g} m; expected less, a "
                        "narrower opening or larger cells",
                        text.cell - 2 * kind.inset, text.opening));
    if (act_of(kind.symbol, text.grammar.dialect) != Act::none)
      fault(fmt::format("/rooms/{}/symbol", i),
            fmt::format("\"{}\" means something to the turtle; expected another symbol", kind.symbol));
    for (std::size_t k = 0; k < i; ++k)
      if (text.rooms[k].symbol == kind.symbol)
        fault(fmt::format("/rooms/{}/symbol", i),
              fmt::format("\"{}\" opens rooms named \"{}\" already; expected another symbol", kind.symbol,
                          text.rooms[k].name));
  }
  return errors;
}

}  // namespace frond
