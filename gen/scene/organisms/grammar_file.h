#pragma once

#include <string>
#include <string_view>

#include "core/assets.h"
#include "grammar/grammar.h"

namespace frond {

/// Reads the text of a grammar: JSON, or another tool's (grammar/import.h), as what is in it says. `path` is
/// for messages; `files` finds the files that it names; `system` is which of several L-systems in a file.
Result<GrammarText> read_grammar(std::string_view text, const std::string& path, const Assets& files,
                                 std::string_view system = {});

/// A mistake in a rule knows the rule; here it learns the file.
Errors in_file(Errors errors, const std::string& path);

}  // namespace frond
