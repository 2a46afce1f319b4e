#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/result.h"

namespace frond {

/// The whole of a file.
Result<std::string> read_file(const std::filesystem::path& path);

/// Writes a file so that it is seen whole or not at all (a temporary beside it, then a rename), making the
/// folders above it. A file that already holds just this text is left alone with its time stamp. True where
/// the file was written.
Result<bool> write_file(const std::filesystem::path& path, std::string_view text);

}  // namespace frond
