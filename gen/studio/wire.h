#pragma once

#include <httplib.h>

#include <chrono>
#include <string>

namespace frond {

/// A connection as httplib reads and writes it, on a socket that does not block. What has been read of it
/// already comes first.
class Wire final : public httplib::Stream {
 public:
  /// Nothing is waited for longer than `patience` at a time, nor past `end`.
  Wire(int socket, std::string come, std::chrono::milliseconds patience,
       std::chrono::steady_clock::time_point end)
      : socket_(socket), come_(std::move(come)), patience_(patience), end_(end) {}

  bool is_readable() const override { return taken_ < come_.size() || ready(true); }
  bool is_writable() const override { return ready(false); }
  ssize_t read(char* to, size_t size) override;
  ssize_t write(const char* from, size_t size) override;
  void get_remote_ip_and_port(std::string& ip, int& port) const override { ip = "127.0.0.1", port = 0; }
  void get_local_ip_and_port(std::string& ip, int& port) const override { ip = "127.0.0.1", port = 0; }
  socket_t socket() const override { return socket_; }

  /// What came and was not asked for: the beginning of a next request.
  std::string rest() const { return come_.substr(taken_); }

 private:
  bool ready(bool to_read) const;

  int socket_;
  std::string come_;
  std::size_t taken_ = 0;
  std::chrono::milliseconds patience_;
  std::chrono::steady_clock::time_point end_;
};

}  // namespace frond
