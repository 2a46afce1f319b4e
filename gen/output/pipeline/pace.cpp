#include "pipeline/pace.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <vector>

#include "core/content.h"
#include "core/files.h"
#include "core/home.h"
#include "core/work_folder.h"
#include "render/process.h"

namespace frond {

namespace {

std::filesystem::path pace_file() { return cache_folder() / "pace"; }

constexpr std::size_t kKept = 50;
constexpr std::string_view kMachine = "machine";
constexpr double kMachineForetold = 2;  // seconds that the small picture took where scenes were measured
constexpr std::string_view kSmallScene = R"(#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> look_at 0 }
light_source { <4, 8, -6>, 1 area_light 2*x, 2*y, 5, 5 adaptive 1 }
plane { y, -1 pigment { granite scale 2 } }
#declare Turn = 0;
#while (Turn < 400)
  sphere { <mod(Turn * 0.618, 1) * 6 - 3, mod(Turn * 0.414, 1) * 2 - 1, mod(Turn * 0.732, 1) * 6 - 3>, 0.15
    pigment { bozo scale 0.05 } }
  #declare Turn = Turn + 1;
#end
)";

/// Seconds of processor of what was started and has ended.
double seconds_of_others() {
  rusage used{};
  ::getrusage(RUSAGE_CHILDREN, &used);
  auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
  };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

}  // namespace

std::string pace_key(const std::filesystem::path& preset) {
  std::error_code error;
  std::filesystem::path whole = std::filesystem::weakly_canonical(preset, error);
  return content_id((error ? preset : whole).string());
}

void note_pace(std::string_view key, double estimate, double taken) {
  std::string text;
  Result<std::string> noted = read_file(pace_file());
  std::vector<std::string> lines = noted ? lines_of(*noted) : std::vector<std::string>{};
  std::erase_if(lines, [&](const std::string& line) { return line.starts_with(fmt::format("{} ", key)); });
  for (std::size_t i = lines.size() - std::min(lines.size(), kKept - 1); i < lines.size(); ++i)
    text += lines[i] + '\n';
  (void)write_file(pace_file(), text + fmt::format("{} {:.6g} {:.6g}\n", key, estimate, taken));
}

void measure_machine(const std::string& povray) {
  std::error_code error;
  if (std::filesystem::file_size(pace_file(), error) > 0 && !error) return;
  WorkFolder folder;
  if (folder.path().empty()) return;
  Command command;
  command.words = {povray, "+Iscene.pov", "+Oscene.png", "+W160", "+H90", "+A0.1",
                   "+AM2", "+R3",         "-J",          "-D",    "+WT1"};
  command.folder = folder.path();
  OutputCapture said;
  command.out = command.err = said.descriptor();
  double before = seconds_of_others();
  bool drawn = !write_new(command.folder / "scene.pov", kSmallScene) && run(command).ok();
  if (drawn && std::filesystem::exists(command.folder / "scene.png", error))
    note_pace(kMachine, kMachineForetold, seconds_of_others() - before);
}

Pace pace_of(std::string_view key) {
  Pace pace;
  std::vector<double> all;
  std::ifstream in(pace_file());
  std::string noted;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    double estimate = 0, taken = 0;
    if (!(words >> noted >> estimate >> taken) || !(estimate > 0) || !(taken > 0)) continue;
    all.push_back(taken / estimate);
    if (noted == key) pace = {all.back(), "on its last run"};
  }
  if (pace.measured != Pace{}.measured || all.empty()) return pace;
  auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
  std::nth_element(all.begin(), middle, all.end());
  return {*middle, "on other runs of this machine"};
}

}  // namespace frond
