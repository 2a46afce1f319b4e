#include "render/frame.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <optional>

#include "core/content.h"
#include "core/files.h"
#include "images/png_samples.h"
#include "render/frame_files.h"
#include "render/place.h"
#include "render/process.h"
#include "render/scene_head.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

/// A folder's descriptor, which programs that are started inherit.
class OpenFolder {
 public:
  explicit OpenFolder(const fs::path& folder) : file_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY)) {}

  /// A name of the folder without blanks or quotes, as long as this object lives.
  std::string name() const { return fmt::format("/proc/self/fd/{}", *file_); }

 private:
  Descriptor file_;
};

constexpr int kKilled = 128 + SIGKILL;  // the exit code

/// The rendering of one frame.
class FrameRun {
 public:
  FrameRun(const FrameJob& job, fs::path renderer, const SceneHead& head, std::vector<fs::path> scenes)
      : job_(job),
        renderer_(std::move(renderer)),
        head_(head),
        scenes_(std::move(scenes)),
        folder_(folder_of(job.picture)),
        // POV-Ray parses its options by itself and stumbles over quotes in a path: folders come through
        // descriptors.
        includes_(job.home / "povinc"),
        beside_(folder_of(job.scene)),
        settings_(job.home / "scripts"),
        files_(folder_, "." + job.picture.stem().string(), key(), scenes_.size()) {}

  Result<bool> render() {
    files_.remove_others();
    time_ = files_.begin_time();
    std::vector<fs::path> drawn;
    for (std::size_t i = 0; i < scenes_.size(); ++i) {
      FrameFiles::Exposure names = files_.exposure(i);
      bool alone = scenes_.size() == 1;
      drawn.push_back(alone ? names.part : names.exposed);
      if (!alone && whole_picture(names.exposed, job_.size)) continue;
      if (Result<bool> exposed = expose(scenes_[i], names, drawn.size()); !exposed || !*exposed)
        return exposed;
      if (alone) break;
      if (Errors errors = put_in_place(names.part, names.exposed); !errors.empty()) return errors;
      ::unlink(names.kept.c_str());
    }
    if (Errors errors = finish(drawn); !errors.empty()) return errors;
    if (std::optional<long> took = milliseconds())
      note_frame(folder_of(folder_) / ".times", fmt::format("{} {} {}x{}\n", job_.picture.stem().string(),
                                                            *took, job_.size[0], job_.size[1]));
    files_.remove_all();
    return true;
  }

 private:
  static fs::path folder_of(const fs::path& path) {
    return path.has_parent_path() ? path.parent_path() : fs::path(".");
  }

  /// Stands for all that the picture depends on. What lies beside the scene is named by what is in it.
  std::string key() const {
    std::string all = fmt::format("{}x{}\n", job_.size[0], job_.size[1]);
    for (const std::string& flag : job_.flags) all += flag + '\n';
    std::vector<fs::path> read{renderer_};
    read.insert(read.end(), scenes_.begin(), scenes_.end());
    if (!head_.light.empty()) read.push_back(folder_of(job_.scene) / head_.light);
    for (const fs::path& file : files_in(folder_of(job_.scene))) {
      std::string name = file.filename();
      std::error_code error;
      if (name.starts_with('.') || name.starts_with("frame_") ||
          !fs::is_regular_file(fs::symlink_status(file, error)))
        continue;
      all += fmt::format("{} {}\n", name, fs::file_size(file, error));
    }
    for (const fs::path& file : files_in(job_.home / "povinc"))
      if (file.extension() == ".inc") read.push_back(file);
    for (const fs::path& file : read) {
      Result<std::string> bytes = read_file(file);
      all += bytes ? content_id(*bytes) : "none";
    }
    return content_id(all);
  }

  /// Draws a scene from where it was left; false where it was stopped. `count` scenes were drawn with it.
  Result<bool> expose(const fs::path& scene, const FrameFiles::Exposure& names, std::size_t count) {
    ::unlink(names.part.c_str());
    if (!files_.keep_notes(names))
      return give_up(folder_.string() + ": cannot be written to", names, 0, count);
    Descriptor log(::open(files_.log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC, 0666));
    if (!log) return give_up(folder_.string() + ": cannot be written to", names, 0, count);
    Command command = povray(scene, names.part);
    command.out = command.err = *log;
    Result<pid_t> process = start(command);
    log.close();
    if (!process) return give_up(process.errors()[0].text(), names, 1, count);
    std::optional<int> status = stop_.wait_for(*process);
    if (!status) {
      ::kill(*process, SIGKILL);
      wait_for(*process);
      files_.note_time(milliseconds());
      files_.remove_unfinished(names);
      return false;
    }
    if (*status == 0 && whole_picture(names.part, job_.size)) return true;
    if (!path_exists(files_.log)) return give_up(folder_.string() + " has vanished", names, *status, count);
    return give_up(why(*status), names, *status, count);
  }

  Command povray(const fs::path& scene, const fs::path& part) const {
    Command command;
    // In a session of its own: a signal to the whole group would make POV-Ray end in its own way, with half a
    // picture.
    command.apart = true;
    command.environment = {"POVINI=" + settings_.name() + "/povray.ini",
                           "POV_TEMP_DIR=" + files_.large.string()};
    command.words = {renderer_.string(), "+I" + scene.string(), "+O" + part.string()};
    command.add({head_.fine ? "+FN16" : "+FN8", fmt::format("+W{}", job_.size[0]),
                 fmt::format("+H{}", job_.size[1]), "+L" + includes_.name(), "+L" + beside_.name()});
    if (head_.alpha) command.add({"+UA"});
    command.add(head_.part);
    if (!head_.light.empty()) command.add({"+RFI", "+RF" + (folder_of(job_.scene) / head_.light).string()});
    command.add({fmt::format("+WT{}", job_.threads), "+C", "-D", "-P"});
    command.add(job_.flags);
    if (job_.confined)
      command.confinement = Confinement{
          {folder_of(job_.scene), job_.home / "povinc", job_.home / "scripts" / "povray.ini"}, {folder_}};
    return command;
  }

  /// What matters of POV-Ray's many lines: the file, the line and what was wrong.
  std::string why(int status) const {
    constexpr std::size_t kMost = 6, kLast = 5;
    Result<std::string> log = read_file(files_.log);
    std::string text = log ? *log : "", found;
    std::string folder = includes_.name();
    for (std::size_t at; (at = text.find(folder)) != text.npos;) text.replace(at, folder.size(), "povinc");
    std::vector<std::string> lines = lines_of(text);
    auto at = std::ranges::find_if(lines, [](const auto& line) { return line.find("Error:") != line.npos; });
    std::size_t shown = 0;
    for (; at != lines.end() && shown < kMost; ++at) {
      if (at->empty() || at->find("Fatal error") != at->npos || at->find("Render failed") != at->npos)
        continue;
      found += (shown++ ? "\n" : "") + *at;
    }
    if (shown) return found;
    if (text.find("Cannot access data in file") != text.npos)  // another frame may have made room since
      return "povray could not write; is there no room on the disk?";
    if (status == 0) found = "povray left no whole picture\n";
    if (status > 128) found = fmt::format("povray was ended by signal {} (out of memory?)\n", status - 128);
    for (std::size_t i = lines.size() - std::min(kLast, lines.size()); i < lines.size(); ++i)
      found += lines[i] + '\n';
    return found.substr(0, found.find_last_not_of('\n') + 1);
  }

  Error give_up(std::string reason, const FrameFiles::Exposure& names, int status, std::size_t count) {
    if (files_.disk_is_full(job_.size)) reason = "no room on the disk";
    if (status == 0 || status == kKilled) {
      files_.note_time(milliseconds());
    } else {  // what was traced before it was killed is good; after any other end it is not trusted
      ::unlink(names.state.c_str());
      ::unlink(names.kept.c_str());
      if (count <= 1) ::unlink(files_.spent.c_str());
    }
    files_.remove_unfinished(names);
    return error_at("", "{} could not be rendered: {}", job_.scene.string(), reason);
  }

  /// Makes the picture of what is drawn.
  Errors finish(const std::vector<fs::path>& drawn) {
    FrameFiles::Exposure names = files_.exposure(0);
    std::vector<std::string> pngs;
    for (const fs::path& path : drawn) {
      Result<std::string> bytes = read_file(path);
      if (!bytes) return {give_up(bytes.errors()[0].text(), names, 0, drawn.size())};
      pngs.push_back(std::move(*bytes));
    }
    if (head_.fine && !head_.raw) {
      Result<std::string> picture = develop(pngs, head_.tone, head_.depth);
      if (!picture) return {give_up(picture.errors()[0].what, names, 0, drawn.size())};
      pngs = {std::move(*picture)};
    }
    if (auto [x, y, width, height] = head_.crop; width > 0) {
      Result<PngSamples> whole = read_samples(pngs[0]);
      Result<std::string> part = whole ? samples_text(cut(*whole, x, y, width, height)) : whole.errors();
      if (!part) return {give_up(part.errors()[0].what, names, 0, drawn.size())};
      pngs[0] = std::move(*part);
    }
    std::error_code error = write_new(files_.plain, without_time(pngs[0]));
    if (error)
      return {give_up("its picture could not be written: " + reason_of(error), names, 0, drawn.size())};
    return put_in_place(files_.plain, job_.picture);
  }

  /// Milliseconds of processors that the frame has taken, now and in earlier runs; nothing where one of those
  /// was killed that could not say it.
  std::optional<long> milliseconds() const {
    if (!time_) return std::nullopt;
    long sum = *time_;
    for (int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
      rusage used{};
      ::getrusage(who, &used);
      for (const timeval& time : {used.ru_utime, used.ru_stime})
        sum += time.tv_sec * 1000 + time.tv_usec / 1000;
    }
    return sum;
  }

  static void note_frame(const fs::path& times, const std::string& line) {
    Descriptor file(::open(times.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666));
    if (file) (void)!::write(*file, line.data(), line.size());
  }

  StopSignals stop_;
  const FrameJob& job_;
  fs::path renderer_;
  const SceneHead& head_;
  std::vector<fs::path> scenes_;
  fs::path folder_;
  OpenFolder includes_, beside_, settings_;
  FrameFiles files_;
  std::optional<long> time_;
};

/// The scenes whose mean light is the picture.
std::vector<fs::path> exposures_of(const fs::path& scene, int count) {
  std::vector<fs::path> scenes{scene};
  for (int i = 2; i <= count; ++i)
    scenes.push_back(scene.parent_path() / fmt::format("{}_s{}.pov", scene.stem().string(), i));
  return scenes;
}

}  // namespace

Result<bool> render_frame(const FrameJob& job) {
  auto lost = [&](const std::string& reason) {
    return error_at("", "{} could not be rendered: {}", job.scene.string(), reason);
  };
  std::optional<fs::path> renderer = find_program(job.povray);
  if (!renderer) return Error{"", job.povray + ": no such program"};
  if (!is_file(job.scene)) return lost("it is gone");
  SceneHead head = scene_head_of(job.scene);
  fs::path light = job.scene.parent_path() / head.light;
  if (!head.light.empty() && !is_file(light)) return lost(light.string() + " is gone");
  std::vector<fs::path> scenes = exposures_of(job.scene, head.exposures);
  for (const fs::path& scene : scenes)
    if (!is_file(scene)) return lost("its exposure " + scene.string() + " is gone");
  return FrameRun(job, *renderer, head, std::move(scenes)).render();
}

}  // namespace frond
