#pragma once

#include <CLI/CLI.hpp>

namespace frond {

/// Adds the command `try`, which opens the page to try grammars, trees and corals on.
void add_try(CLI::App& app, int& result);

}  // namespace frond
