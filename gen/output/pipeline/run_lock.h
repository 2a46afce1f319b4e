#pragma once

#include <filesystem>

#include "core/result.h"
#include "pipeline/events.h"

namespace frond {

/// Holds the folder of a run as long as it lives; other runs wait. What this process starts holds it, too, so
/// that a run whose parent was killed is over before the next begins.
class RunLock {
 public:
  /// Makes the folder where it is not there, and waits for its turn.
  RunLock(const std::filesystem::path& out, RunEvents& events);
  ~RunLock();
  RunLock(const RunLock&) = delete;
  RunLock& operator=(const RunLock&) = delete;

  const Errors& errors() const { return errors_; }

 private:
  int file_ = -1;
  Errors errors_;
};

}  // namespace frond
