#pragma once

#include <string>
#include <string_view>

namespace frond {

/// A hash of a content as 16 hexadecimal digits (XXH3, Collet 2019): the same on every machine.
std::string content_id(std::string_view content);

/// A hash, as 16 hexadecimal digits, of what this build of the code makes of a content. It changes with the
/// version of the code, so results of an older version are never reused by mistake.
std::string made_id(std::string_view content);

}  // namespace frond
