#pragma once

#include <httplib.h>

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <list>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

namespace frond {

inline constexpr const char* kNoToken =
    "the token is missing or wrong: open the address that `frond studio` printed";

/// Who asks, as the head of a request tells.
enum class Caller {
  known,    ///< bears the token
  unknown,  ///< asks for what is given to everybody, in its turn
  refused   ///< asks for what it may not
};

/// The value of a header in the head of a request, without the blanks round it; empty where there is none.
std::string_view header_of(std::string_view head, std::string_view name);
/// The method of a request and what it asks for: "GET" and "/api/ping?token=ab".
std::pair<std::string_view, std::string_view> asked_for(std::string_view head);

/// A web server that gives a connection a thread only when a whole request has come, with its body. Before
/// that connections wait in one place, so many of them, each for so long, and with so many bytes, so that
/// nobody can keep others out by asking slowly. Who takes an answer slowly keeps a thread only while no other
/// needs it. Those who bear no token share a few threads of their own. Whatever goes wrong in an answer, as
/// where memory runs out, ends that connection alone.
class Connections : public httplib::Server {
 public:
  struct Limits {
    std::size_t open = 256;          ///< that wait; where there are more the oldest goes, the known last
    std::size_t head = 32 << 10;     ///< bytes
    std::size_t held = 128 << 20;    ///< bytes of requests that wait for their ends, of all connections
    std::chrono::seconds first{10};  ///< in which a head has to come, from the connection or its first byte
    std::chrono::seconds idle{300};  ///< until the next request of one that is known
    std::chrono::seconds patience{30};  ///< that the known may rest while they send or take
    std::chrono::seconds hurried{2};    ///< that they may rest while they take where others wait for a thread
    std::chrono::seconds served{5};     ///< in which the unknown have to take what they get
    int known = 24, unknown = 8;        ///< threads
  };

  /// Asked of each head before anything else is done.
  std::function<Caller(std::string_view head)> caller;
  /// Whether a request is refused by its head: the connection ends with the answer, and no body is read. The
  /// head may be all that is known of it yet.
  std::function<bool(const httplib::Request&)> refuses;
  /// Called once when serving ends, before what is being answered is waited for. May be empty.
  std::function<void()> leaves;
  Limits limits;

  /// Serves what was bound until `ends`, a file, can be read. False where it cannot.
  bool serve(int ends);

 private:
  using Clock = std::chrono::steady_clock;

  struct Connection {
    int socket = -1;
    bool known = false;
    bool leaving = false;       // answered for good; what still comes is read, so that the answer arrives
    Clock::time_point until{};  // when it is closed
    std::string come{};         // of the next request
    std::size_t whole = 0;      // bytes that it has with its body; 0: its head has not come yet
  };
  /// Threads that serve one sort of callers.
  struct Crew {
    std::deque<Connection> waiting;
    std::condition_variable some;
    std::vector<std::thread> threads;
  };
  using Waiting = std::list<Connection>;

  void turn(int ends);
  void accept_all();
  void resume();
  void make_room();
  void look_after(Waiting::iterator connection);
  bool hear(Connection& connection);
  bool hand_over(Connection& connection);
  bool read_head(Connection& connection, std::size_t end);
  void leave(Connection& connection, std::string_view status, std::string_view why);
  Waiting::iterator longest();
  void hold_less();
  void close_longest();
  void work(Crew& crew);
  void answer(Connection connection);
  void give_back(Connection connection);
  int milliseconds_to_wait() const;
  void close_late();

  Waiting waiting_;  // the oldest first; this and the next are for the thread of serve() alone
  Clock::time_point deaf_until_{};
  int wake_ = -1;  // can be read when there is something in served_
  bool asked_to_end_ = false;
  std::vector<char> part_;  // that is read at a time

  std::mutex mutex_;  // guards all below
  bool ending_ = false;
  Crew known_, unknown_;
  std::vector<Connection> served_;  // to wait again
};

}  // namespace frond
