#include "app/messages.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/streams.h"
#include "core/printable.h"

namespace frond {

namespace {

constexpr std::size_t kMost = 100;  // errors or notes that are told one by one

void print(const Errors& errors, std::string_view before) {
  for (std::size_t i = 0; i < std::min(errors.size(), kMost); ++i)
    put_words(fmt::format("{}{}\n", before, printable(errors[i])));
  if (errors.size() > kMost) put_words(fmt::format("{}and {} more\n", before, errors.size() - kMost));
}

}  // namespace

void tell(std::string_view line) { put_words(printable(line) + "\n"); }

void tell_notes(const Errors& notes) { print(notes, "note: "); }

int fail(const Errors& errors, ExitCode code) {
  print(errors, "");
  return code;
}

}  // namespace frond
