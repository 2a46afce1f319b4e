#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/result.h"

namespace frond {

/// Translates the words and formulas of Houdini's rules into ours, and gathers what they use.
class HoudiniWords {
 public:
  /// A premise or a successor; `parameters` are the names that its rule knows.
  std::string word(std::string_view text, const std::vector<std::string>& parameters);
  std::string formula(std::string_view text, const std::vector<std::string>& parameters);

  /// What cannot be had, of all texts since the last call.
  struct Refusal {
    std::string what;
    std::string_view where;  ///< a part of the text that was given
  };
  std::vector<Refusal> release_faults() { return std::exchange(faults_, {}); }

  std::string used, bare;               ///< symbols that occurred; those that did without a parameter
  std::string names;                    ///< variables of the node that occurred
  bool colors = false, stamps = false;  ///< parameters were left out
  bool takes_position = false, takes_age = false;  ///< since the caller has reset them

 private:
  std::string name(std::string_view found, const std::vector<std::string>& parameters, bool call);
  std::string parameters_of(char symbol, std::string_view inside, const std::vector<std::string>& parameters);
  void refuse(std::string what, std::string_view where) { faults_.push_back({std::move(what), where}); }

  std::vector<Refusal> faults_;
};

/// Whether it is a letter that draws nothing.
bool draws_nothing(char symbol);

/// The names of the parameters in the head of a rule: `A(i,j)<B(k)`.
std::vector<std::string> parameters_in(std::string_view head);

/// A word of which each module is replaced; `change` takes its symbol and what stands in its parentheses.
std::string each_module(std::string_view word,
                        const std::function<std::string(char symbol, std::string_view inside)>& change);

/// Where the parenthesis that opens at `open` closes; the end of the text where it does not.
std::size_t closing(std::string_view text, std::size_t open);

/// The parts between commas that stand in no parentheses.
std::vector<std::string_view> parts_of(std::string_view text);

}  // namespace frond
