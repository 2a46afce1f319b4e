#include "studio/renders.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <iterator>
#include <system_error>

#include "core/cancellation.h"
#include "core/files.h"
#include "core/frame_name.h"
#include "core/parallel.h"
#include "core/text.h"
#include "film/film_files.h"
#include "jobs/jobs.h"
#include "render/process.h"
#include "render/traced_view.h"
#include "studio/answers.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kKept = 60;    // renders, the newest
constexpr double kBytesAPixel = 20;  // of POV-Ray's notes of what it has traced
constexpr int kPreview = 4;          // times smaller
constexpr const char* kText = "preset.json";
constexpr const char* kPicture = "picture.png";
constexpr int kLeastForPreview = 320;  // pixels wide
constexpr auto kLook = std::chrono::milliseconds(100);
constexpr auto kShow = std::chrono::seconds(1);  // from one picture of what is traced to the next

/// A program at work, which ends with this at the latest.
class Running {
 public:
  explicit Running(pid_t process) : process_(process) {}
  ~Running() {
    if (process_ == 0) return;
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  void end() const { kill(process_, SIGTERM); }
  /// What it ended with; nothing while it is at work.
  std::optional<int> status() {
    int status = 0;
    if (waitpid(process_, &status, WNOHANG) == 0) return std::nullopt;
    process_ = 0;
    return status;
  }

 private:
  pid_t process_;
};

/// POV-Ray's notes of what it has traced of a picture; empty where there are none.
fs::path notes_of(const fs::path& folder, const std::string& name) {
  for (const fs::path& file : files_in(folder)) {
    std::string own = file.filename().string();
    if (own.starts_with('.' + name + '.') && own.ends_with(".pov-state")) return file;
  }
  return {};
}

/// The share of a picture that the notes hold.
double traced(const fs::path& notes, std::array<int, 2> size) {
  std::error_code error;
  auto bytes = static_cast<double>(fs::file_size(notes, error));
  return error ? 0 : std::min(1.0, bytes / (kBytesAPixel * size[0] * size[1]));
}

}  // namespace

struct Renders::Job {
  std::string id;
  Doc doc;  // its text lies in the folder once it is not needed
  double time = 0;
  int frame = 1;  // of the film, at that time
  std::array<int, 2> size{};
  std::string quality;
  std::optional<Preset> preset;  // until it has grown
  std::string title;
  std::uint64_t seed = 0;
  bool lens = false;
  fs::path folder;

  // Guarded by Renders::mutex_.
  std::string state = "waiting", message;
  double progress = 0;
  fs::path picture;
  bool preview = false;
  Clock::time_point began = Clock::now(), tracing = began;
  double seconds = 0;

  std::atomic<bool> cancelled = false;
  std::thread thread;

  bool over() const { return state == "done" || state == "failed" || state == "cancelled"; }
};

Renders::Renders(const Documents& documents, Scenes& scenes, fs::path home)
    : documents_(documents), scenes_(scenes), home_(std::move(home)) {
  std::string name = (fs::temp_directory_path() / "frond-studio-XXXXXX").string();
  if (mkdtemp(name.data())) folder_ = name;
}

void Renders::end() {
  {
    std::lock_guard lock(mutex_);
    for (auto& job : jobs_) job->cancelled = true;
  }
  turn_.notify_all();
}

Renders::~Renders() {
  end();
  std::vector<std::shared_ptr<Job>> all;
  {
    std::lock_guard lock(mutex_);
    all.assign(jobs_.begin(), jobs_.end());
  }
  for (auto& job : all)
    if (job->thread.joinable()) job->thread.join();
  if (!folder_.empty()) remove_tree(folder_);
}

Result<std::string> Renders::begin(Doc doc, double time, std::array<int, 2> size,
                                   const std::string& quality) {
  if (folder_.empty()) return Error{"", "there is no room for temporary files"};
  if (povray_flags(quality, false).empty()) return error_at("", "\"{}\" is no quality", quality);
  auto job = std::make_shared<Job>();
  Result<Preset> preset = documents_.preset(
      doc, {fmt::format("/film/size=[{},{}]", size[0], size[1]), "/film/quality=\"" + quality + "\""});
  if (!preset) return preset.errors();
  job->title = preset->title, job->seed = preset->seed;
  job->lens = preset->setup.camera.aperture.has_value();
  job->frame = frame_at(preset->film, time);
  job->preset = std::move(*preset);
  job->doc = std::move(doc);
  job->time = time, job->size = size, job->quality = quality;
  std::lock_guard lock(mutex_);
  job->id = std::to_string(++count_);
  job->folder = folder_ / job->id;
  jobs_.push_front(job);
  if (jobs_.size() > kKept && jobs_.back()->over()) {
    std::shared_ptr<Job> last = jobs_.back();
    jobs_.pop_back();
    if (last->thread.joinable()) last->thread.detach();  // it has ended, or is about to
    remove_tree(last->folder);
  }
  try {
    job->thread = std::thread([this, job] { work(*job); });
  } catch (const std::system_error&) {
    jobs_.remove(job);
    return Error{"", "the system gives no thread to render in"};
  }
  return job->id;
}

std::shared_ptr<Renders::Job> Renders::find(const std::string& id) {
  auto found = std::ranges::find(jobs_, id, [](const auto& job) { return job->id; });
  return found == jobs_.end() ? nullptr : *found;
}

void Renders::work(Job& job) {
  {
    std::unique_lock lock(mutex_);
    turn_.wait(lock, [&] { return !busy_ || job.cancelled; });
    if (!job.cancelled) busy_ = true, job.state = "growing", job.began = Clock::now();
  }
  Errors errors;
  if (!job.cancelled) {
    // Nothing is above this in the thread: memory, too, runs out in an answer.
    try {
      errors = make(job);
    } catch (...) {
      errors = {Error{"", reason_of(std::current_exception())}};
    }
    clear(job);
    std::lock_guard lock(mutex_);
    busy_ = false;
    job.seconds = std::chrono::duration<double>(Clock::now() - job.began).count();
  }
  std::lock_guard lock(mutex_);
  job.state = job.cancelled ? "cancelled" : errors.empty() ? "done" : "failed";
  if (!errors.empty() && !job.cancelled) job.message = errors.front().text();
  turn_.notify_all();
}

/// The picture, first a small one. Of all that it was made from only the preset's text stays.
Errors Renders::make(Job& job) {
  auto set = [&](auto change) {
    std::lock_guard lock(mutex_);
    change();
  };
  Result<bool> kept = write_file(job.folder / kText, job.doc.text);
  Errors errors = kept ? Errors{} : kept.errors();
  try {
    if (kept) while_wanted([&] { return job.cancelled.load(); }, [&] { errors = write(job); });
  } catch (const Cancelled&) {
  }
  if (kept) set([&] { job.doc.text = {}; });
  scenes_.tidy();
  if (errors.empty() && !job.cancelled) {
    set([&] { job.state = "rendering", job.tracing = Clock::now(); });
    if (job.size[0] >= kLeastForPreview) {
      errors = render(job, {job.size[0] / kPreview, job.size[1] / kPreview}, povray_flags("draft", job.lens),
                      "preview");
      set([&] { job.preview = errors.empty(), job.picture = job.folder / "frames/preview.png"; });
    }
    set([&] { job.progress = 0, job.tracing = Clock::now(); });
    std::string name = frame_name(job.frame);
    if (errors.empty() && !job.cancelled)
      errors = render(job, job.size, povray_flags(job.quality, job.lens), name);
    std::error_code error;
    if (errors.empty()) fs::rename(job.folder / "frames" / (name + ".png"), job.folder / kPicture, error);
  }
  return errors;
}

/// Only the picture stays of what was made.
void Renders::clear(Job& job) {
  fs::path picture = job.folder / kPicture;
  {
    std::lock_guard lock(mutex_);
    job.preview = false, job.preset.reset();
    job.picture = path_exists(picture) ? picture : fs::path();
  }
  remove_tree(job.folder / "frames");
  scenes_.tidy();
}

Errors Renders::write(Job& job) {
  Preset preset = std::move(*job.preset);
  job.preset.reset();
  Result<std::string> layout = read_file(home_ / "templates/frame.pov");
  if (!layout) return layout.errors();
  ProgressSink watch{[](auto, auto) {}, [] {}, [&] { return job.cancelled.load(); }};
  auto grown = scenes_.scene(job.doc, std::move(preset), watch.cancelled);
  if (!grown) return grown.errors();
  const Scene& scene = **grown;
  fs::path frames = job.folder / "frames";
  if (Errors errors = write_drawings(scene, frames, watch); !errors.empty()) return errors;
  // How finely copies are drawn holds for the one frame.
  Result<CopyPlan> plan = write_models(scene, frames, watch);
  if (!plan) return plan.errors();
  FrameParts parts = prepare_frames(scene, std::move(*plan));
  for (const Picture& file : parts.files)
    if (Result<bool> written = write_file(frames / file.name, file.bytes); !written) return written.errors();
  if (Errors errors = write_light(scene, parts, frames); !errors.empty()) return errors;
  int count = exposures(scene.film, scene.setup.camera);
  for (int exposure = 1; exposure <= count && !job.cancelled; ++exposure) {
    Result<FrameFile> written =
        write_frame_file(scene, parts, *layout, frames, job.frame, count > 1 ? exposure : 0);
    if (!written) return written.errors();
  }
  return {};
}

Errors Renders::render(Job& job, std::array<int, 2> size, std::string_view flags, const std::string& name) {
  // This program, even where another was built in its place meanwhile.
  Command command;
  command.words = {"/proc/self/exe", "frame", "frames/" + frame_name(job.frame) + ".pov"};
  command.add({"frames/" + name + ".png", fmt::format("{}x{}", size[0], size[1]), "--"});
  command.add(split(flags, ' '));
  command.environment = {"FROND_HOME=" + fs::absolute(home_).string(),
                         fmt::format("FROND_THREADS={}", thread_count())};
  command.folder = job.folder;
  fs::path log = job.folder / (name + ".log");
  command.out = command.err = ::open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  command.end_with = SIGTERM;
  command.apart = true;
  Result<pid_t> child = start(command);
  if (command.out >= 0) ::close(command.out);
  if (!child) return child.errors();
  Running program(*child);
  std::optional<int> status;
  bool told = false;
  Clock::time_point show = Clock::now() + kShow;
  while (!(status = program.status())) {
    if (job.cancelled && !told) program.end(), told = true;
    fs::path notes = notes_of(job.folder / "frames", name);
    double share = traced(notes, size);
    {
      std::lock_guard lock(mutex_);
      job.progress = std::max(job.progress, share);  // the notes are gone before the picture is there
    }
    if (job.preview && share > 0 && Clock::now() >= show) {
      Clock::time_point began = Clock::now();
      show_traced(job, notes, size);
      show = Clock::now() + std::max<Clock::duration>(kShow, 10 * (Clock::now() - began));
    }
    std::this_thread::sleep_for(kLook);
  }
  if (*status == 0 || job.cancelled) return {};
  Result<std::string> said = read_file(log);
  return {Error{"", said && !said->empty() ? *said : "POV-Ray could not render it"}};
}

/// Lays what is traced of the picture over the small one.
void Renders::show_traced(Job& job, const fs::path& notes, std::array<int, 2> size) {
  fs::path frames = job.folder / "frames", file = job.folder / "traced.png";
  Result<std::string> small = read_file(frames / "preview.png");
  Result<Raster> below = small ? read_png(*small) : small.errors();
  Result<std::string> png =
      traced_png(notes, frames / (frame_name(job.frame) + ".pov"), size, below ? &*below : nullptr);
  if (!png || !write_file(file, *png)) return;
  std::lock_guard lock(mutex_);
  job.picture = file;
}

std::optional<Json> Renders::state(const std::string& id) {
  std::lock_guard lock(mutex_);
  std::shared_ptr<Job> job = find(id);
  if (!job) return std::nullopt;
  auto since = [](Clock::time_point t) { return std::chrono::duration<double>(Clock::now() - t).count(); };
  double tracing = since(job->tracing);
  Json left = nullptr;
  if (job->state == "rendering" && job->progress > 0.02) left = tracing * (1 / job->progress - 1);
  return Json{{"id", job->id},
              {"state", job->state == "waiting" ? "growing" : job->state},
              {"progress", job->state == "done" ? 1.0 : job->progress},
              {"seconds", job->over() ? job->seconds : since(job->began)},
              {"left", left},
              {"message", job->message},
              {"preview", job->preview},
              {"title", job->title},
              {"seed", job->seed},
              {"time", job->time},
              {"size", job->size},
              {"quality", job->quality}};
}

Json Renders::list() {
  std::vector<std::string> ids;
  {
    std::lock_guard lock(mutex_);
    for (const auto& job : jobs_) ids.push_back(job->id);
  }
  Json list = Json::array();
  for (const std::string& id : ids)
    if (std::optional<Json> one = state(id)) list.push_back(std::move(*one));
  return list;
}

std::optional<Doc> Renders::doc(const std::string& id) {
  std::lock_guard lock(mutex_);
  std::shared_ptr<Job> job = find(id);
  if (!job) return std::nullopt;
  Result<std::string> text = read_file(job->folder / kText);
  return text ? Doc{*text, job->doc.file} : job->doc;
}

Result<std::string> Renders::picture(const std::string& id) {
  fs::path file;
  {
    std::lock_guard lock(mutex_);
    if (std::shared_ptr<Job> job = find(id)) file = job->picture;
  }
  if (file.empty()) return Error{id, "there is no picture yet"};
  return read_file(file);
}

bool Renders::cancel(const std::string& id) {
  std::lock_guard lock(mutex_);
  std::shared_ptr<Job> job = find(id);
  if (job) job->cancelled = true;
  turn_.notify_all();
  return job != nullptr;
}

}  // namespace frond
