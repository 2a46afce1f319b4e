#pragma once

#include <optional>

#include "cli/progress.h"
#include "pipeline/events.h"

namespace frond {

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
  std::optional<Progress> phase_;
  double said_at_, pause_ = 10;  // seconds
  int tenth_ = -1;
};

}  // namespace frond
