#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"

namespace frond::cpfg {

/// Where a line stood before the preprocessor.
struct LinePlace {
  std::string file;
  int line = 1;

  std::string text() const;
};

/// A text as the C preprocessor leaves it. Each line ends by a newline and has its place.
struct PlainText {
  std::string text;
  std::vector<LinePlace> places;

  /// Where the byte at that offset came from.
  std::string where(std::size_t offset) const;
};

/// A name that is defined before the first line, with its text.
struct Predefined {
  std::string name, text;
};

/// Gives the text of an included file, or says why not.
using IncludeReader = std::function<Result<std::string>(const std::string& name)>;

/// What the GNU preprocessor of the 1990s makes of a text: macros of both forms with any text as their body,
/// lines joined by `\`, conditions, included files, comments of both kinds (`/* */` becomes a blank). A run
/// of letters, digits and `_` is one name. A line that begins with `#` but names no directive stays. Texts of
/// more than 8 MB, macros that become more, includes deeper than 20 and more than 2,000 of them are refused.
Result<PlainText> preprocess(const std::string& file, std::string_view text,
                             const std::vector<Predefined>& names, const IncludeReader& include);

/// The value of the formula of an `#if`: whole numbers, names (which are 0), and C's operators but `?:` and
/// those on bits. Nothing where it is none.
std::optional<long long> constant_value(std::string_view text);

}  // namespace frond::cpfg
