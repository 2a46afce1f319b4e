#pragma once

#include <string>
#include <string_view>

namespace frond {

/// 16 hexadecimal digits that stand for a content (XXH3, Collet 2019): the same on every machine.
std::string content_id(std::string_view content);

/// The same for what this build of the code makes of a content. Another version of what grows and writes
/// gives another name, so what an older one has made is never taken for its own.
std::string made_id(std::string_view content);

}  // namespace frond
