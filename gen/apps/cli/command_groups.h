#pragma once

#include <CLI/CLI.hpp>

namespace frond {

/// Lists the commands in the program's help in the order and under the headings in which people work.
/// Commands that only scripts and other programs call are not listed; they keep their names and their own
/// help.
void group_commands(CLI::App& app);

}  // namespace frond
