#include "studio/connections.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/eventfd.h>

#include <algorithm>
#include <cctype>
#include <exception>
#include <system_error>

#include "studio/answers.h"
#include "studio/wire.h"

namespace frond {

namespace {

constexpr int kBacklog = 256;                    // connections that the kernel holds
constexpr std::chrono::milliseconds kDeaf{100};  // where no file may be opened
constexpr std::chrono::seconds kLeaving{2};      // in which an answer is taken
constexpr std::size_t kMostUnknown = 256;        // requests that wait for a thread
constexpr std::size_t kPart = 256 << 10;         // bytes that are read at a time
constexpr std::string_view kEndOfHead = "\r\n\r\n";
constexpr std::string_view kGoOn = "HTTP/1.1 100 Continue\r\n\r\n";

bool same_letters(std::string_view a, std::string_view b) {
  return std::ranges::equal(
      a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r";
  std::size_t from = text.find_first_not_of(kBlanks);
  return from == text.npos ? "" : text.substr(from, text.find_last_not_of(kBlanks) + 1 - from);
}

/// What a head asks for, as far as it has to be known before its body comes.
httplib::Request request_of(std::string_view head) {
  httplib::Request request;
  auto [method, target] = asked_for(head);
  request.method = method, request.target = target;
  request.path = httplib::detail::decode_url(std::string(target.substr(0, target.find('?'))), false);
  for (std::size_t at = head.find("\r\n"); at != head.npos;) {
    std::size_t from = at + 2;
    at = head.find("\r\n", from);
    std::string_view line = head.substr(from, at == head.npos ? at : at - from);
    if (std::size_t colon = line.find(':'); colon != line.npos)
      request.headers.emplace(line.substr(0, colon), trimmed(line.substr(colon + 1)));
  }
  return request;
}

/// An answer that ends the connection, from before there is a request.
void refuse(int socket, std::string_view status, std::string_view why) {
  std::string body = fmt::format(R"({{"error":"{}"}})", why);
  std::string text = fmt::format(
      "HTTP/1.1 {}\r\nContent-Type: application/json\r\nX-Content-Type-Options: nosniff\r\nContent-Length: "
      "{}\r\nConnection: close\r\n\r\n{}",
      status, body.size(), body);
  // The answer fits into what the kernel holds of a connection that nothing was sent on.
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
  part_.resize(kPart);
  try {
    for (auto [crew, count] : {std::pair(&known_, limits.known), {&unknown_, limits.unknown}})
      for (int i = 0; i < count; ++i) crew->threads.emplace_back([this, crew = crew] { work(*crew); });
  } catch (const std::system_error&) {
    // The system gives no more threads: those that there are do it.
    asked_to_end_ = known_.threads.empty();
  }
  while (!asked_to_end_) try {
      turn(ends);
    } catch (const std::exception&) {  // no memory for what came
      close_longest();
    }
  {
    std::lock_guard lock(mutex_);
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

/// Waits until something comes, and looks after that.
void Connections::turn(int ends) {
  bool deaf = Clock::now() < deaf_until_;
  std::vector<pollfd> files{
      {ends, POLLIN, 0}, {wake_, POLLIN, 0}, {deaf ? -1 : static_cast<int>(svr_sock_), POLLIN, 0}};
  std::vector<Waiting::iterator> each;
  for (auto i = waiting_.begin(); i != waiting_.end(); ++i) {
    files.push_back({i->socket, POLLIN, 0});
    each.push_back(i);
  }
  bool failed = ::poll(files.data(), files.size(), milliseconds_to_wait()) < 0 && errno != EINTR;
  if (failed || files[0].revents != 0) {
    asked_to_end_ = true;
    return;
  }
  for (std::size_t i = 0; i < each.size(); ++i)
    if (files[i + 3].revents != 0) look_after(each[i]);
  hold_less();
  if (files[1].revents != 0) resume();
  if (files[2].revents != 0) accept_all();
  close_late();
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

void Connections::resume() {
  std::uint64_t count = 0;
  (void)!::read(wake_, &count, sizeof count);
  std::vector<Connection> back;
  {
    std::lock_guard lock(mutex_);
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
  ssize_t count = ::recv(connection.socket, part_.data(), part_.size(), 0);
  if (count < 0) return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR;
  if (count == 0) return false;
  if (connection.leaving) return true;
  if (connection.come.empty()) connection.until = std::min(connection.until, Clock::now() + limits.first);
  connection.come.append(part_.data(), static_cast<std::size_t>(count));
  if (connection.whole > 0 && connection.known) connection.until = Clock::now() + limits.patience;
  return true;
}

/// Answers a connection for good, without a request.
void Connections::leave(Connection& connection, std::string_view status, std::string_view why) {
  refuse(connection.socket, status, why);
  ::shutdown(connection.socket, SHUT_WR);
  connection.leaving = true, connection.come = {}, connection.until = Clock::now() + kLeaving;
}

/// The longest of the requests that wait for their ends.
Connections::Waiting::iterator Connections::longest() {
  return std::ranges::max_element(waiting_, {},
                                  [](const Connection& connection) { return connection.come.size(); });
}

/// Refuses the longest requests, until those that wait for their ends hold no more than they may.
void Connections::hold_less() {
  std::size_t held = 0;
  for (const Connection& connection : waiting_) held += connection.come.size();
  while (held > limits.held) {
    auto largest = longest();
    held -= largest->come.size();
    leave(*largest, "503 Service Unavailable", "there is no room for so much that is sent at once");
  }
}

/// Where there is no memory even to wait.
void Connections::close_longest() {
  if (auto largest = longest(); largest != waiting_.end()) {
    ::close(largest->socket);
    waiting_.erase(largest);
  }
  std::this_thread::sleep_for(kDeaf);
}

/// Judges a request by its head; false where its connection is left.
bool Connections::read_head(Connection& connection, std::size_t end) {
  std::string_view head = std::string_view(connection.come).substr(0, end);
  Caller who = caller(head);
  if (who == Caller::refused) return leave(connection, "403 Forbidden", kNoToken), false;
  connection.known = who == Caller::known;
  connection.whole = end + kEndOfHead.size();
  httplib::Request request = request_of(head);
  if (refuses(request)) return true;  // what follows is not wanted
  connection.whole += request.get_header_value<std::uint64_t>("Content-Length");
  if (connection.known) connection.until = Clock::now() + limits.patience;
  if (connection.come.size() < connection.whole && same_letters(header_of(head, "Expect"), "100-continue"))
    (void)!::send(connection.socket, kGoOn.data(), kGoOn.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
  return true;
}

/// Gives a connection whose request has come to those who serve it; false where it has to wait on.
bool Connections::hand_over(Connection& connection) {
  if (connection.whole == 0) {
    std::size_t end = connection.come.find(kEndOfHead);
    if (std::min(end, connection.come.size()) > limits.head)
      return leave(connection, "431 Request Header Fields Too Large", "the head of the request is too long"),
             false;
    if (end == connection.come.npos || !read_head(connection, end)) return false;
  }
  if (connection.come.size() < connection.whole) return false;
  Crew& crew = connection.known ? known_ : unknown_;
  std::lock_guard lock(mutex_);
  if (!connection.known && crew.waiting.size() >= kMostUnknown)
    return leave(connection, "503 Service Unavailable", "too many ask"), false;
  crew.waiting.push_back(std::move(connection));
  crew.some.notify_one();
  return true;
}

void Connections::work(Crew& crew) {
  for (;;) {
    Connection next;
    {
      std::unique_lock lock(mutex_);
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
  auto others_wait = [this, &crew = connection.known ? known_ : unknown_] {
    std::lock_guard lock(mutex_);
    return !crew.waiting.empty();
  };
  Wire wire(connection.socket, std::move(connection.come), {limits.patience, limits.hurried, end},
            others_wait);
  bool fine = false, closed = false, refused = false;
  try {
    fine = process_request(wire, false, closed, [&](httplib::Request& request) {
      if (!(refused = refuses(request))) return;
      // So that the answer says that it is the last.
      request.headers.erase("Connection");
      request.set_header("Connection", "close");
    });
    connection.come = wire.rest();
  } catch (...) {
    fine = false;
    if (!wire.has_written())
      refuse(connection.socket, "500 Internal Server Error", reason_of(std::current_exception()));
  }
  connection.leaving = !fine || closed || refused, connection.whole = 0;
  if (connection.leaving) connection.come = {}, ::shutdown(connection.socket, SHUT_WR);
  give_back(std::move(connection));
}

/// Lets a connection that was served wait for its next request.
void Connections::give_back(Connection connection) {
  int socket = connection.socket;
  try {
    std::lock_guard lock(mutex_);
    served_.push_back(std::move(connection));
  } catch (const std::exception&) {
    ::close(socket);
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
