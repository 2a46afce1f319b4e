#include "render/place.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>

#include "core/files.h"
#include "images/whole.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

std::error_code flush_to_disk(const fs::path& path) {
  int file = ::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC);
  if (file < 0 || (::fsync(file) != 0 && errno != EINVAL)) {
    std::error_code error(errno, std::generic_category());
    if (file >= 0) ::close(file);
    return error;
  }
  ::close(file);
  return {};
}

}  // namespace

fs::path part_of(const fs::path& file) {
  fs::path part = file.parent_path() / ("." + file.filename().string() + ".part");
  ::unlink(part.c_str());
  return part;
}

Errors put_in_place(const fs::path& part, const fs::path& file) {
  std::error_code error;
  if (fs::is_directory(fs::symlink_status(file, error)) || fs::is_directory(file, error)) {
    fs::remove(part, error);
    return {{"", file.string() + " is a folder; expected a file, or none"}};
  }
  error = flush_to_disk(part);
  if (!error) fs::rename(part, file, error);
  if (!error) return {};
  std::error_code ignored;
  fs::remove(part, ignored);
  return {{"", file.string() + " could not be written: " + reason_of(error)}};
}

Errors put_text(const fs::path& part, const fs::path& file, std::string_view text) {
  if (std::error_code error = write_new(part, text); error) {
    std::error_code ignored;
    fs::remove(part, ignored);
    return {{"", file.string() + " could not be written: " + reason_of(error)}};
  }
  return put_in_place(part, file);
}

Result<std::string> whole_picture(const fs::path& file, std::array<int, 2> size) {
  Result<std::string> bytes = read_file(file);
  std::optional<std::array<int, 2>> found = bytes ? whole_png(*bytes) : std::nullopt;
  if (!found || (size != std::array<int, 2>{} && *found != size))
    return Error{"", file.string() + " is damaged, or no PNG"};
  return bytes;
}

std::string without_time(std::string_view png) {
  std::size_t at = 8;
  std::string text(png.substr(0, at));
  while (at + 12 <= png.size()) {
    std::string_view type = png.substr(at + 4, 4);
    if (type == "IDAT") break;
    std::size_t length = std::size_t{big_endian_at(png, at)} + 12;
    if (type != "tIME" && type != "tEXt") text += png.substr(at, length);
    at += length;
  }
  return text += png.substr(std::min(at, png.size()));
}

std::array<int, 2> size_of(std::string_view text) {
  std::array<int, 2> size{};
  const char* end = text.data() + text.size();
  auto width = std::from_chars(text.data(), end, size[0]);
  if (width.ec != std::errc{} || width.ptr == end || *width.ptr != 'x') return {};
  auto height = std::from_chars(width.ptr + 1, end, size[1]);
  if (height.ec != std::errc{} || height.ptr != end || size[0] < 1 || size[1] < 1) return {};
  return size;
}

}  // namespace frond
