#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "cpfg/run.h"
#include "cpfg/shapes.h"
#include "cpfg/turtle.h"

namespace frond::cpfg {

namespace {

/// What EndEach, StartEach and End are carried out for: the first instance, and those with parts in the word.
std::vector<int> living(const Run& run, const CpfgWord& word) {
  std::vector<int> list{0};
  if (run.code.systems.size() == 1) return list;
  for (const CpfgModule& module : word.modules)
    if (module.instance >= 0) list.push_back(module.instance);
  return list;
}

void carry_out_for(Run& run, const std::vector<int>& instances, int CpfgSystem::*block) {
  for (int instance : instances) {
    run.instance = instance;
    carry_out(run, run.system().*block);
  }
  run.instance = 0;
}

/// Frees the variables of instances whose parts are gone.
void drop_instances(Run& run, const std::vector<int>& alive) {
  std::vector<bool> kept(run.instances.size());
  for (int instance : alive)  // with those around them, whose variables they may use
    for (; instance >= 0; instance = run.instances[instance].parent) kept[instance] = true;
  for (std::size_t i = 0; i < kept.size(); ++i)
    if (!kept[i]) run.instances[i].values = {};
}

void set_step(Run& run, const std::vector<int>& instances, int step) {
  for (int instance : instances) run.instances[instance].values[kStepSlot] = step;
}

class Deriver {
 public:
  Deriver(const CpfgModel& model, const CpfgRequest& request)
      : model_(model),
        request_(request),
        run_(begin_run(*model.code, request.limits, request.variation)),
        turtle_(turtle_settings(model)) {}

  Result<CpfgDerived> derive() {
    begin();
    int step = 0;
    while (!run_.error && !run_.stopped && step < wanted()) {
      if (step >= request_.limits.steps) {
        run_.fail(
            "", fmt::format("{} steps are asked for; expected at most {}", wanted(), request_.limits.steps));
        break;
      }
      advance(++step);
      if (run_.error) run_.error->what = fmt::format("step {}: {}", step, run_.error->what);
    }
    if (!run_.error && request_.drawing) derived_.drawing = draw_word(run_, derived_.word);
    if (run_.error) {
      if (run_.error->where.empty()) run_.error->where = model_.files.grammar.string();
      return *run_.error;
    }
    derived_.steps = step;
    derived_.notes.assign(run_.notes.begin(), run_.notes.end());
    return std::move(derived_);
  }

 private:
  double wanted() const { return request_.steps ? *request_.steps : run_.length; }

  void begin() {
    run_.instances.push_back({});
    begin_instance(run_, 0);
    for (const ModuleText& module : run_.system().axiom) append_module(run_, module, derived_.word, true);
  }

  void fill_queries() {
    if (run_.error || !has_queries(derived_.word)) return;
    CpfgDrawing drawing = draw_word(run_, derived_.word);
    if (run_.error) return;
    bool surfaces =
        std::ranges::any_of(drawing.word.modules, [](auto& module) { return module.symbol == '~'; });
    if (surfaces && model_.shapes->missing)
      return run_.fail(model_.shapes->missing->where, model_.shapes->missing->what);
    answer_queries(turtle_, drawing, derived_.word);
  }

  void advance(int step) {
    if (!turtle_.answers_after) fill_queries();
    std::vector<int> instances = living(run_, derived_.word);
    set_step(run_, instances, step);
    carry_out_for(run_, instances, &CpfgSystem::start_each);
    derived_.word = rewrite(run_, derived_.word);
    if (turtle_.answers_after) fill_queries();
    if (run_.error) return;
    instances = living(run_, derived_.word);
    drop_instances(run_, instances);
    set_step(run_, instances, step);
    carry_out_for(run_, instances, &CpfgSystem::end_each);
    if (step >= run_.length) carry_out_for(run_, {0}, &CpfgSystem::end);
  }

  const CpfgModel& model_;
  const CpfgRequest& request_;
  Run run_;
  TurtleSettings turtle_;
  CpfgDerived derived_;
};

/// Where a name of an enclosing L-system is, from the nearest outward; instance -1 where none has it.
SystemInstance::Place place_of(const Run& run, const ExternalName& name, int nearest) {
  for (int above = nearest; above >= 0;) {
    const SystemInstance& instance = run.instances[above];
    const CpfgSystem& system = run.code.systems[instance.system];
    for (std::size_t i = 0; i < system.externals.size(); ++i)
      if (system.externals[i].name == name.name && system.externals[i].count >= name.count)
        return instance.externals[i];
    for (const CpfgArray& array : system.arrays) {
      int count = 1;
      for (int size : array.sizes) count *= size;
      if (array.name == name.name && count >= name.count) return {above, array.slot};
    }
    auto found = system.variables.find(name.name);
    if (found != system.variables.end() && name.count == 1) return {above, found->second};
    above = instance.parent;
  }
  return {-1, 0};
}

void append_number(std::string& text, float value) {
  char digits[32];
  auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
  text.append(digits, end);
}

}  // namespace

Run begin_run(const Code& code, const CpfgLimits& limits, std::uint64_t variation) {
  Run run{code, limits, variation, {}, 0, {}, {}, {}, {}, 0, 0, 0, 0, false, {}, {}};
  run.formals.resize(static_cast<std::size_t>(code.formals));
  run.locals.resize(static_cast<std::size_t>(code.locals));
  if (variation != 0) run.chance = {Congruential48(variation), false, 0};
  for (const CpfgSystem& system : code.systems) run.lots.push_back(lots_of(system.rules.seed, variation));
  return run;
}

void begin_instance(Run& run, int instance) {
  constexpr std::size_t kMostValues = 50'000'000;
  const CpfgSystem& system = run.code.systems[run.instances[instance].system];
  std::size_t values = static_cast<std::size_t>(system.slots);
  if (!run.goes_on(run.instances.size())) return;
  for (const SystemInstance& other : run.instances) values += other.values.size();
  if (values > kMostValues) return run.fail("", "the variables of all L-systems are more than 50,000,000");
  int before = std::exchange(run.instance, instance);
  SystemInstance& own = run.instances[instance];
  own.values.assign(static_cast<std::size_t>(system.slots), 0);
  for (const ExternalName& name : system.externals) own.externals.push_back(place_of(run, name, own.parent));
  if (system.length >= 0) {
    double length = evaluate(run, system.length);
    own.values[kLengthSlot] = std::isfinite(length) ? std::clamp(std::trunc(length), 0.0, 1e9) : 0;
  }
  if (instance == 0) run.length = own.values[kLengthSlot];
  for (const CpfgArray& array : system.arrays)
    for (std::size_t i = 0; i < array.initial.size(); ++i)  // what is assigned is evaluated first
      run.instances[instance].values[array.slot + i] = evaluate(run, array.initial[i]);
  carry_out(run, system.start);
  run.instance = before;
}

}  // namespace frond::cpfg

namespace frond {

namespace {

/// `a-b step s, c-d step t`: from the first a to the last b, by the first step.
void read_intervals(std::string value, CpfgFilm& film) {
  std::ranges::replace(value, '-', ' ');
  std::string_view rest = value, last = rest.substr(rest.find_last_of(',') + 1);
  auto whole = [](double n) { return static_cast<int>(std::clamp(n, 0.0, 1e6)); };
  if (std::vector<double> numbers = cpfg::numbers_in(rest); numbers.size() > 1) {
    film.first = whole(numbers[0]);
    if (numbers.size() > 2) film.step = std::max(whole(numbers[2]), 1);
  }
  if (std::vector<double> numbers = cpfg::numbers_in(last); numbers.size() > 1) film.last = whole(numbers[1]);
}

}  // namespace

CpfgFilm film_of(const CpfgModel& model, int steps) {
  CpfgFilm film{0, 1, steps};
  auto number = [](const CpfgViewLine& line) {
    std::vector<double> found = cpfg::numbers_in(line.value);
    return found.empty() ? -1 : static_cast<int>(std::clamp(found[0], -1.0, 1e6));
  };
  for (const CpfgViewLine& line : model.animation) {
    if (line.key == "first frame") film.first = std::max(number(line), 0);
    if (line.key == "last frame") film.last = std::max(number(line), steps);
    if (line.key == "step") film.step = std::max(number(line), 1);
    if (line.key == "frame intervals") read_intervals(line.value, film);
  }
  film.first = std::min(film.first, film.last);
  return film;
}

Result<CpfgDerived> derive(const CpfgModel& model, const CpfgRequest& request) {
  return cpfg::Deriver(model, request).derive();
}

std::string text(const CpfgWord& word, const CpfgModel& model) {
  std::string out;
  for (const CpfgModule& module : word.modules) {
    out += module.symbol;
    for (std::uint32_t i = 0; i < module.count; ++i) {
      float value = word.parameters[module.first + i];
      out += i == 0 ? '(' : ',';
      auto index = static_cast<std::size_t>(cpfg::string_index(value));
      if (index < model.code->strings.size())
        out += '"' + model.code->strings[index] + '"';
      else
        cpfg::append_number(out, value);
    }
    if (module.count > 0) out += ')';
  }
  return out;
}

}  // namespace frond
