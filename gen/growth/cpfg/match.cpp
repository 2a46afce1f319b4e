#include "cpfg/run.h"

namespace frond::cpfg {

namespace {

bool is_ignored(const Run& run, const CpfgModule& module) {
  return run.system().ignored[static_cast<unsigned char>(module.symbol)] || is_part_mark(run.code, module);
}

/// Whether a module is of the pattern's kind; its parameters are read.
bool takes(Run& run, const PatternModule& pattern, const CpfgWord& word, std::size_t at) {
  const CpfgModule& module = word.modules[at];
  if (module.symbol != pattern.symbol || module.count != pattern.count) return false;
  for (int i = 0; i < pattern.count; ++i)
    run.formals[pattern.first + i] = word.parameters[module.first + static_cast<std::size_t>(i)];
  return true;
}

int nesting(char symbol) { return (symbol == '[') - (symbol == ']'); }

/// A place in a word that goes one way, in a ring around its end, past each module once at most.
class Walk {
 public:
  /// Before the first module that is seen.
  Walk(Run& run, const CpfgWord& word, std::size_t start, bool forward)
      : run_(run), size_(word.modules.size()), at_(start), forward_(forward) {}

  /// Goes to the next module; false where there is none.
  bool next() {
    if (!is_more() || !run_.goes_on()) return false;
    ++seen_;
    if (forward_) {
      index_ = at_ >= size_ ? at_ - size_ : at_;
      at_ = index_ + 1;
    } else {
      index_ = (at_ == 0 ? size_ : at_) - 1;
      at_ = index_;
    }
    return true;
  }
  void step_back() {  // forward only
    --seen_;
    at_ = index_;
  }
  std::size_t index() const { return index_; }

 private:
  bool is_more() const {
    if (run_.system().ring) return seen_ < size_;
    return forward_ ? at_ < size_ : at_ > 0;
  }

  Run& run_;
  std::size_t size_, at_, index_ = 0, seen_ = 0;
  bool forward_;
};

bool matches_left(Run& run, const CpfgProduction& production, const WordAround& around) {
  Walk walk(run, around.word, around.first, false);
  for (std::size_t i = production.left.size(); i-- > 0;) {
    const CpfgModule* module = nullptr;
    for (;;) {
      if (!walk.next()) return false;
      module = &around.word.modules[walk.index()];
      if (module->symbol == ']') {  // a branch beside
        for (int depth = 1; depth > 0;) {
          if (!walk.next()) return false;
          depth -= nesting(around.word.modules[walk.index()].symbol);
        }
      } else if (module->symbol != '[' && !is_ignored(run, *module)) {
        break;
      }
    }
    if (!takes(run, production.left[i], around.word, walk.index())) return false;
  }
  return true;
}

/// Goes to before the `]` that ends the branch, or to the end of the word.
void go_to_branch_end(Walk& walk, const CpfgWord& word) {
  for (int depth = 0; walk.next();) {
    depth += nesting(word.modules[walk.index()].symbol);
    if (depth < 0) return walk.step_back();
  }
}

bool matches_right(Run& run, const CpfgProduction& production, const WordAround& around) {
  const CpfgWord& word = around.word;
  Walk walk(run, word, around.after, true);
  for (const PatternModule& pattern : production.right) {
    if (pattern.symbol == '=' && pattern.count == 0) {
      go_to_branch_end(walk, word);
      continue;
    }
    for (;;) {
      if (!walk.next()) return false;
      const CpfgModule& module = word.modules[walk.index()];
      if (is_ignored(run, module)) continue;
      if (module.symbol != '[' || pattern.symbol == '[') break;
      for (int depth = 1; depth > 0;) {  // a branch that is not asked for
        if (!walk.next()) return false;
        depth += nesting(word.modules[walk.index()].symbol);
      }
    }
    if (!takes(run, pattern, word, walk.index())) return false;
  }
  return true;
}

/// Whether a production's predecessor stands in the word at a place before `end`; its parameters are read.
bool matches_predecessor(Run& run, const CpfgProduction& production, const CpfgWord& word, std::size_t at,
                         std::size_t end) {
  const std::vector<PatternModule>& pattern = production.predecessor;
  if (pattern.size() > end - at) return false;
  for (std::size_t i = 0; i < pattern.size(); ++i)
    if (!takes(run, pattern[i], word, at + i)) return false;
  return true;
}

/// Whether a production may be used here. Its block before the condition is run where it stands in the word.
bool applies(Run& run, const CpfgProduction& production, const CpfgWord& word, std::size_t at,
             std::size_t end, const WordAround* around) {
  if (!run.goes_on() || !matches_predecessor(run, production, word, at, end)) return false;
  WordAround own{word, at, at + production.predecessor.size()};
  if (!around) around = &own;
  if (!production.left.empty() && !matches_left(run, production, *around)) return false;
  if (!production.right.empty() && !matches_right(run, production, *around)) return false;
  carry_out(run, production.before);
  return (production.condition < 0 || evaluate(run, production.condition) != 0) && !run.error;
}

/// A production that takes part in a lot, its weight and its parameters.
struct Candidate {
  const CpfgProduction* production;
  double weight;
  std::vector<double> formals;
};

}  // namespace

bool is_part_mark(const Code& code, const CpfgModule& module) {
  return module.instance >= 0 || (module.symbol == '$' && module.count == 0 && code.systems.size() > 1);
}

const CpfgProduction* find_production(Run& run, const ProductionSet& set, Congruential48* lots,
                                      const CpfgWord& word, std::size_t at, std::size_t end,
                                      const WordAround* around) {
  double chance = lots ? lots->next() : 0, sum = 0;
  std::vector<Candidate> candidates;
  for (int index : set.of_symbol[static_cast<unsigned char>(word.modules[at].symbol)]) {
    const CpfgProduction& production = set.productions[index];
    if (!applies(run, production, word, at, end, around)) continue;
    if (!lots) return &production;
    double weight = production.weight < 0 ? 1 : evaluate(run, production.weight);
    sum += weight;
    candidates.push_back({&production, weight, run.formals});
  }
  chance *= sum;
  for (const Candidate& candidate : candidates) {
    chance -= candidate.weight;
    if (chance > 0) continue;
    run.formals = candidate.formals;
    return candidate.production;
  }
  return nullptr;
}

}  // namespace frond::cpfg
