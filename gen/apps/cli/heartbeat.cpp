#include "cli/heartbeat.h"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>

#include "cli/streams.h"

namespace frond {

namespace {

constexpr std::chrono::milliseconds kLook{250};
constexpr double kSilence = 1.75;  // seconds, and up to a look more

}  // namespace

Heartbeat::Heartbeat(bool quiet) {
  if (!quiet) thread_ = std::thread([this] { beat(); });
}

Heartbeat::~Heartbeat() {
  if (!thread_.joinable()) return;
  {
    std::lock_guard lock(mutex_);
    ended_ = true;
  }
  over_.notify_all();
  thread_.join();
}

void Heartbeat::beat() {
  using Clock = std::chrono::steady_clock;
  auto since = [](Clock::time_point t) { return std::chrono::duration<double>(Clock::now() - t).count(); };
  const char* doing = what_is_done();
  std::size_t told = words_told();
  Clock::time_point began = Clock::now(), last = began;
  double wait = kSilence;
  for (std::unique_lock lock(mutex_); !over_.wait_for(lock, kLook, [&] { return ended_; });) {
    if (what_is_done() != doing) {
      doing = what_is_done(), told = words_told();
      began = last = Clock::now(), wait = kSilence;
    } else if (words_told() != told) {
      told = words_told(), last = Clock::now();
    } else if (since(last) >= wait) {
      put_words(fmt::format("{}still {} ({:.0f} s)\n", ::isatty(2) ? "\r" : "", doing, since(began)));
      told = words_told(), last = Clock::now(), wait *= 2;
    }
  }
}

}  // namespace frond
