#pragma once

#include <filesystem>

namespace frond {

/// Asks the desktop to open a page, and does not wait for it. False where there is no xdg-open.
bool open_in_browser(const std::filesystem::path& page);

}  // namespace frond
