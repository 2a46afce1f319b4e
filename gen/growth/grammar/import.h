#pragma once

#include <string_view>

#include "grammar/grammar.h"

namespace frond {

/// A file of LParser: depth, angle, thickness, axiom, rules `A=…` up to `@`, or the same by keywords. Files
/// of LMUSe have no thickness.
Result<GrammarText> import_lparser(std::string_view text);

/// A rule list as in Houdini, one per line: the values of its node, `name: value`, and rules
/// `left<A(i)>right:condition=successor:probability`.
Result<GrammarText> import_houdini(std::string_view text);

/// The L-system of that name in a file of Fractint, `Name { Angle 6 Axiom F F=… }`; or else the only one.
Result<GrammarText> import_fractint(std::string_view text, std::string_view system = {});

/// A skeleton as SWC, a node a line: number, type, x, y, z, radius and the number of its parent, -1 for none.
/// The axiom draws it node by node and has a `T` at each tip. With `z_up` the z of the file becomes y.
Result<GrammarText> import_skeleton(std::string_view text, bool z_up = false);

/// The lines of such a skeleton: the way from each first node to a tip, then each branch that leaves it.
Result<GuideLines> skeleton_lines(std::string_view text);

/// By what is in the text (grammar/kind.h), whatever its lines end by. What of it has no effect here is in
/// the notes. `system`: which of several in a file.
Result<GrammarText> import_grammar(std::string_view file_name, std::string_view text,
                                   std::string_view system = {});

}  // namespace frond
