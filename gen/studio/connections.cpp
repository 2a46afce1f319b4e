#include "studio/connections.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/eventfd.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "studio/wire.h"

namespace frond {

namespace {

constexpr int kBacklog = 256;                    // connections that the kernel holds
constexpr std::chrono::milliseconds kDeaf{100};  // where no file may be opened
constexpr std::chrono::seconds kLeaving{2};      // in which an answer is taken
constexpr std::size_t kMostUnknown = 256;        // requests that wait for a thread
constexpr std::string_view kEndOfHead = "\r\n\r\n";

bool same_letters(std::string_view a, std::string_view b) {
  return std::ranges::equal(
      a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r";
  std::size_t from = text.find_first_not_of(kBlanks);
  return from == text.npos ? "" : text.substr(from, text.find_last_not_of(kBlanks) + 1 - from);
}

/// An answer that ends the connection, from before there is a request.
void refuse(int socket, std::string_view status, std::string_view why) {
  std::string body = fmt::format(R"({{"error":"{}"}})", why);
  std::string text = fmt::format(
      "HTTP/1.1 {}\r\nContent-Type: application/json\r\nX-Content-Type-Options: nosniff\r\nContent-Length: "
      "{}\r\n"
      "Connection: close\r\n\r\n{}",
      status, body.size(), body);
  // It fits into what the kernel holds of a connection that nothing was sent on.
  (void)!::send(socket, text.data(), text.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
}

}  // namespace

std::pair<std::string_view, std::string_view> asked_for(std::string_view head) {
  std::string_view line = head.substr(0, head.find("\r\n"));
  std::size_t first = line.find(' '), second = line.find(' ', first + 1);
  if (first == line.npos || second == line.npos) return {};
  return {line.substr(0, first), line.substr(first + 1, second - first - 1)};
}

std::string_view header_of(std::string_view head, std::string_view name) {
  for (std::size_t at = head.find("\r\n"); at != head.npos;) {
    std::size_t from = at + 2;
    at = head.find("\r\n", from);
    std::string_view line = head.substr(from, at == head.npos ? at : at - from);
    std::size_t colon = line.find(':');
    if (colon != line.npos && same_letters(line.substr(0, colon), name))
      return trimmed(line.substr(colon + 1));
  }
  return {};
}

bool Connections::serve(int ends) {
  wake_ = ::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC);
  // httplib asks for a queue of five.
  if (wake_ < 0 || ::listen(svr_sock_, kBacklog) != 0 || ::fcntl(svr_sock_, F_SETFL, O_NONBLOCK) != 0)
    return false;
  for (int i = 0; i < limits.known; ++i) known_.threads.emplace_back([this] { work(known_); });
  for (int i = 0; i < limits.unknown; ++i) unknown_.threads.emplace_back([this] { work(unknown_); });
  for (;;) {
    std::vector<pollfd> files{{ends, POLLIN, 0}, {wake_, POLLIN, 0}};
    bool deaf = Clock::now() < deaf_until_;
    files.push_back({deaf ? -1 : static_cast<int>(svr_sock_), POLLIN, 0});
    std::vector<Waiting::iterator> each;
    for (auto i = waiting_.begin(); i != waiting_.end(); ++i) {
      files.push_back({i->socket, POLLIN, 0});
      each.push_back(i);
    }
    if (::poll(files.data(), files.size(), milliseconds_to_wait()) < 0 && errno != EINTR) break;
    if (files[0].revents != 0) break;
    for (std::size_t i = 0; i < each.size(); ++i)
      if (files[i + 3].revents != 0) look_after(each[i]);
    if (files[1].revents != 0) take_back();
    if (files[2].revents != 0) accept_all();
    close_late();
  }
  {
    std::lock_guard lock(in_work_);
    ending_ = true;
  }
  if (leaves) leaves();
  for (Crew* crew : {&known_, &unknown_}) {
    crew->some.notify_all();
    for (std::thread& thread : crew->threads) thread.join();
    for (Connection& connection : crew->waiting) ::close(connection.socket);
  }
  for (Connection& connection : served_) ::close(connection.socket);
  for (Connection& connection : waiting_) ::close(connection.socket);
  ::close(wake_);
  ::close(svr_sock_);
  return true;
}

void Connections::accept_all() {
  for (;;) {
    int socket = ::accept4(svr_sock_, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
    if (socket < 0 && (errno == EINTR || errno == ECONNABORTED)) continue;
    if (socket < 0) {
      if (errno != EAGAIN && errno != EWOULDBLOCK) deaf_until_ = Clock::now() + kDeaf;
      return;
    }
    int yes = 1;
    ::setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
    waiting_.push_back({.socket = socket, .until = Clock::now() + limits.first});
    make_room();
  }
}

/// Closes the oldest where too many wait: those who were never known first.
void Connections::make_room() {
  if (waiting_.size() <= limits.open) return;
  auto oldest = std::ranges::find(waiting_, false, &Connection::known);
  // The newest may be the only one.
  if (oldest == std::prev(waiting_.end())) oldest = waiting_.begin();
  ::close(oldest->socket);
  waiting_.erase(oldest);
}

void Connections::take_back() {
  std::uint64_t count = 0;
  (void)!::read(wake_, &count, sizeof count);
  std::vector<Connection> back;
  {
    std::lock_guard lock(in_work_);
    back.swap(served_);
  }
  for (Connection& connection : back) {
    connection.until = Clock::now() + (connection.leaving ? kLeaving
                                       : connection.known ? limits.idle
                                                          : limits.first);
    // A next request may have come with the last one.
    if (!connection.leaving && hand_over(connection)) continue;
    waiting_.push_back(std::move(connection));
    make_room();
  }
}

/// Where something has come on a connection that waits, or it has ended.
void Connections::look_after(Waiting::iterator connection) {
  if (!hear(*connection))
    ::close(connection->socket);
  else if (connection->leaving || !hand_over(*connection))
    return;
  waiting_.erase(connection);
}

/// Reads a part of what has come; false where there is nothing more to come.
bool Connections::hear(Connection& connection) {
  std::array<char, 16384> part;
  ssize_t count = ::recv(connection.socket, part.data(), part.size(), 0);
  if (count < 0) return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR;
  if (count == 0) return false;
  if (connection.leaving) return true;
  if (connection.come.empty()) connection.until = std::min(connection.until, Clock::now() + limits.first);
  connection.come.append(part.data(), static_cast<std::size_t>(count));
  return true;
}

/// Gives a connection whose head has come to those who serve it; false where it has to wait on.
bool Connections::hand_over(Connection& connection) {
  std::size_t end = connection.come.find(kEndOfHead);
  auto leave = [&](std::string_view status, std::string_view why) {
    refuse(connection.socket, status, why);
    ::shutdown(connection.socket, SHUT_WR);
    connection.leaving = true, connection.come = {}, connection.until = Clock::now() + kLeaving;
    return false;
  };
  if (std::min(end, connection.come.size()) > limits.head)
    return leave("431 Request Header Fields Too Large", "the head of the request is too long");
  if (end == connection.come.npos) return false;
  Caller who = caller(std::string_view(connection.come).substr(0, end));
  if (who == Caller::refused) return leave("403 Forbidden", kNoToken);
  connection.known = who == Caller::known;
  Crew& crew = connection.known ? known_ : unknown_;
  std::lock_guard lock(in_work_);
  if (!connection.known && crew.waiting.size() >= kMostUnknown)
    return leave("503 Service Unavailable", "too many ask");
  crew.waiting.push_back(std::move(connection));
  crew.some.notify_one();
  return true;
}

void Connections::work(Crew& crew) {
  for (;;) {
    Connection next;
    {
      std::unique_lock lock(in_work_);
      crew.some.wait(lock, [&] { return ending_ || !crew.waiting.empty(); });
      if (ending_) return;
      next = std::move(crew.waiting.front());
      crew.waiting.pop_front();
    }
    answer(std::move(next));
  }
}

void Connections::answer(Connection connection) {
  Clock::time_point end = connection.known ? Clock::time_point::max() : Clock::now() + limits.served;
  Wire wire(connection.socket, std::move(connection.come), limits.patience, end);
  bool closed = false, refused = false;
  bool fine = process_request(wire, false, closed, [&](httplib::Request& request) {
    if (!(refused = refuses(request))) return;
    // So that the answer says that it is the last.
    request.headers.erase("Connection");
    request.set_header("Connection", "close");
  });
  connection.leaving = !fine || closed || refused;
  connection.come = connection.leaving ? std::string() : wire.rest();
  if (connection.leaving) ::shutdown(connection.socket, SHUT_WR);
  {
    std::lock_guard lock(in_work_);
    served_.push_back(std::move(connection));
  }
  std::uint64_t one = 1;
  (void)!::write(wake_, &one, sizeof one);
}

/// Until the next thing that comes by itself; -1: nothing does.
int Connections::milliseconds_to_wait() const {
  Clock::time_point now = Clock::now(), next = Clock::time_point::max();
  for (const Connection& connection : waiting_) next = std::min(next, connection.until);
  if (now < deaf_until_) next = std::min(next, deaf_until_);
  if (next == Clock::time_point::max()) return -1;
  auto left = std::chrono::ceil<std::chrono::milliseconds>(next - now).count();
  return static_cast<int>(std::clamp<decltype(left)>(left, 0, 600'000));
}

void Connections::close_late() {
  Clock::time_point now = Clock::now();
  std::erase_if(waiting_, [&](const Connection& connection) {
    if (now < connection.until) return false;
    ::close(connection.socket);
    return true;
  });
}

}  // namespace frond
