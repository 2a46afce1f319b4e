#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "preset/value.h"

namespace frond {

/// An error in a preset.
struct Fault {
  Origin origin;
  std::string pointer;                       ///< JSON pointer of the value, "" for the whole
  std::string what;                          ///< `found ...; expected ...`
  std::optional<std::string> unknown = {};   ///< for an unknown property: its name; `what` is then empty
  std::vector<std::string_view> names = {};  ///< and the known names

  /// `file:line:column: /json/pointer` and what is wrong.
  Error error() const;
};

/// All errors in the order found. Equal messages about the same place are stored once.
class Faults {
 public:
  void add(Fault fault);
  const std::vector<Fault>& list() const { return list_; }
  /// In the order of the file; those without a file come last.
  Errors errors() const;

 private:
  std::vector<Fault> list_;
  std::set<std::pair<std::string, std::string>> seen_;
};

/// The errors of a value that may match several descriptions: those found by every one of them, at the same
/// place or at one that contains it. A name is unknown only if no description knows it.
std::vector<Fault> common_faults(const std::vector<std::vector<Fault>>& readings);

}  // namespace frond
