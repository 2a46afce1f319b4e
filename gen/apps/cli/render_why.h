#pragma once

#include <filesystem>
#include <string>

#include "render/ninja.h"

namespace frond {

/// Says why the next run in a folder would render a frame, or that it would not; `before` is the text that
/// its scene had, or empty: then the first line that has changed is shown.
void tell_why(const Ninja& ninja, const std::filesystem::path& out, int frame, const std::string& before);

}  // namespace frond
