#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <optional>
#include <set>
#include <span>

#include "app/commands.h"
#include "app/inputs.h"
#include "app/out_folder.h"
#include "app/pace.h"
#include "app/progress.h"
#include "app/streams.h"
#include "core/content.h"
#include "core/figures.h"
#include "core/files.h"
#include "core/machine.h"
#include "core/parallel.h"
#include "emit/frame.h"
#include "estimate/estimate_cost.h"
#include "film/film_files.h"
#include "jobs/jobs.h"
#include "render/process.h"
#include "scene/scene.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

struct Written {
  int frames = 0;  // that changed on disk
  Errors errors;
  std::set<std::string> beside;    // what frames include
  std::vector<std::size_t> nodes;  // that each shows
};

/// Writes the frames of a range, up to `at_once` at a time.
Written write_frames(const Scene& scene, CopyPlan plan, const std::string& layout, const fs::path& out,
                     FrameRange range, int at_once, bool quiet) {
  FrameParts parts = prepare_frames(scene, std::move(plan));
  std::set<std::string> beside;
  for (const Picture& file : parts.files) {
    beside.insert(file.name);
    Result<bool> written = write_file(out / "frames" / file.name, file.bytes);
    if (!written) return {0, written.errors(), {}, {}};
  }
  if (Errors lost = write_light(scene, parts, out / "frames"); !lost.empty()) return {0, lost, {}, {}};
  if (!parts.light.empty()) beside.insert(parts.light);
  int each = exposures(scene.film, scene.stage.camera), count = (range.last - range.first + 1) * each;
  Progress progress("frames", count, quiet);
  std::atomic<int> next = 0;
  std::vector<Errors> errors(static_cast<std::size_t>(count));
  std::vector<char> changed(errors.size());
  std::vector<std::size_t> nodes(static_cast<std::size_t>(count / each));
  parallel_for(static_cast<std::size_t>(std::min(at_once, count)), [&](std::size_t) {
    for (int i; (i = next++) < count;) {
      int frame = range.first + i / each, exposure = each > 1 ? 1 + i % each : 0;
      Result<FrameFile> written = write_frame_file(scene, parts, layout, out / "frames", frame, exposure);
      if (written) {
        changed[static_cast<std::size_t>(i)] = written->changed;
        if (i % each == 0) nodes[static_cast<std::size_t>(i / each)] = written->nodes;
      } else {
        errors[static_cast<std::size_t>(i)] = written.errors();
      }
      progress.step();
    }
  });
  Written result{0, {}, std::move(beside), std::move(nodes)};
  for (auto i = changed.begin(); i != changed.end(); i += each)
    result.frames += std::any_of(i, i + each, [](char one) { return one != 0; });
  for (const Errors& list : errors) result.errors.insert(result.errors.end(), list.begin(), list.end());
  return result;
}

/// Writes build.ninja and manifest.json for the frames of a range; `nodes` of each, where that is known.
/// `rendered`: the pictures come from elsewhere.
Errors write_jobs(const Preset& preset, FrameRange range, const std::vector<std::size_t>& nodes,
                  double render_seconds, const fs::path& root, const fs::path& out, const std::string& name,
                  bool rendered) {
  const Film& film = preset.film;
  JobList jobs;
  jobs.size = film.size;
  jobs.quality = kRenderings[static_cast<std::size_t>(film.quality)].quality;
  jobs.lens = preset.stage.camera.aperture.has_value();
  jobs.exposures = exposures(film, preset.stage.camera);
  jobs.fps = film.fps;
  jobs.still = film.frames == 1;
  jobs.rendered = rendered;
  jobs.title = preset.title;
  jobs.seed = preset.seed;
  std::error_code error;
  jobs.povinc = fs::relative(root / "povinc", out, error).string();
  jobs.program = fs::relative(own_program(), out, error).string();
  for (const fs::path& file : files_in(root / "povinc"))
    if (file.extension() == ".inc") jobs.includes.push_back(file.filename());
  if (error || jobs.includes.empty())
    return {{(root / "povinc").string(), "holds no .inc files; set FROND_HOME to the folder of Frond"}};

  Manifest manifest;
  manifest.version = FROND_VERSION;
  manifest.preset = name;
  manifest.title = preset.title;
  manifest.preset_hash = content_id(preset.text);
  manifest.seed = preset.seed;
  manifest.fps = film.fps;
  manifest.size = film.size;
  manifest.quality = jobs.quality;
  manifest.still = jobs.still;
  manifest.render_seconds = render_seconds;
  for (int frame = range.first; frame <= range.last; ++frame) {
    jobs.frames.push_back(frame);
    auto i = static_cast<std::size_t>(frame - range.first);
    manifest.frames.push_back({frame, film.time(frame), i < nodes.size() ? nodes[i] : 0});
  }
  Errors errors;
  auto write = [&](const char* file, const std::string& text) {
    Result<bool> written = write_file(out / file, text);
    if (!written) errors = written.errors();
  };
  write("manifest.json", manifest_text(manifest));
  write("build.ninja", ninja_text(jobs));
  return errors;
}

/// Removes pictures that cannot be used, and tells of those that are damaged.
Errors remove_unusable(const fs::path& out, FrameRange range, const std::array<int, 2>& size) {
  Result<std::vector<fs::path>> damaged = remove_damaged(out, range, size);
  if (!damaged) return damaged.errors();
  for (const fs::path& picture : *damaged)
    tell(fmt::format("note: {} is damaged; it is made again", picture.string()));
  return {};
}

/// The machine that a run is held to: what an earlier one has left in its folder makes room for the new.
Machine machine_for(const fs::path& out) {
  Machine machine = this_machine(out);
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(out / "frames", error)) {
    std::error_code gone;
    fs::path type = entry.path().extension();
    auto size = type == ".pov" || type == ".inc" ? entry.file_size(gone) : 0;
    if (!gone) machine.disk += static_cast<double>(size);
  }
  return machine;
}

}  // namespace

int generate(const GenerateArguments& arguments) {
  limit_threads(arguments.threads);
  Result<Preset> preset = load_preset(arguments.preset);
  if (!preset) return fail(preset.errors(), kWrongInput);
  FrameRange range{1, preset->film.frames};
  if (arguments.frames) {
    Result<FrameRange> asked = read_frames(*arguments.frames, preset->film.frames);
    if (!asked) return fail(asked.errors(), kWrongInput);
    range = *asked;
  }
  Result<fs::path> root = home();
  if (!root) return fail(root.errors(), kCouldNot);
  Result<std::string> layout = read_file(*root / "templates" / "frame.pov");
  if (!layout) return fail(layout.errors(), kCouldNot);

  std::string name = fs::path(arguments.preset.path).stem();
  fs::path out = arguments.out.empty() ? fs::path("out") / name : fs::path(arguments.out);
  if (Errors errors = refuse_links(out); !errors.empty()) return fail(errors, kCouldNot);
  if (arguments.film_only) {
    Errors errors = write_jobs(*preset, range, {}, 0, *root, out, name, true);
    if (errors.empty()) errors = remove_unusable(out, range, preset->film.size);
    return errors.empty() ? kDone : fail(errors, kCouldNot);
  }
  now_doing("estimating how much there will be");
  Result<CostEstimate> estimate = estimate_cost(*preset, range.last - range.first + 1);
  Machine machine = machine_for(out);
  Errors refused = estimate ? refuse(*estimate, machine) : estimate.errors();
  for (Error& error : refused)
    error.where = arguments.preset.path + (error.where.empty() ? "" : ": " + error.where);
  if (!refused.empty()) return fail(refused, kWrongInput);

  if (!arguments.quiet) {
    Pace pace = pace_of(name);
    tell(fmt::format("estimate: {} of disk, {} of processor to render (reckoned {})",
                     bytes_text(estimate->disk()),
                     seconds_text(pace.factor * estimate->frames * estimate->render_seconds), pace.measured));
  }

  std::optional<Progress> shown;
  Watch watch{.begin =
                  [&](std::string_view phase, std::size_t steps) {
                    shown.emplace(std::string(phase), static_cast<int>(steps), arguments.quiet);
                  },
              .step = [&] { shown->step(); }};
  now_doing("growing what stands in the scene");
  Result<Scene> scene = build_scene(*preset, watch);
  shown.reset();
  if (!scene) return fail(scene.errors(), kWrongInput);
  tell_notes(preset->notes);
  for (const std::string& note : scene->notes) tell("note: " + note);
  if (!arguments.quiet)
    tell(fmt::format("grown: {} organisms, {} nodes", scene->specimens.size(), scene->nodes()));

  FolderInUse in_use(out / "frames");
  std::set<std::string> needed;
  for (const Drawing& drawing : scene->drawings) needed.insert(drawing.names.begin(), drawing.names.end());
  now_doing("drawing bark and leaves");
  if (Errors errors = write_drawings(*scene, out / "frames", watch); !errors.empty())
    return fail(errors, kCouldNot);
  now_doing("growing the models of what is sown");
  Result<CopyPlan> plan = write_models(*scene, out / "frames", watch);
  if (!plan) return fail(plan.errors(), kCouldNot);
  for (const ModelFile& file : plan->files) needed.insert(file.name);
  needed.insert(plan->summaries.begin(), plan->summaries.end());
  shown.reset();
  now_doing("writing frames");
  Written written = write_frames(*scene, std::move(*plan), *layout, out, range, estimate->at_once(machine),
                                 arguments.quiet);
  if (!written.errors.empty()) return fail(written.errors, kCouldNot);
  Errors job_errors =
      write_jobs(*preset, range, written.nodes, estimate->render_seconds, *root, out, name, false);
  if (!job_errors.empty()) return fail(job_errors, kCouldNot);
  job_errors = remove_unusable(out, range, preset->film.size);
  if (!job_errors.empty()) return fail(job_errors, kCouldNot);
  needed.merge(written.beside);
  if (in_use.by_us_alone()) tidy(out, needed, exposures(preset->film, preset->stage.camera));
  if (!arguments.quiet)
    tell(fmt::format("{}: {} frames, {} of them changed", out.string(), range.last - range.first + 1,
                     written.frames));
  return kDone;
}

}  // namespace frond
