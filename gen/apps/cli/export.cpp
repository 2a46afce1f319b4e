#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/heartbeat.h"
#include "cli/inputs.h"
#include "cli/streams.h"
#include "core/figures.h"
#include "core/home.h"
#include "core/read_as.h"
#include "export/formats.h"
#include "pipeline/out_folder.h"

namespace frond {

namespace {

/// Sets how fine it is, by `250000` or `400px`.
Errors set_detail(const std::string& text, ExportOptions& options) {
  bool pixels = text.ends_with("px");
  std::string_view number = std::string_view(text).substr(0, text.size() - (pixels ? 2 : 0));
  double least = pixels ? 20 : 100, most = pixels ? 1e4 : 1e9;
  std::optional<double> value = read_as<double>(number);
  if (!value || !(*value >= least && *value <= most))
    return {error_at(
        "--detail",
        "\"{}\" is neither 100 to 1e9 triangles, as in 250000, nor 20 to 10000 pixels, as in 400px", text)};
  options.detail = pixels ? detail_seen(*value) : *value;
  options.pixels = pixels ? *value : 0;
  return {};
}

/// Sets the times of the shapes that an animation goes through. Returns the last frame.
Result<int> set_keys(const std::string& frames, int most, const Film& film, ExportOptions& options) {
  Result<FrameRange> range = read_frames(frames, film.frames);
  if (!range) return range.errors();
  int steps = std::min(range->last - range->first, most - 1);
  if (steps < 1) return Error{"--frames", "an animation needs two frames or more; for one there is --frame"};
  for (int i = 0; i <= steps; ++i)
    options.keys.push_back(film.time(range->first + (range->last - range->first) * i / steps));
  return range->last;
}

/// Options that do not go with the format or with each other.
Errors unfit(const Format& format, const ExportArguments& to) {
  auto wrong = [](const char* option, const char* what) { return Errors{Error{option, what}}; };
  if (!format.films && to.frames)
    return wrong("--frames", "of these formats only .glb and .inc hold several frames");
  if (!format.films && to.levels > 1)
    return wrong("--lods", "of these formats only .glb holds levels of detail");
  if (to.seeds > 1) return wrong("--seeds", "of these formats only .inc holds several shapes");
  if (to.voxel > 0 && format.write) return wrong("--voxel", "of these formats only .vdb is made of voxels");
  if (to.sides != ExportArguments{}.sides && !format.write)
    return wrong("--sides", "a .vdb is a volume, in which branches have no sides");
  return {};
}

}  // namespace

void export_scene(const ExportArguments& arguments) {
  Heartbeat heartbeat(arguments.quiet);
  if (arguments.out.ends_with(".inc")) return export_include(arguments);
  const Format* format = or_fail(format_of(arguments.out), kWrongInput);
  Preset preset = or_fail(load_preset(arguments.preset), kWrongInput);
  if (!arguments.quiet) tell_notes(preset.notes);
  const Film& film = preset.film;
  ExportOptions options{.sides = arguments.sides,
                        .voxel = arguments.voxel,
                        .texture = arguments.texture,
                        .instances = arguments.instances,
                        .levels = arguments.levels};
  or_fail(set_detail(arguments.detail, options), kWrongInput);
  int frame = 0;
  if (arguments.frames)
    frame = or_fail(set_keys(*arguments.frames, arguments.keys, film, options), kWrongInput);
  or_fail(unfit(*format, arguments), kWrongInput);
  if (!arguments.frames) frame = or_fail(read_frame(arguments.frame, film.frames), kWrongInput);
  or_fail(refuse_file(arguments.out), kCouldNot);
  if (Result<std::filesystem::path> folder = home())
    options.bake = {.home = *folder, .cache = cache_folder() / "materials"};
  now_doing("growing what stands in the scene");
  Scene scene = or_fail(build_scene(preset), kWrongInput);

  auto estimate_cost = [&](const ExportTold& told) {
    if (arguments.quiet) return;
    std::string levels;
    for (double triangles : told.triangles)
      levels += fmt::format("{}{:.0f}", levels.empty() ? "" : ", ", triangles);
    tell(fmt::format("{}: about {}; triangles: {}", arguments.out, bytes_text(told.bytes), levels));
  };
  now_doing("writing the mesh or the volume");
  auto written = write_scene(*format, scene, film.time(frame), options, arguments.out, estimate_cost);
  if (written) {
    if (!arguments.quiet && !written->empty())
      tell(fmt::format("note: at frame {} of {} nothing has grown yet of {}", frame, film.frames,
                       fmt::join(*written, ", ")));
    return;
  }
  // What the disk says stands at a path; all else is what was asked for.
  Errors errors = written.errors();
  bool wrong = errors.front().where.empty();
  if (wrong) errors.front().where = arguments.out;
  bool early = wrong && errors.front().what.starts_with(kNothingYet);
  fail(errors, early ? kNothingGrown : wrong ? kWrongInput : kCouldNot);
}

}  // namespace frond
