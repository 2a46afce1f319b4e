#include "studio/connections.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <new>
#include <thread>

namespace frond {
namespace {

/// A server whose pages are "/slow", which waits until it is let go, and "/quick".
class ConnectionsTest : public testing::Test {
 protected:
  void begin(const Connections::Limits& limits) {
    server_.limits = limits;
    server_.caller = [](std::string_view head) {
      if (asked_for(head).second == "/forbidden") return Caller::refused;
      return header_of(head, "X-Key") == "yes" ? Caller::known : Caller::unknown;
    };
    server_.refuses = [](const httplib::Request& request) { return request.has_header("Transfer-Encoding"); };
    server_.set_pre_routing_handler([](const httplib::Request& request, httplib::Response& response) {
      if (!request.has_header("Transfer-Encoding")) return httplib::Server::HandlerResponse::Unhandled;
      response.status = 411;
      return httplib::Server::HandlerResponse::Handled;
    });
    auto text = [](const char* said) {
      return [said](const httplib::Request&, httplib::Response& response) {
        response.set_content(said, "text/plain");
      };
    };
    server_.Get("/quick", text("quick"));
    server_.Post("/quick", text("posted"));
    server_.Get("/large", [](const httplib::Request&, httplib::Response& response) {
      response.set_content(std::string(64 << 20, 'x'), "text/plain");
    });
    server_.Get("/broken", [](const httplib::Request&, httplib::Response& response) {
      response.set_content_provider(
          100, "text/plain",
          [](std::size_t, std::size_t, httplib::DataSink&) -> bool { throw std::bad_alloc(); });
    });
    port_ = server_.bind_to_any_port("127.0.0.1");
    ASSERT_GT(port_, 0);
    ends_ = ::eventfd(0, EFD_CLOEXEC);
    thread_ = std::thread([this] { EXPECT_TRUE(server_.serve(ends_)); });
  }
  void TearDown() override {
    std::uint64_t one = 1;
    EXPECT_EQ(::write(ends_, &one, sizeof one), static_cast<ssize_t>(sizeof one));
    thread_.join();
    ::close(ends_);
    for (int socket : sockets_) ::close(socket);
  }

  int connect() {
    int socket = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in to{};
    to.sin_family = AF_INET, to.sin_port = htons(static_cast<std::uint16_t>(port_));
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(::connect(socket, reinterpret_cast<sockaddr*>(&to), sizeof to), 0);
    // Rather fail than wait for ever.
    timeval longest{60, 0};
    ::setsockopt(socket, SOL_SOCKET, SO_RCVTIMEO, &longest, sizeof longest);
    sockets_.push_back(socket);
    return socket;
  }
  static void say(int socket, std::string_view text) {
    (void)!::send(socket, text.data(), text.size(), MSG_NOSIGNAL);
  }
  /// What comes until the connection ends, or `until` is in it.
  static std::string heard(int socket, std::string_view until = "\n\n\n") {
    std::string all;
    char part[4096];
    for (ssize_t count; all.find(until) == all.npos && (count = ::recv(socket, part, sizeof part, 0)) > 0;)
      all.append(part, static_cast<std::size_t>(count));
    return all;
  }
  static std::string status_of(const std::string& answer) { return answer.substr(0, answer.find("\r\n")); }

  Connections server_;
  int port_ = 0, ends_ = -1;
  std::thread thread_;
  std::vector<int> sockets_;
};

constexpr const char* kQuick = "GET /quick HTTP/1.1\r\nX-Key: yes\r\n\r\n";

TEST_F(ConnectionsTest, ThoseWhoAskSlowlyKeepNobodyOut) {
  begin({.open = 64, .known = 1, .unknown = 1});
  for (int i = 0; i < 40; ++i) say(connect(), "GET /quick HT");
  int known = connect();
  say(known, kQuick);
  EXPECT_NE(heard(known, "quick").find("200 OK"), std::string::npos);
  int unknown = connect();
  say(unknown, "GET /quick HTTP/1.1\r\n\r\n");
  EXPECT_NE(heard(unknown, "quick").find("200 OK"), std::string::npos);
}

TEST_F(ConnectionsTest, MoreThanMayWaitCloseTheOldestButNotTheKnown) {
  begin({.open = 8, .known = 1, .unknown = 1});
  int known = connect();
  say(known, kQuick);
  EXPECT_NE(heard(known, "quick").find("200 OK"), std::string::npos);
  int first = connect();
  say(first, "GET");
  for (int i = 0; i < 12; ++i) say(connect(), "GET");
  EXPECT_EQ(heard(first), "") << "it was closed";
  say(known, kQuick);
  EXPECT_NE(heard(known, "quick").find("200 OK"), std::string::npos) << "it still waits";
}

TEST_F(ConnectionsTest, AHeadMustComeInTime) {
  begin({.first = std::chrono::seconds(0), .known = 1, .unknown = 1});
  int slow = connect();
  EXPECT_EQ(heard(slow), "");
}

TEST_F(ConnectionsTest, AHeadWithoutEndIsRefused) {
  begin({.head = 1000, .known = 1, .unknown = 1});
  int socket = connect();
  say(socket, "GET /quick HTTP/1.1\r\nX-Long: " + std::string(5000, 'x'));
  EXPECT_EQ(status_of(heard(socket)), "HTTP/1.1 431 Request Header Fields Too Large");
}

TEST_F(ConnectionsTest, WhoIsRefusedTakesNoThread) {
  begin({.known = 0, .unknown = 0});
  int socket = connect();
  say(socket, "POST /forbidden HTTP/1.1\r\nContent-Length: 100000\r\n\r\n" + std::string(50'000, 'x'));
  EXPECT_EQ(status_of(heard(socket)), "HTTP/1.1 403 Forbidden");
}

TEST_F(ConnectionsTest, ABodyWithoutALengthIsNotRead) {
  begin({.known = 1, .unknown = 1});
  int socket = connect();
  say(socket, "POST /quick HTTP/1.1\r\nX-Key: yes\r\nTransfer-Encoding: chunked\r\n\r\n");
  std::string answer = heard(socket);
  EXPECT_EQ(status_of(answer), "HTTP/1.1 411 Length Required");
}

TEST_F(ConnectionsTest, AConnectionServesManyRequestsAlsoAtOnce) {
  begin({.known = 2, .unknown = 1});
  int socket = connect();
  std::string post = "POST /quick HTTP/1.1\r\nX-Key: yes\r\nContent-Length: 3\r\n\r\nabc";
  say(socket, post + kQuick + post);
  std::string all = heard(socket, "quick");
  EXPECT_NE(all.find("posted"), std::string::npos) << all;
  EXPECT_NE(all.find("quick"), std::string::npos) << all;
  if (all.find("posted", all.find("quick")) == all.npos) all += heard(socket, "posted");
  // A body that comes in pieces.
  say(socket, post.substr(0, 30));
  say(socket, post.substr(30, post.size() - 32));
  say(socket, post.substr(post.size() - 2));
  EXPECT_NE(heard(socket, "posted").find("200 OK"), std::string::npos);
}

TEST_F(ConnectionsTest, UnfinishedBodiesKeepNobodyOut) {
  begin({.known = 1, .unknown = 1});
  std::string post = "POST /quick HTTP/1.1\r\nX-Key: yes\r\nContent-Length: 1000\r\n\r\nabc";
  std::vector<int> slow;
  for (int i = 0; i < 200; ++i) say(slow.emplace_back(connect()), post);
  int known = connect();
  say(known, kQuick);
  EXPECT_NE(heard(known, "quick").find("200 OK"), std::string::npos);
  say(slow[100], std::string(997, 'x'));
  EXPECT_NE(heard(slow[100], "posted").find("200 OK"), std::string::npos) << "it waited for its end";
}

TEST_F(ConnectionsTest, UnfinishedBodiesTakeNoMoreMemoryThanTheyMay) {
  begin({.held = 100'000, .known = 1, .unknown = 1});
  auto post = [](int length) {
    return "POST /quick HTTP/1.1\r\nX-Key: yes\r\nContent-Length: " + std::to_string(length) + "\r\n\r\n";
  };
  int large = connect(), small = connect();
  say(small, post(1000) + std::string(900, 'x'));
  say(large, post(200'000) + std::string(150'000, 'x'));
  EXPECT_EQ(status_of(heard(large)), "HTTP/1.1 503 Service Unavailable");
  say(small, std::string(100, 'x'));
  EXPECT_NE(heard(small, "posted").find("200 OK"), std::string::npos);
}

TEST_F(ConnectionsTest, WhoWaitsToBeToldToSendIsTold) {
  begin({.known = 1, .unknown = 1});
  int socket = connect();
  say(socket, "POST /quick HTTP/1.1\r\nX-Key: yes\r\nExpect: 100-continue\r\nContent-Length: 3\r\n\r\n");
  EXPECT_EQ(status_of(heard(socket, "\r\n\r\n")), "HTTP/1.1 100 Continue");
  say(socket, "abc");
  EXPECT_NE(heard(socket, "posted").find("200 OK"), std::string::npos);
}

TEST_F(ConnectionsTest, WhoTakesAnAnswerSlowlyGoesWhereOthersWait) {
  begin({.hurried = std::chrono::seconds(1), .known = 1, .unknown = 1});
  int slow = connect();
  say(slow, "GET /large HTTP/1.1\r\nX-Key: yes\r\n\r\n");
  int known = connect();
  say(known, kQuick);
  EXPECT_NE(heard(known, "quick").find("200 OK"), std::string::npos);
}

TEST_F(ConnectionsTest, MemoryThatRunsOutInAnAnswerEndsThatConnectionAlone) {
  begin({.known = 1, .unknown = 1});
  int broken = connect();
  say(broken, "GET /broken HTTP/1.1\r\nX-Key: yes\r\n\r\n");
  heard(broken);
  int known = connect();
  say(known, kQuick);
  EXPECT_NE(heard(known, "quick").find("200 OK"), std::string::npos);
}

TEST(Head, IsReadByItsLines) {
  std::string_view head = "POST /a?b=c HTTP/1.1\r\nHost: here\r\nx-KEY:\t some thing \r\nEmpty:";
  EXPECT_EQ(asked_for(head).first, "POST");
  EXPECT_EQ(asked_for(head).second, "/a?b=c");
  EXPECT_EQ(header_of(head, "X-Key"), "some thing");
  EXPECT_EQ(header_of(head, "Host"), "here");
  EXPECT_EQ(header_of(head, "Empty"), "");
  EXPECT_EQ(header_of(head, "Other"), "");
  EXPECT_EQ(asked_for("nonsense").first, "");
}

}  // namespace
}  // namespace frond
