#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "core/result.h"

namespace frond {

/// The text of a preset of a folder with other names for the files that it names and that are there; a file
/// keeps its name where `name_of` gives an empty one. Nothing else of the text changes.
Result<std::string> renamed(const std::string& text, const std::filesystem::path& folder,
                            const std::function<Result<std::string>(const std::filesystem::path&)>& name_of);

/// The text with whole paths, so that it reads the same in any folder.
Result<std::string> with_whole_paths(const std::string& text, const std::filesystem::path& folder);

}  // namespace frond
