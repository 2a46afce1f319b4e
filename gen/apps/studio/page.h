#pragma once

#include <span>
#include <string_view>

namespace frond {

/// A file of the page, as the program holds it.
struct PageFile {
  std::string_view path;  ///< "/index.html", "/assets/page-1a2b.js"
  std::string_view type;  ///< for Content-Type
  std::string_view bytes;
};

/// All of them; none where the page was not built (`scripts/setup.sh --studio` does it).
std::span<const PageFile> page_files();

}  // namespace frond
