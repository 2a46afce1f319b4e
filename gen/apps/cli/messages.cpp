#include "cli/messages.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "cli/streams.h"
#include "core/figures.h"
#include "core/machine.h"
#include "core/printable.h"

namespace frond {

namespace {

constexpr std::size_t kMostPrinted = 100;  // errors or notes that are told one by one

void print(const Errors& errors, std::string_view before) {
  for (std::size_t i = 0; i < std::min(errors.size(), kMostPrinted); ++i)
    put_words(fmt::format("{}{}\n", before, printable(errors[i])));
  if (errors.size() > kMostPrinted)
    put_words(fmt::format("{}and {} more\n", before, errors.size() - kMostPrinted));
}

}  // namespace

void tell(std::string_view line) { put_words(printable(line) + "\n"); }

void tell_notes(const Errors& notes) { print(notes, "note: "); }

void tell_errors(const Errors& errors) { print(errors, ""); }

void tell_failure(const Errors& errors) {
  // A colour is for a terminal, and only where nobody asked for none.
  const char *none = std::getenv("NO_COLOR"), *term = std::getenv("TERM");
  bool color = ::isatty(2) && !(none && *none) && term && std::string_view(term) != "dumb";
  for (std::size_t i = 0; i < errors.size(); ++i) {
    if (i + 1 == errors.size()) put_words(color ? "\x1b[31merror:\x1b[0m " : "error: ");
    std::string text = errors[i].text();
    for (std::size_t from = 0; from <= text.size();) {
      std::size_t to = std::min(text.find('\n', from), text.size());
      tell(std::string_view(text).substr(from, to - from));
      from = to + 1;
    }
  }
}

void fail(const Errors& errors, ExitCode code) {
  tell_errors(errors);
  throw CommandEnd{code};
}

void fail_run(const Errors& errors, ExitCode code) {
  tell_failure(errors);
  throw CommandEnd{code};
}

void or_fail(const Errors& errors, ExitCode code) {
  if (!errors.empty()) fail(errors, code);
}

void or_fail_run(const Errors& errors, ExitCode code) {
  if (!errors.empty()) fail_run(errors, code);
}

int fail_for_memory() {
  Machine machine = this_machine(".");
  tell(fmt::format(
      "frond: memory ran out while {}: this process holds {} and may take {} more; fewer, smaller "
      "or less finely drawn organisms need less, and so do fewer --threads",
      what_is_done(), bytes_text(memory_in_use()), bytes_text(machine.memory)));
  return kCouldNot;
}

}  // namespace frond
