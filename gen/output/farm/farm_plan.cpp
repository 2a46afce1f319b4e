#include "farm/farm_plan.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/files.h"
#include "core/frame_name.h"
#include "core/read_as.h"
#include "jobs/jobs.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

constexpr int kBlock = 32;  // rows; bands are of whole blocks of POV-Ray

bool is_there(const fs::path& pictures, const std::string& name) {
  return path_exists(pictures / (name + ".png"));
}

Result<FarmPlan> plan_bands(const fs::path& folder, const fs::path& pictures, int bands) {
  Result<bool> noted = write_file(folder / "bands", fmt::format("{}\n", bands));
  if (!noted) return noted.errors();
  FarmPlan plan{{"bands", std::to_string(bands)}, {}, bands, 1, true, ""};
  for (int band = 1; band <= bands; ++band)
    if (!is_there(pictures, frame_name(1)) && !is_there(pictures, band_name(band, bands)))
      plan.tasks.push_back(band);
  return plan;
}

FarmPlan plan_frames(const fs::path& pictures, int first, int last, const FarmLimits& limits) {
  FarmPlan plan;
  plan.chunk = limits.chunk;
  if ((last - first) / plan.chunk >= limits.most) {
    plan.chunk = (last - first) / limits.most + 1;
    plan.note =
        fmt::format("This cluster takes {} tasks at most: each renders {} frames", limits.most, plan.chunk);
  }
  plan.all = (last - first) / plan.chunk + 1;
  plan.work = {"frames", std::to_string(first), std::to_string(last), std::to_string(plan.chunk)};
  for (int task = 1; task <= plan.all; ++task) {
    int from = first + (task - 1) * plan.chunk;
    for (int frame = from; frame < from + plan.chunk && frame <= last; ++frame)
      if (!is_there(pictures, frame_name(frame))) {
        plan.tasks.push_back(task);
        break;
      }
  }
  return plan;
}

}  // namespace

std::string band_name(int band, int bands) { return fmt::format("band_{}_of_{}", band, bands); }

int bands_of(const fs::path& folder) {
  Result<std::string> noted = read_file(folder / "bands");
  std::string_view text = noted ? std::string_view(*noted) : "";
  return consume_as<int>(text).value_or(0);
}

std::string FarmPlan::tasks_text() const {
  std::string text;
  for (std::size_t i = 0; i < tasks.size();) {
    std::size_t last = i;
    while (last + 1 < tasks.size() && tasks[last + 1] == tasks[last] + 1) ++last;
    text += fmt::format("{}{}", i ? "," : "", tasks[i]);
    if (last > i) text += fmt::format("-{}", tasks[last]);
    i = last + 1;
  }
  return text;
}

std::string FarmPlan::text() const {
  std::string what = bands ? "bands" : fmt::format("chunks of {} frames", chunk);
  return fmt::format("{} of {} {}", tasks.size(), all, what);
}

Result<FarmPlan> plan_farm(const fs::path& folder, const FarmLimits& limits) {
  Result<Manifest> manifest = manifest_in(folder);
  if (!manifest) return manifest.errors();
  fs::path pictures = folder / manifest->drawn_folder();
  int blocks = (manifest->size[1] + kBlock - 1) / kBlock;
  int bands = std::min({limits.bands, limits.most, blocks});
  if (manifest->still && bands > 1) return plan_bands(folder, pictures, bands);
  auto [first, last] = manifest->drawn();
  return plan_frames(pictures, first, last, limits);
}

std::string farm_status(const fs::path& folder) {
  Result<Manifest> manifest = manifest_in(folder);
  std::size_t all = 0, there = 0;
  fs::path pictures;
  if (manifest) {
    pictures = folder / manifest->drawn_folder();
    auto [first, last] = manifest->drawn();
    for (int frame = first; frame <= last; ++frame) ++all, there += is_there(pictures, frame_name(frame));
  }
  int bands = bands_of(folder);
  if (bands > 0 && there == 0) {
    all = static_cast<std::size_t>(bands);
    for (int band = 1; band <= bands; ++band) there += is_there(pictures, band_name(band, bands));
  }
  return fmt::format("{} of {} pictures are rendered\n", there, all);
}

}  // namespace frond
