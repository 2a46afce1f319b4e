#include "core/files.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>

namespace frond {

namespace fs = std::filesystem;

namespace {

/// The system takes a name to end at a NUL, and would open another file.
Errors refused_name(const fs::path& path) {
  if (path.native().find('\0') == std::string::npos) return {};
  return {Error{path.string(), "is no name of a file: it holds a NUL"}};
}

}  // namespace

Result<std::string> read_file(const fs::path& path) {
  if (Errors errors = refused_name(path); !errors.empty()) return errors;
  std::error_code error;
  auto size = fs::file_size(path, error);
  if (error) return Error{path.string(), "cannot be read: " + error.message()};
  std::ifstream in(path, std::ios::binary);
  if (!in) return Error{path.string(), "cannot be read: " + std::string(std::strerror(errno))};
  std::string text(size, '\0');
  in.read(text.data(), static_cast<std::streamsize>(size));
  text.resize(static_cast<std::size_t>(in.gcount()));
  return text;
}

namespace {

bool holds(const fs::path& path, std::string_view text) {
  std::error_code error;
  if (fs::file_size(path, error) != text.size() || error) return false;
  auto now = read_file(path);
  return now.ok() && *now == text;
}

template <class Iterator>
std::vector<fs::path> found_by(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code error;
  for (Iterator at(folder, error), end; !error && at != end; at.increment(error)) found.push_back(at->path());
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace

std::error_code error_now() { return std::error_code(errno, std::generic_category()); }

std::error_code write_fully(int file, std::string_view text) {
  while (!text.empty()) {
    ssize_t written = ::write(file, text.data(), text.size());
    if (written >= 0)
      text.remove_prefix(static_cast<std::size_t>(written));
    else if (errno != EINTR)
      return error_now();
  }
  return {};
}

std::error_code write_new(const fs::path& path, std::string_view text) {
  ::unlink(path.c_str());
  int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file < 0) return error_now();
  std::error_code error = write_fully(file, text);
  if (!error && ::fsync(file) != 0 && errno != EINVAL) error = error_now();  // EINVAL: a pipe, a device
  if (::close(file) != 0 && !error) error = error_now();
  return error;
}

std::string reason_of(std::error_code error) {
  if (error == std::errc::no_space_on_device || error == std::error_code(EDQUOT, std::generic_category()))
    return "no room on the disk";
  return error.message();
}

bool path_exists(const fs::path& path) {
  std::error_code error;
  return fs::exists(path, error);
}

bool is_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

bool is_folder(const fs::path& path) {
  std::error_code error;
  return fs::is_directory(path, error);
}

bool remove_file(const fs::path& path) {
  std::error_code error;
  return fs::remove(path, error);
}

void remove_tree(const fs::path& path) {
  std::error_code error;
  fs::remove_all(path, error);
}

fs::path path_from(const fs::path& folder, const fs::path& path) {
  std::error_code error;
  return fs::relative(fs::absolute(path, error), fs::absolute(folder, error), error);
}

fs::path temporary_beside(const fs::path& path) {
  constexpr unsigned kNumbers = 1'000'000;
  static std::atomic<unsigned> next = 0;
  std::string number = std::to_string(kNumbers + next++ % kNumbers).substr(1);
  fs::path temporary = path;
  temporary += ".tmp" + std::to_string(::getpid()) + number;
  return temporary;
}

Result<bool> write_file(const fs::path& path, std::string_view text) {
  if (Errors errors = refused_name(path); !errors.empty()) return errors;
  if (holds(path, text)) return false;
  std::error_code error;
  if (path.has_parent_path()) fs::create_directories(path.parent_path(), error);
  if (error) return Error{path.parent_path().string(), "cannot be made: " + reason_of(error)};
  fs::path temporary = temporary_beside(path);
  std::string_view what = "cannot be written: ";
  error = write_new(temporary, text);
  if (!error) {
    what = "cannot be put in place: ";
    fs::rename(temporary, path, error);
  }
  if (!error) return true;
  std::error_code ignored;
  fs::remove(temporary, ignored);
  return Error{path.string(), std::string(what) + reason_of(error)};
}

FolderLock::FolderLock(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);  // where it cannot be made, whoever writes there says so
  file_ = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  while (file_ >= 0 && ::flock(file_, LOCK_EX) != 0 && errno == EINTR) {
  }
}

FolderLock::~FolderLock() {
  if (file_ >= 0) ::close(file_);
}

std::vector<fs::path> files_in(const fs::path& folder) { return found_by<fs::directory_iterator>(folder); }

std::vector<fs::path> files_below(const fs::path& folder) {
  return found_by<fs::recursive_directory_iterator>(folder);
}

}  // namespace frond
