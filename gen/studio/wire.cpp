#include "studio/wire.h"

#include <poll.h>

namespace frond {

using Clock = std::chrono::steady_clock;

bool Wire::ready(bool to_read) const {
  pollfd one{socket_, static_cast<short>(to_read ? POLLIN : POLLOUT), 0};
  Clock::time_point end = std::min(end_, Clock::now() + patience_);
  for (;;) {
    auto left = std::chrono::ceil<std::chrono::milliseconds>(end - Clock::now()).count();
    int found = ::poll(&one, 1, static_cast<int>(std::max<decltype(left)>(left, 0)));
    if (found >= 0 || errno != EINTR) return found > 0;
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
    if (count >= 0) return count;
    if (errno == EINTR) continue;
    if ((errno != EAGAIN && errno != EWOULDBLOCK) || !ready(false)) return -1;
  }
}

}  // namespace frond
