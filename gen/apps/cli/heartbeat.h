#pragma once

#include <condition_variable>
#include <mutex>
#include <thread>

namespace frond {

/// While it lives: where nothing has been told on stderr for two seconds it says what the program is at, and
/// for how long; again after twice as long each time. Quiet, it says nothing.
class Heartbeat {
 public:
  explicit Heartbeat(bool quiet = false);
  ~Heartbeat();

 private:
  void beat();

  std::mutex mutex_;
  std::condition_variable over_;
  bool ended_ = false;
  std::thread thread_;
};

}  // namespace frond
