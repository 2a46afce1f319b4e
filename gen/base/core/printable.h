#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/result.h"

namespace frond {

/// An untrusted text made safe to show: one line, with control characters and changes of writing direction
/// escaped (as \x1b or \u202e), cut in the middle to about `most` bytes. At least 16 bytes are shown.
std::string printable(std::string_view text, std::size_t most = 1500);

/// An error as it is shown: place, pointer and message are cut separately, so that line and column always
/// stay.
std::string printable(const Error& error);

/// Whether it is a letter, digit, dot, dash or underscore, which shells, file systems and queues never need
/// to quote.
bool is_plain(char c);

inline constexpr std::size_t kLongestName = 100;  ///< bytes, so that files whose names have it are possible

/// A name of letters, digits, - and _ alone; `otherwise` where nothing is left of it. Of one that is longer
/// than kLongestName, the beginning and a hash.
std::string plain_name(const std::string& name, std::string_view otherwise);

/// A text escaped for XML, between tags or in quotes; control characters, which XML cannot contain, become
/// blanks.
std::string xml_quoted(std::string_view text);

}  // namespace frond
