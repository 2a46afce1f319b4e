#include "render/frame_files.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include "core/files.h"
#include "core/read_as.h"
#include "render/descriptor.h"
#include "render/trace_state.h"

namespace frond {

namespace fs = std::filesystem;

std::string unfinished_frame(const fs::path& file) {
  std::string name = file.filename();
  return name.starts_with(".frame_") ? name.substr(1, name.find('.', 1) - 1) : std::string();
}

FrameFiles::FrameFiles(fs::path folder, std::string name, const std::string& key, std::size_t exposures)
    : folder_(std::move(folder)), name_(std::move(name)), base_(name_ + "." + key), many_(exposures > 1) {
  plain = folder_ / (base_ + ".plain");
  log = folder_ / (base_ + ".log");
  large = folder_ / (base_ + ".large");
  spent = folder_ / (base_ + ".spent");
}

FrameFiles::Exposure FrameFiles::exposure(std::size_t index) const {
  std::string base = many_ ? fmt::format("{}.{}", base_, index + 1) : base_;
  return {folder_ / (base + ".png"), folder_ / (base + ".pov-state"), folder_ / (base + ".kept"),
          folder_ / (base + ".exposed")};
}

void FrameFiles::remove(bool ours_too) const {
  for (const fs::path& path : files_in(folder_)) {
    std::string file = path.filename();
    std::error_code error;
    if (!file.starts_with(name_ + ".")) continue;
    if (ours_too || !file.starts_with(base_ + ".") || fs::is_symlink(fs::symlink_status(path, error)))
      fs::remove_all(path, error);  // a link itself
  }
}

void FrameFiles::remove_others() const {
  remove(false);
  remove_tree(plain);  // not finished, or they would be in their place
  remove_tree(large);
}

void FrameFiles::remove_all() const { remove(true); }

std::optional<long> FrameFiles::begin_time() const {
  Result<std::string> noted = read_file(spent);
  std::string_view text = noted ? std::string_view(*noted) : "";
  std::optional<long> before = consume_as<long>(text);
  if (!before) {
    bool begun = std::ranges::any_of(files_in(folder_), [&](const fs::path& path) {
      std::string file = path.filename(), type = path.extension();
      std::error_code error;
      return file.starts_with(base_ + ".") && (type == ".kept" || type == ".exposed") &&
             fs::file_size(path, error) > 0;
    });
    if (!begun) before = 0;
  }
  (void)write_new(spent, "?\n");
  return before;
}

void FrameFiles::note_time(std::optional<long> milliseconds) const {
  if (milliseconds) (void)write_new(spent, std::to_string(*milliseconds));
}

bool FrameFiles::keep_notes(const Exposure& names) const {
  std::error_code error;
  fs::create_directory(large, error);
  if (error) return false;
  if (!Descriptor(::open(names.kept.c_str(), O_WRONLY | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666)))
    return false;
  ::unlink(names.state.c_str());
  fs::create_hard_link(names.kept, names.state, error);
  return keep_traced(names.kept).empty();
}

bool FrameFiles::disk_is_full(std::array<int, 2> size) const {
  constexpr double kMost = 1 << 24;
  auto bytes = static_cast<std::size_t>(std::min(kMost, 4.0 * size[0] * size[1]));
  std::error_code error = write_new(plain, std::string(bytes, '\0'));
  return error && reason_of(error) == "no room on the disk";
}

void FrameFiles::remove_unfinished(const Exposure& names) const {
  for (const fs::path& path : {log, names.part, plain, large}) remove_tree(path);
}

}  // namespace frond
