#include "core/growing_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstring>
#include <fstream>
#include <utility>
#include <vector>

#include "core/files.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kHeld = 4'000'000;  // bytes, up to which a file is written at once

bool same(const fs::path& one, const fs::path& other) {
  std::error_code error;
  if (!fs::is_regular_file(other, error) || fs::file_size(one, error) != fs::file_size(other, error) || error)
    return false;
  std::ifstream a(one, std::ios::binary), b(other, std::ios::binary);
  std::vector<char> left(1 << 20), right(left.size());
  while (a && b) {
    a.read(left.data(), static_cast<std::streamsize>(left.size()));
    b.read(right.data(), static_cast<std::streamsize>(right.size()));
    if (a.gcount() != b.gcount() ||
        std::memcmp(left.data(), right.data(), static_cast<std::size_t>(a.gcount())) != 0)
      return false;
  }
  return a.eof() && b.eof();
}

}  // namespace

GrowingFile::GrowingFile(fs::path path) : path_(std::move(path)), temporary_(temporary_beside(path_)) {}

GrowingFile::~GrowingFile() {
  if (file_ < 0) return;
  ::close(file_);
  ::unlink(temporary_.c_str());
}

void GrowingFile::write_held() {
  if (!error_) error_ = write_fully(file_, held_);
  held_.clear();
}

void GrowingFile::add(std::string_view text) {
  if (error_) return;
  held_ += text;
  if (held_.size() < kHeld) return;
  if (file_ < 0) {
    if (path_.has_parent_path()) fs::create_directories(path_.parent_path(), error_);
    if (error_) return;
    ::unlink(temporary_.c_str());  // a link there would be written through
    file_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file_ < 0) error_ = error_now();
  }
  write_held();
}

Error GrowingFile::failed(std::string_view what) {
  ::unlink(temporary_.c_str());
  return Error{path_.string(), std::string(what) + reason_of(error_)};
}

Result<bool> GrowingFile::close() {
  if (file_ < 0 && !error_) return write_file(path_, held_);
  if (file_ >= 0) {
    write_held();
    bool left_alone = !error_ && same(temporary_, path_);
    if (!left_alone && !error_ && ::fsync(file_) != 0) error_ = error_now();
    if (::close(std::exchange(file_, -1)) != 0 && !error_) error_ = error_now();
    if (left_alone && !error_) {
      ::unlink(temporary_.c_str());
      return false;
    }
  }
  if (error_) return failed("cannot be written: ");
  fs::rename(temporary_, path_, error_);
  if (error_) return failed("cannot be put in place: ");
  return true;
}

}  // namespace frond
