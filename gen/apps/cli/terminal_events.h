#pragma once

#include <mutex>
#include <optional>
#include <string>

#include "cli/heartbeat.h"
#include "pipeline/events.h"

namespace frond {

/// Tells on stderr how far a stage of the work is: one line that renews itself on a terminal, a line for each
/// tenth elsewhere, nothing where quiet. Safe to call from several threads.
class Progress {
 public:
  Progress(std::string stage, int total, bool quiet);
  ~Progress();

  /// One more is done.
  void step();

 private:
  std::string stage_;
  int total_, done_ = 0;
  bool quiet_, terminal_;
  std::mutex mutex_;
};

/// Tells on stderr how far a run is: a bar on a terminal, lines from time to time elsewhere.
class TerminalEvents : public RunEvents {
 public:
  /// Quiet, it tells only what wants attention.
  explicit TerminalEvents(bool quiet = false);

  void doing(const char* what) override;
  void note(std::string_view line) override;
  void report(std::string_view line) override;
  void begin(std::string_view phase, std::size_t steps) override;
  void step() override;
  void end() override;
  void rendered(const RenderedSoFar& frames) override;

 private:
  bool quiet_;
  std::optional<Heartbeat> heartbeat_;  // while something may take its time of which nothing else is told
  std::optional<Progress> phase_;
  double said_at_, pause_;  // seconds
  int tenth_ = -1;
};

}  // namespace frond
