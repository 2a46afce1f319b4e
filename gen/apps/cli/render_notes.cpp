#include "cli/render_notes.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "cli/bar.h"
#include "cli/commands.h"
#include "cli/messages.h"
#include "cli/pace.h"
#include "cli/streams.h"
#include "core/files.h"
#include "core/frame_name.h"
#include "core/printable.h"
#include "render/place.h"
#include "render/plot.h"

namespace frond {

namespace fs = std::filesystem;

std::vector<FrameTime> read_times(const fs::path& out) {
  std::vector<FrameTime> times;
  Result<std::string> text = read_file(out / ".times");
  if (!text) return times;
  for (const std::string& line : lines_of(*text)) {
    std::istringstream words(line);
    FrameTime time;
    if (words >> time.name >> time.seconds) times.push_back({time.name, time.seconds / 1000});
  }
  return times;
}

void note_times(const fs::path& out, std::size_t before, const Manifest& manifest, int rendered,
                const fs::path& preset) {
  std::vector<FrameTime> times = read_times(out);
  times.erase(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(std::min(before, times.size())));
  if (rendered == 0 || times.empty()) return;
  double all = 0;
  for (const FrameTime& time : times) all += time.seconds;
  note_pace(pace_key(preset), manifest.render_seconds * static_cast<double>(times.size()), all);
  if (rendered < 2) return;
  std::ranges::stable_sort(times, std::greater<>(), &FrameTime::seconds);
  constexpr std::size_t kShown = 3;
  std::string slowest;
  for (std::size_t i = 0; i < std::min(kShown, times.size()); ++i) {
    std::string_view number = std::string_view(times[i].name).substr(times[i].name.find('_') + 1);
    number.remove_prefix(std::min(number.find_first_not_of('0'), number.size()));
    slowest += fmt::format("{}{} ({:.1f} s)", i ? ", " : "", number, times[i].seconds);
  }
  say(fmt::format("{:.0f} s of processor; the slowest frames: {}", all, slowest));
}

Errors write_plot(const fs::path& out, const Manifest& manifest, const fs::path& file) {
  std::map<std::string, double> seconds;
  for (const FrameTime& time : read_times(out)) seconds[time.name] = time.seconds;
  std::vector<PlotFrame> frames;
  for (const Manifest::Frame& frame : manifest.frames) {
    PlotFrame plotted{frame.number, static_cast<double>(frame.nodes), {}, {}};
    std::string name = frame_name(frame.number);
    std::error_code error;
    auto bytes = fs::file_size(out / "frames" / (name + ".pov"), error);
    if (!error) plotted.bytes = static_cast<double>(bytes);
    if (auto found = seconds.find(name); found != seconds.end()) plotted.seconds = found->second;
    frames.push_back(plotted);
  }
  return put_text(part_of(file), file, plot_text(frames));
}

namespace {

/// The reason that ninja gives first; the others follow from it. Empty where there is none.
std::string reason_told(const std::string& told, const std::string& name) {
  auto says = [&](const std::string& words) { return told.find(words) != told.npos; };
  std::string scene = name + ".pov", picture = name + ".png", older = "older than most recent input ";
  if (says(scene) && says(" is missing"))
    return "its scene " + scene + " is missing; the next run writes it again";
  if (says(picture + " doesn't exist")) return "there is no picture of it";
  if (says(older + scene)) return "its scene is newer than its picture";
  if (says(older)) {
    std::string rest = told.substr(told.find(older) + older.size());
    return rest.substr(0, rest.find(" (")) + " is newer than its picture";
  }
  if (says("command line changed for " + picture))
    return "its size, quality or flags are others than those it was rendered with";
  if (says("command line not found in log")) return "nothing is noted of how its picture was rendered";
  return says("no work to do") ? "" : told;
}

/// The first line that differs in two texts, as it was and as it is.
void tell_change(const std::string& before, const std::string& now) {
  std::vector<std::string> was = lines_of(before), is = lines_of(now);
  was.resize(std::max(was.size(), is.size()));
  is.resize(was.size());
  auto [a, b] = std::ranges::mismatch(was, is);
  if (a == was.end()) return;
  constexpr std::size_t kMost = 100;
  put(fmt::format("its scene has changed, from line {} on:\n  was: {}\n  is:  {}\n", a - was.begin() + 1,
                  printable(a->substr(0, kMost)), printable(b->substr(0, kMost))));
}

}  // namespace

int tell_why(const Ninja& ninja, const fs::path& out, int frame, const std::string& before) {
  std::string name = "frames/" + frame_name(frame);
  std::string told = ninja.answer({"-d", "explain", "-n", name + ".png"});
  if (told.find("unknown target") != told.npos)
    return fail_run({{"", fmt::format("frame {} is none of this film", frame)}}, kWrongInput);
  std::string reason = reason_told(told, name);
  if (reason.empty()) {
    put(fmt::format("frame {} is up to date\n", frame));
    return kDone;
  }
  put(fmt::format("frame {} is rendered again: {}\n", frame, reason));
  if (Result<std::string> now = read_file(out / (name + ".pov")); now && !before.empty())
    tell_change(before, *now);
  return kDone;
}

}  // namespace frond
