#include "cli/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include "cli/streams.h"

namespace frond {

Progress::Progress(std::string stage, int total, bool quiet)
    : stage_(std::move(stage)), total_(total), quiet_(quiet), terminal_(::isatty(2) != 0) {}

void Progress::step() {
  std::lock_guard lock(mutex_);
  int before = done_ * 10 / total_;
  ++done_;
  if (quiet_) return;
  if (terminal_) {
    put_words(fmt::format("\r{} {}/{}", stage_, done_, total_));
  } else if (done_ * 10 / total_ > before) {
    put_words(fmt::format("{} {}/{}\n", stage_, done_, total_));
  }
}

Progress::~Progress() {
  if (terminal_ && !quiet_ && done_ > 0) put_words("\n");
}

}  // namespace frond
