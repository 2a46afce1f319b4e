#include "pipeline/render_run.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <set>

#include "core/files.h"
#include "core/frame_name.h"
#include "core/text.h"
#include "render/film.h"
#include "render/place.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

constexpr int kMostFaults = 6;  // that are shown
constexpr std::string_view kNoRoom = ": no room on the disk";
constexpr std::string_view kResolving = "resolving frames ";
constexpr double kSilence = 1.75;  // seconds; nothing is told of a second without events

std::string picture_in(std::string_view folder, int frame) {
  return fmt::format("{}/{}.png", folder, frame_name(frame));
}

/// The number of "frame 12"; 0 of another text.
int frame_of(std::string_view what) {
  constexpr std::string_view kFrame = "frame ";
  int number = 0;
  if (what.starts_with(kFrame))
    std::from_chars(what.data() + kFrame.size(), what.data() + what.size(), number);
  return number;
}

}  // namespace

double seconds_now() {
  auto since = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(since).count();
}

RenderRun::RenderRun(RenderSettings settings, std::vector<std::string> environment, Stop& stop,
                     RunEvents& events)
    : settings_(std::move(settings)),
      stop_(stop),
      events_(events),
      ninja_(settings_.out, environment, stop),
      environment_(std::move(environment)) {}

std::vector<std::string> RenderRun::results() const {
  if (manifest_.still) return {"still.png"};
  return {film_file(settings_.format), "contact.png"};
}

Outcome RenderRun::run() {
  if (Errors errors = prepare(); !errors.empty()) return {std::move(errors)};
  begin();
  if (Errors errors = render_every_kth(); !errors.empty()) return {std::move(errors)};
  make(failed_.empty() ? results() : pictures_of(1));
  return end();
}

Errors RenderRun::prepare() {
  Result<Manifest> manifest = manifest_in(settings_.out);
  if (!manifest) return manifest.errors();
  manifest_ = std::move(*manifest);
  if (settings_.format.empty()) settings_.format = film_format(manifest_.transparent);
  for (const std::string& result : results())
    if (is_folder(settings_.out / result))
      return {{"", (settings_.out / result).string() + " is a folder; expected a file, or none"}};
  remove_old_results();
  for (const Manifest::Frame& frame : manifest_.frames) {
    fs::path scene = settings_.out / "frames" / (frame_name(frame.number) + ".pov");
    if (!is_file(scene)) return {{"", scene.string() + " is gone; the same command writes it again"}};
  }
  find_what_to_do();
  return {};
}

void RenderRun::remove_old_results() {
  // What others of the kind there are is no longer of these frames, unless ninja knows it to be.
  std::vector<std::string> wanted = results();
  for (const std::string& name : result_files()) {
    fs::path path = settings_.out / name;
    if (std::ranges::find(wanted, name) != wanted.end() || !is_file(path)) continue;
    if (ninja_.answer({"-n", name}).find("no work to do") == std::string::npos) remove_file(path);
  }
  // One that is damaged, or another film's.
  fs::path film = settings_.out / wanted[0];
  events_.doing("counting the frames of the film");
  if (!manifest_.still && is_file(film) &&
      frames_in(film, settings_.ffmpeg, manifest_.fps) != static_cast<int>(manifest_.frames.size()))
    remove_file(film);
}

void RenderRun::find_what_to_do() {
  std::vector<std::string> words = results();
  words.insert(words.begin(), "-n");
  for (const std::string& line : lines_of(ninja_.answer(words))) {
    if (int frame = frame_of(line)) to_do_.push_back(frame);
    if (line.starts_with(kResolving)) ++to_resolve_;
  }
}

void RenderRun::begin() {
  std::size_t all = static_cast<std::size_t>(all_frames());
  if (to_do_.empty() && to_resolve_ == 0)
    events_.report(fmt::format("Nothing to render: all {} frames are up to date.", all));
  else if (to_do_.empty())
    events_.report("Resolving frames");
  else if (to_do_.size() < all)
    events_.report(fmt::format("Rendering {} of {} frames; the others are up to date.", to_do_.size(), all));
  else
    events_.report(fmt::format("Rendering {} frame{}.", all, all == 1 ? "" : "s"));
  fs::path scenes = settings_.out / "frames", drawn = settings_.out / manifest_.drawn_folder();
  left_.emplace(scenes, drawn, manifest_.size, to_do_, settings_.jobs, seconds_now());
  if (settings_.watch && !to_do_.empty()) {
    fs::path file = settings_.out / "watch.png";
    watched_.emplace(file, scenes, drawn, manifest_.size);
    events_.report("What is traced shows in " + file.string());
  }
  waits_since_ = seconds_now();
  // Processors that no frame of their own keeps busy help with another.
  int frames = static_cast<int>(to_do_.size());
  int threads = frames > 0 && settings_.jobs > frames ? settings_.jobs / frames : 1;
  std::vector<std::string> environment = environment_;
  environment.push_back(fmt::format("FROND_THREADS={}", threads));
  ninja_.set_environment(std::move(environment));
}

void RenderRun::make(const std::vector<std::string>& files) {
  if (gave_up_ || files.empty()) return;
  NinjaEvents events{[this](std::string_view what) { done(what); },
                     [this](const std::string& line) { said(line); }, [this] { idle(); }};
  Result<Ninja::End> end = ninja_.make(files, settings_.jobs, events);
  if (!end) {
    errors_ = end.errors();
    gave_up_ = true;
    return;
  }
  interrupted_ = end->stopped;
  if (end->well) return;
  failed_.insert(failed_.end(), end->failed.begin(), end->failed.end());
  if (end->stopped || end->failed.empty() || disk_full_) gave_up_ = true;
}

int RenderRun::all_frames() const {
  // Where frames are resolved more are rendered: those around them.
  return static_cast<int>(std::max(manifest_.frames.size(), to_do_.size()));
}

std::vector<std::string> RenderRun::pictures_of(int step) const {
  std::vector<std::string> pictures;
  // Frames are resolved when all raw ones around them are there: until then those are looked at.
  std::string_view folder = step > 1 ? manifest_.drawn_folder() : "frames";
  for (std::size_t i = 0; i < manifest_.frames.size(); i += static_cast<std::size_t>(step)) {
    std::string picture = picture_in(folder, manifest_.frames[i].number);
    if (std::ranges::find(failed_, picture) == failed_.end()) pictures.push_back(std::move(picture));
  }
  return pictures;
}

Errors RenderRun::render_every_kth() {
  int all = static_cast<int>(manifest_.frames.size()), wanted = static_cast<int>(to_do_.size());
  for (int step = std::min(settings_.every, all); step > 1 && wanted > 0; step /= 2) {
    int before = left_->done();
    std::vector<std::string> pictures = pictures_of(step);
    make(pictures);
    if (gave_up_ || !failed_.empty() || left_->done() == before || left_->done() == wanted) continue;
    FilmJob job;
    for (const std::string& picture : pictures) job.pictures.push_back(settings_.out / picture);
    job.film = settings_.out / "preview.mp4";
    job.fps = number_text(manifest_.fps / step, 6);
    job.title = "preview";
    job.ffmpeg = settings_.ffmpeg;
    events_.doing("encoding a film of some of the frames");
    if (Errors errors = encode_film(job); !errors.empty()) return errors;
    events_.report(fmt::format("One of {} frames is there, and a film of them: {}", step, job.film.string()));
  }
  return {};
}

Error RenderRun::lost_frames() const {
  constexpr std::size_t kMost = 12;
  std::set<int> lost;
  bool film = false;
  for (const std::string& file : failed_) {
    film = film || file.starts_with("film.");
    for (const Manifest::Frame& frame : manifest_.frames)
      if (file == picture_in("frames", frame.number) || file == picture_in("raw", frame.number))
        lost.insert(frame.number);
  }
  std::string out = settings_.out.string();
  if (!lost.empty()) {
    std::vector<int> shown(lost.begin(), lost.end());
    bool more = shown.size() > kMost;
    if (more) shown.resize(kMost);
    return error_at("", "of {} these frames could not be rendered: {}{}; those that are finished are kept",
                    out, fmt::join(shown, ", "), more ? ", ..." : "");
  }
  if (film) return error_at("", "the film could not be encoded; the frames of {} are kept", out);
  return error_at("", "not all of {} could be made; the frames that are finished are kept", out);
}

Outcome RenderRun::end() {
  if (interrupted_ || stop_.asked()) return {{}, false, true};
  if (gave_up_ || !failed_.empty()) errors_.push_back(lost_frames());
  if (!errors_.empty()) return {errors_};
  fs::path film = settings_.out / results()[0];
  int all = static_cast<int>(manifest_.frames.size());
  events_.doing("counting the frames of the film");
  int held = manifest_.still ? all : frames_in(film, settings_.ffmpeg, manifest_.fps);
  if (held != all) return {{error_at("", "{} holds {} of {} frames", film.string(), held, all)}};
  // Unfinished pictures that are no part of this film, and what killed runs have left.
  for (const char* folder : {"frames", "raw"})
    for (const fs::path& path : files_in(settings_.out / folder))
      if (path.filename().string().starts_with(".frame_")) remove_tree(path);
  for (const std::string& name : result_files()) remove_file(part_of(settings_.out / name));
  for (const char* name :
       {"preview.mp4", "watch.png", ".watch.png.part", ".film.gif.part.png", ".preview.mp4.part"})
    remove_file(settings_.out / name);
  return {};
}

void RenderRun::done(std::string_view what) {
  int wanted = static_cast<int>(to_do_.size());
  if (what.starts_with(kResolving) && --to_resolve_ == 0 && left_->done() >= wanted) begin_last();
  int frame = frame_of(what);
  if (frame == 0) return;
  left_->frame_done(frame);
  double now = seconds_now();
  left_->look(now);
  int all = all_frames();
  int there = all - wanted + left_->done();
  bool last = left_->done() == wanted;
  std::string text = fmt::format("frame {} of {}", there, all);
  if (last)
    text += ", rendered in " + clock_text(left_->seconds_taken(now));
  else if (std::optional<double> left = left_->seconds_left(now))
    text += fmt::format(", about {} left", clock_text(*left));
  events_.rendered({.done = there,
                    .all = all,
                    .percent = left_->percent(),
                    .whole = true,
                    .last = last,
                    .wanted = wanted,
                    .words = text});
  if (last) begin_last();
}

void RenderRun::begin_last() {
  if (to_resolve_ > 0)
    events_.report("Resolving frames");
  else if (!manifest_.still)
    events_.report("Encoding the film");
  waits_since_ = seconds_now();
}

void RenderRun::idle() {
  double now = seconds_now();
  int all = all_frames(), wanted = static_cast<int>(to_do_.size());
  RenderedSoFar so_far{
      .done = all - wanted + left_->done(), .all = all, .percent = 100, .wanted = wanted, .words = {}};
  std::string text;
  if (left_->done() < wanted) {
    left_->look(now);
    if (watched_) watched_->look(now);
    so_far.percent = left_->percent();
    text = fmt::format("{} % of the {}", so_far.percent,
                       wanted == 1 ? std::string("picture") : fmt::format("{} frames", wanted));
    if (std::optional<double> left = left_->seconds_left(now))
      text += fmt::format(", about {} left", clock_text(*left));
    if (left_->reads()) text += ", reading the scene";
  } else {
    const char* what = to_resolve_ > 0   ? "resolving frames"
                       : manifest_.still ? "writing the picture"
                                         : "encoding the film";
    text = fmt::format("still {} ({:.0f} s)", what, now - waits_since_);
  }
  so_far.words = text;
  events_.rendered(so_far);
}

void RenderRun::said(std::string line) {
  if (tells_full_disk(line)) line = "ninja" + std::string(kNoRoom);
  if (line.ends_with(kNoRoom)) {
    if (disk_full_) return;  // once is enough, and no other frame would fare better
    disk_full_ = true;
    ninja_.end();
  }
  if (line.starts_with("error:")) ++faults_;
  if (faults_ == kMostFaults) {
    events_.report("What else fails is not shown.");
    ++faults_;
  }
  if (faults_ < kMostFaults) events_.report(line);
}

}  // namespace frond
