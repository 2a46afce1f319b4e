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

/// Prints errors to stderr, one a line.
void tell_errors(const Errors& errors);

/// Prints what a run could not do to stderr: the last is marked by "error: ", those before it say why. Each
/// may have several lines, as of another program.
void tell_failure(const Errors& errors);

/// The end of a command before its time. What there is to say has been told.
struct CommandEnd {
  int code;  ///< the exit code
};

/// Tells errors and ends the command; fail_run() tells them as what a run could not do.
[[noreturn]] void fail(const Errors& errors, ExitCode code);
[[noreturn]] void fail_run(const Errors& errors, ExitCode code);

/// Each fails where there are errors, and gives the value where there is one.
void or_fail(const Errors& errors, ExitCode code);
void or_fail_run(const Errors& errors, ExitCode code);
template <class T>
T or_fail(Result<T> result, ExitCode code) {
  if (!result) fail(result.errors(), code);
  return std::move(*result);
}
template <class T>
T or_fail_run(Result<T> result, ExitCode code) {
  if (!result) fail_run(result.errors(), code);
  return std::move(*result);
}

/// Says what was being done as memory ran out, and what there is of it; returns kCouldNot.
int fail_for_memory();

}  // namespace frond
