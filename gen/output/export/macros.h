#pragma once

#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace frond {

/// Files of povinc: their names and texts.
using MacroFiles = std::vector<std::pair<std::string, std::string>>;

/// Which of the files a text needs, in an order in which each comes after those that it needs itself.
std::vector<std::size_t> macros_used(const MacroFiles& files, std::string_view text);

/// The macros of those files that a text calls by itself, as `Plant_Leaf(Color, Second, Shade)`.
std::set<std::string> macros_called(const MacroFiles& files, std::string_view text);

/// The pieces of those files that a text reaches by the names in it, and those that these reach, without
/// their comments: all of the files that can change what the text shows.
std::string macros_reached(const MacroFiles& files, std::string_view text);

/// Those files as one text that needs no other: each macro gives way to one of that name which is there
/// already.
std::string macros_text(const MacroFiles& files, const std::vector<std::size_t>& used);

}  // namespace frond
