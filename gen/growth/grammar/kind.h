#pragma once

#include <string_view>

namespace frond {

/// Whose grammar a text is. What is of no known kind counts by the ending of its file's name.
enum class GrammarKind {
  preset,    ///< JSON
  lparser,   ///< LParser (`.ls`), and LMUSe, whose files have no thickness
  houdini,   ///< the rule list of Houdini's node (`.txt`)
  fractint,  ///< L-systems `Name { Angle 6 Axiom F … }` (`.l`)
  cpfg,      ///< cpfg (`.l`), and what that reader refuses by name: lpfg and L-Py
  skeleton,  ///< SWC: the nodes of a measured skeleton
};

/// By what is in the text, whatever the file is called.
GrammarKind grammar_kind(std::string_view file_name, std::string_view text);

}  // namespace frond
