#include <fmt/format.h>

#include <algorithm>

#include "cpfg/run.h"
#include "cpfg/turtle.h"

namespace frond::cpfg {

namespace {

/// A stretch of a scratch word that is still to be read, of those that stand in each other.
struct ExpansionLevel {
  std::size_t at, end, first_module, first_parameter;
};

void append_successor(Run& run, const CpfgProduction& production, CpfgWord& word, bool living) {
  carry_out(run, production.after);
  for (const ModuleText& module : production.successor) append_module(run, module, word, living);
}

/// Replaces modules of a word by those of their productions again and again, depth first, and hands out what
/// stays. `used` levels of the set's depth have been made already.
template <class Sink>
void expand(Run& run, const ProductionSet& set, Congruential48* lots, CpfgWord& scratch,
            const WordAround& around, int used, bool living, const Sink& sink) {
  std::vector<ExpansionLevel> levels{{0, scratch.modules.size(), 0, 0}};
  while (!levels.empty() && run.goes_on()) {
    ExpansionLevel& top = levels.back();
    if (top.at == top.end) {
      scratch.modules.resize(top.first_module);
      scratch.parameters.resize(top.first_parameter);
      levels.pop_back();
      continue;
    }
    bool deep = static_cast<int>(levels.size()) + used > set.depth;
    const CpfgProduction* production =
        deep ? nullptr : find_production(run, set, lots, scratch, top.at, top.end, &around);
    if (!production) {
      bool left = deep && !set.of_symbol[static_cast<unsigned char>(scratch.modules[top.at].symbol)].empty();
      if (left && &set == &run.system().decomposition)
        run.notes.insert(fmt::format("the decomposition came to its maximum depth {}", set.depth));
      std::size_t more = &set == &run.system().homomorphism ? read_with(scratch, top.at, top.end) : 0;
      for (std::size_t i = 0; i <= more; ++i) sink(scratch, top.at++);
      continue;
    }
    top.at += production->predecessor.size();
    std::size_t modules = scratch.modules.size(), parameters = scratch.parameters.size();
    append_successor(run, *production, scratch, living);
    if (!is_within(run, scratch)) return;
    levels.push_back({modules, scratch.modules.size(), modules, parameters});
  }
}

/// The L-systems at work along a word: those that enclose a place.
class Enclosing {
 public:
  explicit Enclosing(Run& run) : run_(run) { run_.instance = 0; }
  ~Enclosing() { run_.instance = 0; }

  /// Whether the module begins or ends a part; then that is done.
  bool passes(const CpfgWord& word, std::size_t at) {
    const CpfgModule& module = word.modules[at];
    if (!is_part_mark(run_.code, module)) return false;
    if (module.instance >= 0) {
      outer_.push_back({run_.instance, scale});
      if (module.count > 1) scale *= word.parameters[module.first + 1];
      run_.instance = module.instance;
    } else if (!outer_.empty()) {
      run_.instance = outer_.back().first;
      scale = outer_.back().second;
      outer_.pop_back();
    }
    return true;
  }

  float scale = 1;

 private:
  Run& run_;
  std::vector<std::pair<int, float>> outer_;
};

/// Makes the instance of a part that begins.
int new_instance(Run& run, float number) {
  auto same = [&](const CpfgSystem& system) { return static_cast<float>(system.number) == number; };
  auto found = std::ranges::find_if(run.code.systems, same);
  if (found == run.code.systems.end())
    return run.fail("", fmt::format("`?({},…)`: there is no L-system of that number", number)), -1;
  auto system = static_cast<int>(found - run.code.systems.begin());
  for (int above = run.instance; above >= 0; above = run.instances[static_cast<std::size_t>(above)].parent)
    if (run.instances[static_cast<std::size_t>(above)].system == system)
      return run.fail("", fmt::format("`?({},…)`: an L-system stands within itself", number)), -1;
  if (run.instances.size() >= 1'000'000)
    return run.fail("", "more than 1,000,000 parts under other L-systems"), -1;
  run.instances.push_back({system, run.instance, {}, {}});
  int instance = static_cast<int>(run.instances.size()) - 1;
  begin_instance(run, instance);
  return instance;
}

/// What becomes of the module at a place of a word; gives the next place.
std::size_t rewrite_at(Run& run, const CpfgWord& word, std::size_t at, CpfgWord& out) {
  const CpfgSystem& system = run.system();
  int index = run.instances[static_cast<std::size_t>(run.instance)].system;
  Congruential48* lots = system.rules.has_seed ? &run.lots[static_cast<std::size_t>(index)] : nullptr;
  const CpfgModule& module = word.modules[at];
  const CpfgProduction* production =
      find_production(run, system.rules, lots, word, at, word.modules.size(), nullptr);
  bool cuts = !production && module.symbol == '%' && module.count < 2;
  WordAround here{word, at, at + 1};
  if (cuts && !find_production(run, system.decomposition, nullptr, word, at, at + 1, &here)) {
    if (module.count == 0) return cut_end(word, at + 1);
    run.fail("", "`%(x)` hands what it cuts to a program of the environment, which is not there");
  }
  auto keep = [&](const CpfgWord& from, std::size_t i) {
    append_copy(from, i, out);
    is_within(run, out);
  };
  if (!production && system.decomposition.of_symbol[static_cast<unsigned char>(module.symbol)].empty())
    return keep(word, at), at + 1;
  std::size_t after = at + (production ? production->predecessor.size() : 1);
  if (system.decomposition.productions.empty()) {
    append_successor(run, *production, out, true);
    is_within(run, out);
    return after;
  }
  CpfgWord scratch;
  if (production)
    append_successor(run, *production, scratch, true);
  else
    append_copy(word, at, scratch);
  expand(run, system.decomposition, nullptr, scratch, WordAround{word, at, after}, 0, true, keep);
  return after;
}

}  // namespace

bool is_within(Run& run, const CpfgWord& word) {
  if (word.modules.size() + word.parameters.size() <= run.limits.modules) return true;
  run.fail("", fmt::format("the word has more than {} modules and parameters", run.limits.modules));
  return false;
}

void append_copy(const CpfgWord& from, std::size_t index, CpfgWord& word) {
  CpfgModule module = from.modules[index];
  std::uint32_t first = std::exchange(module.first, static_cast<std::uint32_t>(word.parameters.size()));
  for (std::uint32_t i = 0; i < module.count; ++i) word.parameters.push_back(from.parameters[first + i]);
  word.modules.push_back(module);
}

void append_module(Run& run, const ModuleText& text, CpfgWord& word, bool living) {
  CpfgModule module{text.symbol, static_cast<std::uint8_t>(text.count),
                    static_cast<std::uint32_t>(word.parameters.size())};
  for (int i = 0; i < text.count; ++i) {
    double value = evaluate(run, run.code.lists[static_cast<std::size_t>(text.first + i)]);
    word.parameters.push_back(static_cast<float>(value));
  }
  if (living && text.symbol == '?' && text.count > 0 && run.code.systems.size() > 1)
    module.instance = new_instance(run, word.parameters[module.first]);
  word.modules.push_back(module);
}

CpfgWord rewrite(Run& run, const CpfgWord& word) {
  CpfgWord out;
  out.modules.reserve(word.modules.size());
  out.parameters.reserve(word.parameters.size());
  Enclosing enclosing(run);
  for (std::size_t at = 0; at < word.modules.size() && run.goes_on();) {
    if (enclosing.passes(word, at))
      append_copy(word, at++, out);
    else
      at = rewrite_at(run, word, at, out);
  }
  return out;
}

CpfgDrawing draw_word(Run& run, const CpfgWord& word) {
  CpfgDrawing drawing;
  Enclosing enclosing(run);
  std::vector<Congruential48> streams;  // of formulas in homomorphisms that have a seed
  for (const CpfgSystem& system : run.code.systems)
    streams.push_back(seeded_stream(system.homomorphism.seed, run.variation));
  for (std::size_t at = 0; at < word.modules.size() && run.goes_on();) {
    auto keep = [&](const CpfgWord& from, std::size_t i) {
      append_copy(from, i, drawing.word);
      drawing.scale.push_back(enclosing.scale);
      drawing.origin.push_back(static_cast<std::int32_t>(at));
      is_within(run, drawing.word);
    };
    const ProductionSet& set = run.system().homomorphism;
    auto system = static_cast<std::size_t>(run.instances[static_cast<std::size_t>(run.instance)].system);
    const CpfgProduction* production = nullptr;
    if (!enclosing.passes(word, at) && set.depth > 0)
      production = find_production(run, set, nullptr, word, at, word.modules.size(), nullptr);
    if (!production) {
      std::size_t end = at + 1 + read_with(word, at, word.modules.size());
      while (at < end) keep(word, at), ++at;
      continue;
    }
    std::size_t after = at + production->predecessor.size();
    CpfgWord scratch;
    if (set.has_seed) std::swap(run.chance.stream, streams[system]);
    append_successor(run, *production, scratch, false);
    expand(run, set, nullptr, scratch, WordAround{word, at, after}, 1, false, keep);
    if (set.has_seed) std::swap(run.chance.stream, streams[system]);
    at = after;
  }
  return drawing;
}

}  // namespace frond::cpfg
