#include "pipeline/frame_times.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <sstream>

#include "core/files.h"
#include "core/frame_name.h"
#include "pipeline/pace.h"
#include "render/place.h"
#include "render/plot.h"
#include "render/process.h"

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
                const fs::path& preset, RunEvents& events) {
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
  events.report(fmt::format("{:.0f} s of processor; the slowest frames: {}", all, slowest));
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

}  // namespace frond
