#include "render/place.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>

#include "core/files.h"
#include "core/read_as.h"
#include "images/whole.h"
#include "render/descriptor.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

std::error_code flush_to_disk(const fs::path& path) {
  Descriptor file(::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC));
  bool done = file && (::fsync(*file) == 0 || errno == EINVAL);
  return done ? std::error_code() : std::error_code(errno, std::generic_category());
}

/// Removes what cannot become a file, and says why.
Errors not_written(const fs::path& part, const fs::path& file, std::error_code why) {
  remove_file(part);
  return {{"", file.string() + " could not be written: " + reason_of(why)}};
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
  return error ? not_written(part, file, error) : Errors{};
}

Errors put_text(const fs::path& part, const fs::path& file, std::string_view text) {
  std::error_code error = write_new(part, text);
  return error ? not_written(part, file, error) : put_in_place(part, file);
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
  int width = consume_as<int>(text).value_or(0);
  if (width < 1 || !text.starts_with('x')) return {};
  int height = read_as<int>(text.substr(1)).value_or(0);
  return height < 1 ? std::array<int, 2>{} : std::array{width, height};
}

}  // namespace frond
