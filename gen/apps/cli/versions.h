#pragma once

#include <string>

namespace frond {

/// The versions of Frond, of the libraries that it was built with, and of the POV-Ray that renders, a line
/// each.
std::string versions();

}  // namespace frond
