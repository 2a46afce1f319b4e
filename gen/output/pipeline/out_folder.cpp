#include "pipeline/out_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <string_view>

#include "core/files.h"
#include "core/frame_name.h"
#include "core/parallel.h"
#include "images/whole.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

/// Whether a file beside frames has a name that only we give.
bool is_ours(std::string_view name) {
  for (std::string_view kind : {"bark_", "leaf_", "light_", "model_", "part_"}) {
    if (!name.starts_with(kind)) continue;
    std::string_view key = name.substr(kind.size(), 16);
    return key.size() == 16 && key.find_first_not_of("0123456789abcdef") == key.npos;
  }
  return false;
}

/// Whether a file of that name in a folder of frames is opened by it, by ninja or a script, and written to.
bool is_written_to(std::string_view name) {
  if (name.ends_with(".list"))  // of pictures
    return name.starts_with("film.") || name.starts_with("still.") || name.starts_with("contact.") ||
           name.starts_with("preview.");
  return name == "frames" || name == ".lock" || name == ".times" || name.starts_with(".ninja_");
}

/// The exposure in the name of a file: 3 of "frame_0001_s3.pov"; 0 where there is none.
int exposure_of(std::string_view name) {
  std::size_t at = name.find("_s");
  if (!name.starts_with("frame_") || at == name.npos) return 0;
  int exposure = 0;
  std::from_chars(name.data() + at + 2, name.data() + name.size(), exposure);
  return exposure;
}

}  // namespace

FolderInUse::FolderInUse(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);  // where it cannot be made, whoever writes there says so
  file_ = Descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (file_) ::flock(*file_, LOCK_SH);
}

bool FolderInUse::by_us_alone() { return file_ && ::flock(*file_, LOCK_EX | LOCK_NB) == 0; }

RunLock::RunLock(const fs::path& out, RunEvents& events) {
  std::error_code error;
  fs::create_directories(out, error);
  if (error) {
    errors_ = {{"", out.string() + ": the folder cannot be made"}};
    return;
  }
  fs::path path = out / ".lock";
  errors_ = refuse_link(path);
  if (!errors_.empty()) return;
  file_ = Descriptor(::open(path.c_str(), O_WRONLY | O_CREAT | O_NOFOLLOW, 0666));
  if (!file_) {
    errors_ = {{"", out.string() + ": cannot be written to"}};
    return;
  }
  if (::flock(*file_, LOCK_EX | LOCK_NB) == 0) return;
  events.report(fmt::format("Another run is at work in {}; waiting for it", out.string()));
  while (::flock(*file_, LOCK_EX) != 0 && errno == EINTR) {
  }
}

Errors refuse_folder(const fs::path& folder) {
  std::error_code error;
  fs::path there = fs::absolute(folder, error).lexically_normal();
  if (!there.has_filename()) there = there.parent_path();
  const fs::path asked = there;
  while (!fs::exists(there, error) && there.has_relative_path()) there = there.parent_path();
  std::string wrong;
  if (!fs::is_directory(there, error))
    wrong = "is a file; expected a folder, or none";
  else if (::access(there.c_str(), W_OK) != 0)
    wrong = "cannot be written to";
  if (wrong.empty()) return {};
  if (there != asked) wrong = fmt::format("the folder cannot be made: {} {}", there.string(), wrong);
  return {{folder.string(), wrong}};
}

Errors refuse_file(const fs::path& file) {
  if (is_folder(file)) return {{file.string(), "is a folder; expected a file, or none"}};
  return refuse_folder(file.has_parent_path() ? file.parent_path() : fs::path("."));
}

Errors refuse_links(const fs::path& out) {
  Errors errors;
  for (const fs::path& folder : {out, out / "frames"})
    for (const fs::path& path : files_in(folder)) {
      std::string name = path.filename();
      std::error_code error;
      bool by_name = folder == out ? is_written_to(name) : name.starts_with(".frame_");
      if (by_name && fs::is_symlink(fs::symlink_status(path, error)))
        errors.push_back(error_at(
            path.string(), "is a link, and what it points to would be written to; expected a {}, or none",
            name == "frames" ? "folder" : "file"));
    }
  return errors;
}

Errors refuse_link(const fs::path& path) {
  std::error_code error;
  if (!fs::is_symlink(fs::symlink_status(path, error))) return {};
  return {{path.string(), "is a link, and what it points to would be written to; expected none"}};
}

Result<std::vector<fs::path>> remove_damaged(const fs::path& out, FrameRange range, const Film& film) {
  enum class State { good, damaged, other_size, folder };
  std::vector<fs::path> pictures = {out / "still.png", out / "contact.png"};
  std::size_t results = pictures.size();
  for (const char* folder : {"frames", "raw"})
    for (int frame = range.first; frame <= range.last; ++frame)
      pictures.push_back(out / folder / (frame_name(frame) + ".png"));
  std::size_t raws = results + (pictures.size() - results) / 2;
  std::vector<State> states(pictures.size(), State::good);
  parallel_for(pictures.size(), [&](std::size_t i) {
    std::error_code error;
    fs::file_status status = fs::status(pictures[i], error);
    if (!fs::exists(status)) return;
    Result<std::string> bytes = read_file(pictures[i]);
    std::optional<std::array<int, 2>> found = bytes ? whole_png(*bytes) : std::nullopt;
    if (fs::is_directory(status))
      states[i] = State::folder;
    else if (!found)
      states[i] = State::damaged;
    else if (i >= results && *found != (i >= raws ? film.drawn_size() : film.picture_size()))
      states[i] = State::other_size;
  });
  std::vector<fs::path> damaged;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    if (states[i] == State::good) continue;
    if (states[i] == State::folder && i < results) continue;  // not every film makes it
    if (states[i] == State::folder)
      return Error{pictures[i].string(), "is a folder; expected a picture, or none"};
    if (states[i] == State::damaged) damaged.push_back(pictures[i]);
    std::error_code error;
    fs::remove(pictures[i], error);
    if (error) return Error{pictures[i].string(), "cannot be removed: " + reason_of(error)};
  }
  return damaged;
}

void tidy(const fs::path& out, const std::set<std::string>& needed, int exposures) {
  for (const fs::path& folder : {out, out / "frames"})
    for (const fs::path& path : files_in(folder)) {
      std::string name = path.filename(), type = path.extension();
      bool half =
          type.size() > 4 && type.starts_with(".tmp") && type.find_first_not_of("0123456789", 4) == type.npos;
      bool ours = folder != out && is_ours(name);
      bool surplus = folder != out && type == ".pov" && exposure_of(name) > exposures;
      if (half || surplus || (ours && !needed.contains(name))) remove_file(path);
    }
}

}  // namespace frond
