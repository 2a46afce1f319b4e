#pragma once

#include <httplib.h>

#include <chrono>
#include <functional>
#include <string>

namespace frond {

/// A connection as httplib reads and writes it, on a socket that does not block. What has been read of it
/// already comes first.
class Wire final : public httplib::Stream {
 public:
  using Clock = std::chrono::steady_clock;
  /// How long it is waited for the other side.
  struct Patience {
    std::chrono::milliseconds longest, hurried;  ///< at a time; and where others wait for this thread
    Clock::time_point end;                       ///< and never past it
  };

  Wire(int socket, std::string come, Patience patience, std::function<bool()> others_wait)
      : socket_(socket), come_(std::move(come)), patience_(patience), others_wait_(std::move(others_wait)) {}

  bool is_readable() const override { return taken_ < come_.size() || ready(true); }
  bool is_writable() const override { return ready(false); }
  ssize_t read(char* to, size_t size) override;
  ssize_t write(const char* from, size_t size) override;
  void get_remote_ip_and_port(std::string& ip, int& port) const override { ip = "127.0.0.1", port = 0; }
  void get_local_ip_and_port(std::string& ip, int& port) const override { ip = "127.0.0.1", port = 0; }
  socket_t socket() const override { return socket_; }

  /// What came and was not asked for: the beginning of a next request.
  std::string rest() const { return come_.substr(taken_); }
  /// Whether any of an answer has been sent.
  bool has_written() const { return written_; }

 private:
  bool ready(bool to_read) const;

  int socket_;
  std::string come_;
  std::size_t taken_ = 0;
  Patience patience_;
  std::function<bool()> others_wait_;
  bool written_ = false;
};

}  // namespace frond
