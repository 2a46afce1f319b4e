#pragma once

#include <string_view>

#include "grammar/grammar.h"

namespace frond {

/// A file of LParser, `.ls`: depth, angle, thickness, axiom, rules `A=…` up to `@`, or the same by keywords.
Result<GrammarText> import_lparser(std::string_view text);

/// A rule list as in Houdini, one per line: the values of its node, `name: value`, and rules
/// `left<A(i)>right:condition=successor:probability`.
Result<GrammarText> import_houdini(std::string_view text);

/// By the file extension: `.ls`, any other is a Houdini list. What of it has no effect here is in the notes.
Result<GrammarText> import_grammar(std::string_view file_name, std::string_view text);

}  // namespace frond
