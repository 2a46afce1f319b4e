#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "core/result.h"

namespace frond {

/// The text of a preset that moves from one folder to another, with the files that it names: they are copied
/// beside it, under a name of their own where theirs is taken, and the text names them there. Nothing else of
/// the text changes. Only what `readable` allows is copied.
Result<std::string> carried(const std::string& text, const std::filesystem::path& from,
                            const std::filesystem::path& to,
                            const std::function<bool(const std::filesystem::path&)>& readable);

}  // namespace frond
