#include "core/files.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

namespace frond {

namespace fs = std::filesystem;

Result<std::string> read_file(const fs::path& path) {
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

}  // namespace

Result<bool> write_file(const fs::path& path, std::string_view text) {
  if (holds(path, text)) return false;
  std::error_code error;
  if (path.has_parent_path()) fs::create_directories(path.parent_path(), error);
  if (error) return Error{path.parent_path().string(), "cannot be made: " + error.message()};
  fs::path temporary = path;
  temporary += ".tmp" + std::to_string(::getpid());
  auto failed = [&](std::string_view what) {
    Error result{path.string(), std::string(what) + ": " + std::strerror(errno)};
    fs::remove(temporary, error);
    return result;
  };
  std::ofstream out(temporary, std::ios::binary);
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  out.close();
  if (!out) return failed("cannot be written");
  fs::rename(temporary, path, error);
  if (error) return failed("cannot be put in place");
  return true;
}

}  // namespace frond
