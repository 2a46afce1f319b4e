#pragma once

#include "grammar/grammar.h"
#include "grammar/guide.h"
#include "preset/describe.h"

// The properties of grammars and their guides, as presets spell them; see preset/describe.h.

namespace frond {

/// The values of a guide point besides its position and its children.
void describe(Properties& v, GuidePoint& p);

/// The point before it.
void describe_rest(KeyWriter& v, GuidePoint& p);

/// The lines of a file that a guide names: the `l` elements of a Wavefront OBJ text, or a skeleton as SWC,
/// its main way first; which of them it is counts by what it holds.
Result<GuideLines> read_guide_file(const NamedFile& file);

/// Reads a line of points: each is [x, y, z], or an object with further values and `children`, the side lines
/// that start there. Points are appended; the parent of each is the one before it in its line.
bool read_guide_line(Reader& reader, const Value& value, std::vector<GuidePoint>& points);
/// The schema of such a line.
extern const std::string_view kGuideLineSchema;

/// What gives the line of a guide in place of points.
void describe_line(Properties& v, GuideText& g);

void describe(Properties& v, GuideText& g);

/// Takes a grammar from another program's file.
Errors load_grammar(const NamedFile& file, GrammarText& grammar);

/// `load` takes the grammar of another program's file, which `doc` tells of.
void describe_grammar(Properties& v, GrammarText& g, LoadFile load, std::string_view doc);

void describe(Properties& v, GrammarText& g);

}  // namespace frond
