#pragma once

#include <string>

namespace frond {

/// That of Frond: "1.2.3".
std::string version();

}  // namespace frond
