#pragma once

#include <CLI/CLI.hpp>

namespace frond {

/// `frond check`, which tells what is wrong in presets, and carries old ones over to today's form.
void add_check(CLI::App& app, int& result);

}  // namespace frond
