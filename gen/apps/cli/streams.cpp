#include "cli/streams.h"

#include <fcntl.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>

namespace frond {

namespace {

std::atomic<int> failed = 0;  // errno of the first write to stdout that did not arrive
std::atomic<const char*> doing = "starting";
std::atomic<std::size_t> told = 0;  // of put_words()

}  // namespace

void open_streams() {
  // Open the other way round, so that writing to what was closed still fails.
  for (int stream : {0, 1, 2})
    if (::fcntl(stream, F_GETFD) == -1 && errno == EBADF)
      if (::open("/dev/null", stream == 0 ? O_WRONLY : O_RDONLY) < 0) return;
}

void put(std::string_view text) {
  int none = 0;
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size())
    failed.compare_exchange_strong(none, errno);
}

void flush() { (void)std::fflush(stdout); }

void put_words(std::string_view text) {
  (void)std::fwrite(text.data(), 1, text.size(), stderr);
  ++told;
}
std::size_t words_told() { return told; }

Errors close_out() {
  if (std::fflush(stdout) != 0) {
    int none = 0;
    failed.compare_exchange_strong(none, errno);
  }
  if (failed == 0 && std::ferror(stdout) == 0) return {};
  return {{"stdout", std::string("cannot be written: ") + std::strerror(failed == 0 ? EIO : failed.load())}};
}

void now_doing(const char* what) { doing = what; }
const char* what_is_done() { return doing; }

}  // namespace frond
