#pragma once

#include <mutex>
#include <string>

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

}  // namespace frond
