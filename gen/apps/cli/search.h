#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace frond {

/// Where something is found besides properties.
struct Finding {
  std::string where;  ///< a path seen from the folder of Frond
  std::string says;   ///< the preset's title, or the words that say it
  int rank = 0;
};

/// The presets and grammars of a folder of Frond that say all words by their names, titles, organisms or
/// comments, the best first.
std::vector<Finding> presets_about(const std::filesystem::path& home, const std::vector<std::string>& words);

/// The pages of docs/ that say all words in a heading or in a line, the best first; one finding a page.
std::vector<Finding> pages_about(const std::filesystem::path& home, const std::vector<std::string>& words);

}  // namespace frond
