#include "pipeline/run_lock.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

#include "pipeline/out_folder.h"

namespace frond {

RunLock::RunLock(const std::filesystem::path& out, RunEvents& events) {
  std::error_code error;
  std::filesystem::create_directories(out, error);
  if (error) {
    errors_ = {{"", out.string() + ": the folder cannot be made"}};
    return;
  }
  std::filesystem::path path = out / ".lock";
  errors_ = refuse_link(path);
  if (!errors_.empty()) return;
  file_ = ::open(path.c_str(), O_WRONLY | O_CREAT | O_NOFOLLOW, 0666);
  if (file_ < 0) {
    errors_ = {{"", out.string() + ": cannot be written to"}};
    return;
  }
  if (::flock(file_, LOCK_EX | LOCK_NB) == 0) return;
  events.report(fmt::format("Another run is at work in {}; waiting for it", out.string()));
  while (::flock(file_, LOCK_EX) != 0 && errno == EINTR) {
  }
}

RunLock::~RunLock() {
  if (file_ >= 0) ::close(file_);
}

}  // namespace frond
