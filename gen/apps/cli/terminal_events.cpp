#include "cli/terminal_events.h"

#include <fmt/format.h>
#include <unistd.h>

#include "cli/bar.h"
#include "cli/streams.h"
#include "pipeline/render_run.h"

namespace frond {

namespace {

constexpr double kSilence = 2;  // seconds

}  // namespace

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

TerminalEvents::TerminalEvents(bool quiet) : quiet_(quiet), said_at_(seconds_now()), pause_(kSilence) {}

void TerminalEvents::doing(const char* what) {
  now_doing(what);
  if (!heartbeat_) heartbeat_.emplace(quiet_);
}

void TerminalEvents::note(std::string_view line) { say(line); }

void TerminalEvents::report(std::string_view line) {
  heartbeat_.reset();
  said_at_ = seconds_now();
  pause_ = kSilence;
  if (!quiet_) say(line);
}

void TerminalEvents::begin(std::string_view phase, std::size_t steps) {
  phase_.emplace(std::string(phase), static_cast<int>(steps), quiet_);
}

void TerminalEvents::step() { phase_->step(); }

void TerminalEvents::end() { phase_.reset(); }

void TerminalEvents::rendered(const RenderedSoFar& frames) {
  heartbeat_.reset();
  constexpr int kFew = 200;
  constexpr double kSeldom = 5, kLongest = 60;  // seconds
  if (on_terminal()) {
    if (frames.whole)
      draw_bar(frames.done, frames.all, frames.words);
    else
      draw_bar(frames.percent, 100, frames.words);
    return;
  }
  double now = seconds_now();
  if (frames.whole) {
    if (!frames.last && frames.wanted > kFew && now < said_at_ + kSeldom) return;
  } else {
    bool tenth = frames.wanted == 1 && frames.percent < 100 && frames.percent / 10 > tenth_;
    if (!tenth && now < said_at_ + pause_) return;
    tenth_ = frames.percent / 10;
    if (pause_ < kLongest) pause_ *= 2;
  }
  said_at_ = now;
  say(frames.words);
}

}  // namespace frond
