#pragma once

#include <string_view>

#include "cli/commands.h"
#include "core/result.h"

namespace frond {

// All that the program says to people goes through here, so that nothing from a file or a command line steers
// the terminal, and nothing fills it.

/// Prints a line to stderr.
void tell(std::string_view line);

/// Prints notes to stderr, one a line.
void tell_notes(const Errors& notes);

/// Prints what a run could not do to stderr: the last is marked by "error: ", those before it say why. Each
/// may have several lines, as of another program. Returns the given exit code.
int fail_run(const Errors& errors, ExitCode code);

/// Prints errors to stderr, one a line; returns the given exit code.
int fail(const Errors& errors, ExitCode code);

/// Says what was being done as memory ran out, and what there is of it; returns kCouldNot.
int fail_for_memory();

}  // namespace frond
