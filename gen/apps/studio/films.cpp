#include "studio/films.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <system_error>
#include <thread>

#include "core/files.h"
#include "core/frame_name.h"
#include "core/read_as.h"
#include "core/text.h"
#include "farm/hand_over.h"
#include "jobs/jobs.h"
#include "render/process.h"
#include "scene/named_files.h"
#include "studio/answers.h"
#include "studio/film_rendering.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

constexpr const char* kOrder = "film.json";
constexpr const char* kPreset = "preset.json";
constexpr int kMostFilms = 1000;
constexpr int kMostFrames = 1'000'000'000;
constexpr int kRoughWide = 240, kRoughFrames = 12;
constexpr std::string_view kTransparent = "transparent";  // of what is told of a preset
/// What browsers play that keeps opacity; a .mov is for programs that cut films.
constexpr std::string_view kPlayedClear = "webm";

Json order_json(const FilmOrder& order) {
  return {{"size", order.size},
          {"quality", order.quality},
          {"range", order.frames},
          {"rough", order.rough},
          {"farm", order.farm}};
}

/// What `frond render` is told of a film's size and quality.
std::vector<std::string> sets_of(std::array<int, 2> size, const std::string& quality) {
  return {fmt::format("/film/size=[{},{}]", size[0], size[1]), "/film/quality=\"" + quality + "\""};
}

/// Those of the rough film, which lasts as long as the whole one.
std::vector<std::string> rough_sets(const Film& film) {
  int frames = std::min(kRoughFrames, film.frames);
  int high = std::max(16, static_cast<int>(kRoughWide * film.aspect()));
  std::vector<std::string> sets = sets_of({kRoughWide, high}, "draft");
  sets.push_back(fmt::format("/film/frames={}", frames));
  sets.push_back(fmt::format("/film/fps={:.9g}", std::max(0.1, frames / film.length())));
  return sets;
}

/// The numbers of the frames below a folder that are there.
std::vector<int> frames_there(const fs::path& folder) {
  constexpr std::string_view kBegin = "frame_";
  std::vector<int> numbers;
  for (const fs::path& file : files_in(folder)) {
    std::string stem = file.stem().string();
    if (file.extension() != ".png" || !stem.starts_with(kBegin)) continue;
    if (auto number = read_as<int>(std::string_view(stem).substr(kBegin.size()))) numbers.push_back(*number);
  }
  std::ranges::sort(numbers);
  return numbers;
}

/// The finished film in a folder, without opacity or with it; empty where there is none.
std::string film_in(const fs::path& folder) {
  for (bool transparent : {false, true})
    if (std::string name = film_file(film_format(transparent)); path_exists(folder / name)) return name;
  return {};
}

/// Whether a film is paused.
class Paused final : public Stop {
 public:
  explicit Paused(const std::atomic<bool>& stop) : stop_(stop) {}
  bool asked() override { return stop_; }

 private:
  const std::atomic<bool>& stop_;
};

}  // namespace

struct Films::Job {
  std::string id;
  fs::path folder;
  FilmOrder order;
  Json told;  // of the preset: title, seed, fps and how many frames are to be rendered
  std::vector<std::string> rough_sets;

  // Guarded by Films::mutex_.
  std::string state = "paused", phase, message;
  std::string said;  // last, by what renders it
  std::atomic<bool> stop = false;
  std::thread thread;

  fs::path preset() const { return folder / kPreset; }
  fs::path frames() const { return order.farm ? folder / "farm/latest/frames" : folder / "frames"; }
  /// The format of the film that the page plays, and of the rough one.
  std::string_view played() const {
    return told.value(kTransparent, false) ? kPlayedClear : film_format(false);
  }
  bool at_work() const { return state == "waiting" || state == "rendering"; }
};

Films::Films(const Documents& documents) : documents_(documents), folder_(documents.folder() / "out/films") {
  find_earlier();
}

Films::~Films() {
  std::vector<std::string> ids;
  for (const auto& job : jobs_) ids.push_back(job->id);
  for (const std::string& id : ids) pause(id);
  for (const auto& job : jobs_)
    if (job->thread.joinable()) job->thread.join();
}

void Films::find_earlier() {
  std::vector<std::pair<fs::file_time_type, std::shared_ptr<Job>>> found;
  for (const fs::path& folder : files_in(folder_)) {
    Result<std::string> text = read_file(folder / kOrder);
    Json json = text ? Json::parse(*text, nullptr, false) : Json();
    if (!json.is_object() || found.size() >= kMostFilms) continue;
    auto job = std::make_shared<Job>();
    try {
      const Json& order = json.at("order");
      job->order = {size_in(order), order.at("quality"), order.at("range"), order.at("rough"),
                    order.at("farm")};
      job->told = json.at("told"), job->rough_sets = json.at("rough");
      (void)whole_number(job->told.at("frames"), "frames", 1, kMostFrames);
    } catch (const std::exception&) {
      continue;  // another version's
    }
    job->id = folder.filename(), job->folder = folder;
    std::error_code error;
    if (!film_in(folder).empty()) job->state = "done";
    found.emplace_back(fs::last_write_time(folder / kOrder, error), std::move(job));
  }
  std::ranges::sort(found, std::greater<>(), [](const auto& one) { return one.first; });
  for (auto& [when, job] : found) jobs_.push_back(std::move(job));
}

Result<fs::path> Films::make_folder(const Doc& doc) const {
  std::string name = plain_name(doc.file.stem().string(), "film");
  std::error_code error;
  fs::create_directories(folder_, error);
  for (int number = 1; number <= kMostFilms && !error; ++number) {
    fs::path folder = folder_ / fmt::format("{}-{}", name, number);
    if (fs::create_directory(folder, error)) return folder;
  }
  std::string temporary = (fs::temp_directory_path() / ("frond-" + name + "-XXXXXX")).string();
  if (!mkdtemp(temporary.data())) return Error{folder_.string(), "nothing can be written there"};
  return fs::path(temporary);
}

Result<std::string> Films::begin(const Doc& doc, const FilmOrder& order) {
  if (povray_flags(order.quality, false).empty()) return error_at("", "\"{}\" is no quality", order.quality);
  Result<Preset> preset = documents_.preset(doc, sets_of(order.size, order.quality));
  if (!preset) return preset.errors();
  const Film& film = preset->film;
  if (film.frames == 1)
    return Error{"", "this is a still, which Renders makes: a film has two frames or more"};
  Result<std::string> text = with_whole_paths(doc.text, doc.file.parent_path());
  if (!text) return text.errors();
  Result<fs::path> folder = make_folder(doc);
  if (!folder) return folder.errors();
  auto job = std::make_shared<Job>();
  job->id = folder->filename(), job->folder = *folder, job->order = order;
  job->told = {{"title", preset->title},
               {"seed", preset->seed},
               {"fps", film.fps},
               {"frames", film.frames},
               {kTransparent, film.transparent()}};
  job->rough_sets = rough_sets(film);
  Json kept{{"order", order_json(order)}, {"told", job->told}, {"rough", job->rough_sets}};
  for (const auto& [file, content] : {std::pair(kOrder, kept.dump(2)), std::pair(kPreset, *text)})
    if (Result<bool> written = write_file(*folder / file, content); !written) return written.errors();
  std::lock_guard lock(mutex_);
  jobs_.push_front(job);
  start(job);
  return job->id;
}

std::shared_ptr<Films::Job> Films::find(const std::string& id) {
  auto found = std::ranges::find(jobs_, id, [](const auto& job) { return job->id; });
  return found == jobs_.end() ? nullptr : *found;
}

/// With mutex_ locked.
void Films::start(const std::shared_ptr<Job>& job) {
  if (job->thread.joinable()) job->thread.join();  // it has ended
  job->state = "waiting", job->phase.clear(), job->message.clear(), job->said.clear(), job->stop = false;
  try {
    job->thread = std::thread([this, job] { work(*job); });
  } catch (const std::system_error&) {
    job->state = "failed", job->message = "the system gives no thread to render in";
  }
}

void Films::work(Job& job) {
  // Nothing is above this in the thread: memory, too, runs out in an answer.
  try {
    make(job);
  } catch (...) {
    std::lock_guard lock(mutex_);
    if (job.state == "rendering") busy_ = false;
    job.state = "failed", job.message = reason_of(std::current_exception());
    turn_.notify_all();
  }
}

void Films::make(Job& job) {
  std::unique_lock lock(mutex_);
  turn_.wait(lock, [&] { return !busy_ || job.stop; });
  std::string fault;
  if (!job.stop) {
    busy_ = true, job.state = "rendering";
    FilmRendering rendering(job.preset(), job.stop, [&](std::string_view line) {
      std::lock_guard held(mutex_);
      job.said = line;
    });
    auto step = [&](const char* phase, const std::function<std::string()>& run) {
      if (!fault.empty() || job.stop) return;
      job.phase = phase;
      lock.unlock();
      fault = run();
      lock.lock();
    };
    std::vector<std::string> sets = sets_of(job.order.size, job.order.quality);
    if (job.order.rough && !path_exists(job.folder / "rough" / film_file(job.played())))
      step("rough",
           [&] { return rendering.render(job.folder / "rough", job.rough_sets, "", job.played(), false); });
    if (job.order.farm) {
      step("frames", [&] { return hand_to_farm(job, sets); });
    } else {
      step("frames", [&] { return rendering.render(job.folder, sets, job.order.frames, "", true); });
      if (job.played() == kPlayedClear)  // the film itself is there then; what cannot be played is told
        step("frames",
             [&] { return rendering.render(job.folder, sets, job.order.frames, kPlayedClear, false), ""; });
    }
    busy_ = false;
  }
  bool failed = !fault.empty() && !job.stop;
  job.state = job.stop ? "paused" : failed ? "failed" : job.order.farm ? "farm" : "done";
  if (failed) job.message = fault;
  turn_.notify_all();
}

/// Hands the film over to Slurm; what is wrong where that cannot be.
std::string Films::hand_to_farm(const Job& job, const std::vector<std::string>& sets) {
  Result<std::string> text = read_file(job.preset());
  Result<Preset> preset = text ? read_preset(*text, job.preset().string(), sets) : text.errors();
  if (!preset) return preset.errors().front().text();
  FarmOrder order{.file = job.preset(), .out = job.folder, .program = own_program()};
  for (const std::string& set : sets) order.words.push_back("--set=" + set);
  if (!job.order.frames.empty()) order.frames = job.order.frames;
  Paused paused(job.stop);
  RunEvents events;
  RenderedFilm handed = hand_over(order, *preset, paused, events);
  return handed.outcome.errors.empty() ? "" : handed.outcome.errors.front().text();
}

Json Films::told(const Job& job) const {
  std::vector<int> frames = frames_there(job.frames());
  std::size_t done = frames.size();
  // Frames that are resolved come last: until then those are shown that they are resolved from.
  if (std::vector<int> raw = frames_there(job.folder / "raw"); raw.size() > done) frames = raw;
  int of = job.told.at("frames");
  if (Result<std::string> text = read_file(job.folder / "manifest.json"))
    if (auto manifest = read_manifest(*text, kPreset)) of = static_cast<int>(manifest->frames.size());
  std::string film = film_in(job.folder), plays;
  bool done_with = !film.empty() && !job.at_work();
  std::string played = film_file(job.played());
  bool whole = done_with && path_exists(job.folder / played);
  if (whole || path_exists(job.folder / "rough" / played))
    plays = whole ? played : "rough." + std::string(job.played());
  Json answer{{"id", job.id},
              {"folder", job.folder.string()},
              {"state", job.state == "farm" && done_with ? "done" : job.state},
              {"phase", job.phase},
              {"message", job.message},
              {"said", job.at_work() ? job.said : ""},
              {"done", std::min<std::size_t>(frames.size(), static_cast<std::size_t>(of))},
              {"of", of},
              {"there", frames},
              {"film", done_with ? film : ""},
              {"plays", plays},
              {"watch", job.at_work() && path_exists(job.folder / "watch.png")},
              {"order", order_json(job.order)}};
  answer.update(job.told);
  return answer;
}

std::optional<Json> Films::state(const std::string& id) {
  std::lock_guard lock(mutex_);
  std::shared_ptr<Job> job = find(id);
  return job ? std::optional(told(*job)) : std::nullopt;
}

Json Films::list() {
  std::lock_guard lock(mutex_);
  Json all = Json::array();
  for (const auto& job : jobs_) all.push_back(told(*job));
  return all;
}

bool Films::pause(const std::string& id) {
  std::lock_guard lock(mutex_);
  std::shared_ptr<Job> job = find(id);
  if (!job) return false;
  if (job->at_work()) job->stop = true;
  if (job->state == "farm" && cancel_farm(farm_folder(job->folder)).empty()) job->state = "paused";
  turn_.notify_all();
  return true;
}

bool Films::resume(const std::string& id) {
  std::lock_guard lock(mutex_);
  std::shared_ptr<Job> job = find(id);
  if (job && (job->state == "paused" || job->state == "failed")) start(job);
  return job != nullptr;
}

bool Films::remove(const std::string& id) {
  if (!pause(id)) return false;
  std::shared_ptr<Job> job;
  {
    std::lock_guard lock(mutex_);
    job = find(id);
    if (!job) return false;
    jobs_.remove(job);
  }
  if (job->thread.joinable()) job->thread.join();
  remove_tree(job->folder);
  return true;
}

std::optional<fs::path> Films::file(const std::string& id, const std::string& name) {
  std::lock_guard lock(mutex_);
  std::shared_ptr<Job> job = find(id);
  if (!job) return std::nullopt;
  std::vector<fs::path> places;
  for (std::string_view format : kFilmFormats)
    if (name == film_file(format))
      places = {job->folder / name};
    else if (name == "rough." + std::string(format))
      places = {job->folder / "rough" / film_file(format)};
  if (name == "watch.png")
    places = {job->folder / name};
  else if (int number = counting_number(name))
    for (const fs::path& folder : {job->frames(), job->folder / "raw"})
      places.push_back(folder / (frame_name(number) + ".png"));
  for (const fs::path& place : places)
    if (is_file(place)) return place;
  return std::nullopt;
}

}  // namespace frond
