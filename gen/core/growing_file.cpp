#include "core/growing_file.h"

#include <cerrno>
#include <cstring>
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
  if (!out_.is_open()) return;
  out_.close();
  std::error_code error;
  fs::remove(temporary_, error);
}

void GrowingFile::add(std::string_view text) {
  held_ += text;
  if (held_.size() < kHeld || error_ != 0) return;
  if (!out_.is_open()) {
    std::error_code error;
    if (path_.has_parent_path()) fs::create_directories(path_.parent_path(), error);
    fs::remove(temporary_, error);  // a link there would be written through
    out_.open(temporary_, std::ios::binary);
  }
  out_.write(held_.data(), static_cast<std::streamsize>(held_.size()));
  if (!out_) error_ = errno != 0 ? errno : EIO;
  held_.clear();
}

Result<bool> GrowingFile::close() {
  if (!out_.is_open() && error_ == 0) return write_file(path_, held_);
  out_.write(held_.data(), static_cast<std::streamsize>(held_.size()));
  out_.flush();
  if (!out_ && error_ == 0) error_ = errno != 0 ? errno : EIO;
  if (error_ != 0) return Error{path_.string(), std::string("cannot be written: ") + std::strerror(error_)};
  if (same(temporary_, path_)) return false;
  out_.close();
  std::error_code error;
  fs::rename(temporary_, path_, error);
  if (!error) return true;
  fs::remove(temporary_, error);
  return Error{path_.string(), "cannot be put in place"};
}

}  // namespace frond
