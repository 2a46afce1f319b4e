#pragma once

#include <string>
#include <string_view>

namespace frond {

/// 32 hexadecimal digits that nobody can guess; empty where the system gives no random numbers.
std::string token();

/// Whether two texts are the same; it takes as long whether the first or the last character differs.
bool same(std::string_view a, std::string_view b);

}  // namespace frond
