#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cpfg/chance.h"
#include "cpfg/code.h"
#include "cpfg/cpfg.h"

namespace frond::cpfg {

/// An L-system at work with its own variables: the first of the file, or one that a `?(id,scale)` brought.
struct SystemInstance {
  int system = 0, parent = -1;
  std::vector<double> values;
  struct Place {
    int instance, slot;
  };
  std::vector<Place> externals;  ///< for each of CpfgSystem::externals; instance -1: it is its own
};

/// All that changes while a model is derived.
struct Run {
  const Code& code;
  CpfgLimits limits;
  std::uint64_t variation = 0;  ///< CpfgRequest::variation
  std::vector<SystemInstance> instances;
  int instance = 0;             ///< the one whose rules and variables count now
  std::vector<double> locals;   ///< of all productions
  std::vector<double> formals;  ///< of the production that is tried
  FormulaChance chance;
  std::vector<Congruential48> lots;  ///< of each L-system
  std::uint64_t work = 0;
  int loops = 0;            ///< loops of blocks that stand in each other now
  std::uint64_t turns = 0;  ///< turns of the outermost of them and all within it
  double length = 0;        ///< the derivation length
  bool stopped = false;
  std::optional<Error> error;
  std::set<std::string> notes;

  const CpfgSystem& system() const;
  /// Counts `more` operations. False when there were too many, or there is an error.
  bool goes_on(std::uint64_t more = 1);
  /// Counts a turn of a loop. False if there were too many, or an error; `place` is an index in Code::places.
  bool turns_on(int place);
  void fail(std::string where, std::string what);
};

/// A run with nothing in it.
Run begin_run(const Code& code, const CpfgLimits& limits, std::uint64_t variation = 0);

/// The value of a formula.
double evaluate(Run& run, int formula);
/// The value of a formula without variables, while a grammar is read; NaN where it has no value.
double constant_of(const Code& code, int formula);
/// Carries out a block; -1 does nothing.
void carry_out(Run& run, int block);
/// A value of a variable of the instance at work.
double& variable(Run& run, int slot);

/// The modules of the word around what is rewritten: [first, after).
struct WordAround {
  const CpfgWord& word;
  std::size_t first, after;
};

/// The production that is used at a place of a word, or none: the first that matches or, with `lots`, one by
/// chance. Its parameters are read. `around`: where contexts are looked for; nothing: around the predecessor
/// in the word itself.
const CpfgProduction* find_production(Run& run, const ProductionSet& set, Congruential48* lots,
                                      const CpfgWord& word, std::size_t at, std::size_t end,
                                      const WordAround* around);

/// Whether the module begins or ends a part under another L-system.
bool is_part_mark(const Code& code, const CpfgModule& module);

/// Appends a module of a successor or an axiom. `living`: a `?(id,scale)` begins an instance.
void append_module(Run& run, const ModuleText& module, CpfgWord& word, bool living);
/// Appends a copy of a module.
void append_copy(const CpfgWord& from, std::size_t index, CpfgWord& word);
/// Whether the word keeps to the limits; an error where not.
bool is_within(Run& run, const CpfgWord& word);

/// The word after the homomorphism.
CpfgDrawing draw_word(Run& run, const CpfgWord& word);
/// Makes one step.
CpfgWord rewrite(Run& run, const CpfgWord& word);
/// Gives an instance its first values and carries out its Start.
void begin_instance(Run& run, int instance);

}  // namespace frond::cpfg
