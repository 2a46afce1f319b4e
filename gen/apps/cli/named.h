#pragma once

#include <string>

namespace frond {

/// The file of the preset that a word of the command line names: one at that path, or at that path with .json
/// behind it; else what a preset begins with that is of that kind, or what comes with Frond, see
/// shipped_preset(). The word itself where there is none.
std::string preset_named(const std::string& word);

/// The file of the grammar or preset that a word of the command line names, as preset_named() finds it;
/// grammars that come with Frond go before its presets.
std::string grammar_named(const std::string& word);

}  // namespace frond
