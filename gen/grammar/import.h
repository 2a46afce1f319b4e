#pragma once

#include <string_view>

#include "grammar/grammar.h"

namespace frond {

/// A grammar converted from the format of another tool, and which of its parts have no meaning here.
struct Import {
  GrammarText grammar;
  std::vector<std::string> notes;
};

/// LParser, `.ls`: depth, angle, thickness, axiom, rules `A=…` up to `@`.
Result<Import> import_lparser(std::string_view text);

/// A rule list as in Houdini, one per line: `name: value` lines (`premise`, `angle`, `generations`,
/// `stepsize`, `thickness`, `ignore`, constants) and rules `left<A(i)>right:condition=successor:probability`.
Result<Import> import_houdini(std::string_view text);

/// By the file extension: `.ls`, any other is a Houdini list.
Result<Import> import_grammar(std::string_view file_name, std::string_view text);

}  // namespace frond
