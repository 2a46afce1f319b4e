#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "preset/value.h"

namespace frond {

/// Something wrong in a preset.
struct Fault {
  Origin origin;
  std::string pointer;                       ///< JSON pointer of the value, "" for the whole
  std::string what;                          ///< `found ...; expected ...`
  std::optional<std::string> unknown = {};   ///< of an unknown property: its name; `what` is empty then
  std::vector<std::string_view> names = {};  ///< and the names that would have been known

  /// `file:line:column: /json/pointer` and what is wrong.
  Error error() const;
};

/// All that is wrong, in the order found. The same words about the same place are kept once.
class Faults {
 public:
  void add(Fault fault);
  const std::vector<Fault>& list() const { return list_; }
  /// In the order of the file, those of no file last.
  Errors errors() const;

 private:
  std::vector<Fault> list_;
  std::set<std::pair<std::string, std::string>> seen_;
};

/// What is wrong with a value that several descriptions may read: the faults which every one of them finds,
/// at the same place or at one that holds it. A name is unknown only where none knows it.
std::vector<Fault> common_faults(const std::vector<std::vector<Fault>>& readings);

}  // namespace frond
