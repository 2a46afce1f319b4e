#include "studio/wire.h"

#include <poll.h>

#include <algorithm>
#include <cstdint>

namespace frond {

bool Wire::ready(bool to_read) const {
  pollfd one{socket_, static_cast<short>(to_read ? POLLIN : POLLOUT), 0};
  Clock::time_point began = Clock::now(), end = std::min(patience_.end, began + patience_.longest);
  for (;;) {
    Clock::time_point now = Clock::now();
    if (now >= began + patience_.hurried && others_wait_()) return false;
    // So often it is looked whether others wait.
    auto left = std::chrono::ceil<std::chrono::milliseconds>(std::min(end, now + patience_.hurried) - now);
    int found = ::poll(&one, 1, static_cast<int>(std::max<std::int64_t>(left.count(), 0)));
    if (found > 0) return true;
    if ((found < 0 && errno != EINTR) || Clock::now() >= end) return false;
  }
}

ssize_t Wire::read(char* to, size_t size) {
  if (taken_ < come_.size()) {
    std::size_t count = come_.copy(to, size, taken_);
    taken_ += count;
    return static_cast<ssize_t>(count);
  }
  for (;;) {
    ssize_t count = ::recv(socket_, to, size, 0);
    if (count >= 0) return count;
    if (errno == EINTR) continue;
    if ((errno != EAGAIN && errno != EWOULDBLOCK) || !ready(true)) return -1;
  }
}

ssize_t Wire::write(const char* from, size_t size) {
  for (;;) {
    ssize_t count = ::send(socket_, from, size, MSG_NOSIGNAL);
    written_ |= count > 0;
    if (count >= 0) return count;
    if (errno == EINTR) continue;
    if ((errno != EAGAIN && errno != EWOULDBLOCK) || !ready(false)) return -1;
  }
}

}  // namespace frond
