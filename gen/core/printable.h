#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/result.h"

namespace frond {

/// A text that may come from anywhere, fit to be shown to a person: on one line, without anything that steers
/// a terminal or turns the direction of writing (such characters are escaped, as \x1b or \u202e), and no
/// longer than about `most` bytes, the middle left out. At least 16 bytes are shown.
std::string printable(std::string_view text, std::size_t most = 1500);

/// An error as it is shown: its place, its pointer and its words, each cut for itself, so that the line and
/// the column stay.
std::string printable(const Error& error);

/// Whether it is a letter, digit, dot, dash or underscore: what shells, file systems and queues take as it
/// is.
bool is_plain(char c);

/// A text as it stands between tags of XML or in quotes there; control characters, which XML cannot write,
/// are blanks.
std::string xml_quoted(std::string_view text);

}  // namespace frond
