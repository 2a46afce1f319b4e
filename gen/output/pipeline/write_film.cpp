#include "pipeline/write_film.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <set>
#include <span>

#include "core/content.h"
#include "core/figures.h"
#include "core/files.h"
#include "core/machine.h"
#include "core/parallel.h"
#include "core/version.h"
#include "film/film_files.h"
#include "pipeline/out_folder.h"
#include "pipeline/pace.h"
#include "resolve/resolve.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

/// The frames that are written: where they are resolved, those around them, too.
FrameRange drawn_range(const FilmFolder& film) {
  return film.alone ? film.range : drawn_frames(film.preset.film, film.range);
}

struct Written {
  int frames = 0;  // that changed on disk
  Errors errors;
  std::set<std::string> beside;    // what frames include
  std::vector<std::size_t> nodes;  // that each shows
};

/// Writes the frames of a run, up to `at_once` at a time.
Written write_frames(const FilmFolder& film, const Scene& scene, CopyPlan plan, const std::string& layout,
                     int at_once, RunEvents& events) {
  fs::path folder = film.out / "frames";
  FrameParts parts = prepare_frames(scene, std::move(plan));
  std::set<std::string> beside;
  for (const Picture& file : parts.files) beside.insert(file.name);
  if (Errors lost = write_pictures(folder, parts.files); !lost.empty()) return {0, lost, {}, {}};
  if (Errors lost = write_light(scene, parts, folder); !lost.empty()) return {0, lost, {}, {}};
  if (!parts.light.empty()) beside.insert(parts.light);
  int each = exposures(scene.film, scene.setup.camera), count = drawn_range(film).count() * each;
  events.begin("frames", static_cast<std::size_t>(count));
  std::atomic<int> next = 0;
  std::vector<Errors> errors(static_cast<std::size_t>(count));
  std::vector<char> changed(errors.size());
  std::vector<std::size_t> nodes(static_cast<std::size_t>(count / each));
  parallel_for(static_cast<std::size_t>(std::min(at_once, count)), [&](std::size_t) {
    for (int i; (i = next++) < count && !events.cancelled();) {
      int frame = drawn_range(film).first + i / each, exposure = each > 1 ? 1 + i % each : 0;
      Result<FrameFile> written = write_frame_file(scene, parts, layout, folder, frame, exposure);
      if (written) {
        changed[static_cast<std::size_t>(i)] = written->changed;
        if (i % each == 0) nodes[static_cast<std::size_t>(i / each)] = written->nodes;
      } else {
        errors[static_cast<std::size_t>(i)] = written.errors();
      }
      events.step();
    }
  });
  events.end();
  Written result{0, {}, std::move(beside), std::move(nodes)};
  for (auto i = changed.begin(); i != changed.end(); i += each)
    result.frames += std::any_of(i, i + each, [](char one) { return one != 0; });
  for (const Errors& list : errors) result.errors.insert(result.errors.end(), list.begin(), list.end());
  return result;
}

/// Writes build.ninja and manifest.json for the frames of a run; `nodes` of each, where that is known.
/// `rendered`: the pictures come from elsewhere.
Errors write_jobs(const FilmFolder& film, const std::vector<std::size_t>& nodes, double render_seconds,
                  bool rendered) {
  const Preset& preset = film.preset;
  const Film& shot = preset.film;
  JobList jobs;
  jobs.size = shot.drawn_size();
  jobs.quality = kRenderings[static_cast<std::size_t>(shot.quality)].quality;
  FrameRange drawn = drawn_range(film);
  if (shot.raw) {
    for (int frame = drawn.first; frame <= drawn.last; ++frame) jobs.raws.push_back(frame);
    jobs.window = ResolveOptions{}.window;
    jobs.resolve = film.resolve;
  }
  jobs.lens = preset.setup.camera.aperture.has_value();
  jobs.exposures = exposures(shot, preset.setup.camera);
  jobs.fps = shot.fps;
  jobs.still = shot.frames == 1;
  jobs.transparent = shot.transparent();
  jobs.dpi = shot.dpi;
  jobs.rendered = rendered;
  jobs.title = preset.title;
  jobs.seed = preset.seed;
  jobs.povinc = path_from(film.out, film.home / "povinc").string();
  jobs.program = path_from(film.out, film.program).string();
  for (const fs::path& file : files_in(film.home / "povinc"))
    if (file.extension() == ".inc") jobs.includes.push_back(file.filename());
  if (jobs.includes.empty())
    return {{(film.home / "povinc").string(), "holds no .inc files; set FROND_HOME to the folder of Frond"}};

  Manifest manifest;
  manifest.version = version();
  manifest.preset = film.file.stem().string();
  manifest.title = preset.title;
  manifest.preset_hash = content_id(preset.text);
  manifest.seed = preset.seed;
  manifest.fps = shot.fps;
  manifest.size = shot.size;
  manifest.quality = jobs.quality;
  manifest.still = jobs.still;
  manifest.transparent = jobs.transparent;
  manifest.render_seconds = render_seconds;
  if (shot.raw) manifest.raw = {drawn.first, drawn.last};
  manifest.budgets = film.budgets;
  for (int frame = film.range.first; frame <= film.range.last; ++frame) {
    jobs.frames.push_back(frame);
    auto i = static_cast<std::size_t>(frame - drawn.first);
    manifest.frames.push_back({frame, shot.time(frame), i < nodes.size() ? nodes[i] : 0});
  }
  Errors errors;
  auto write = [&](const char* file, const std::string& text) {
    Result<bool> written = write_file(film.out / file, text);
    if (!written) errors = written.errors();
  };
  write("manifest.json", manifest_text(manifest));
  write("build.ninja", ninja_text(jobs));
  return errors;
}

/// Removes pictures that cannot be used, and tells of those that are damaged.
Errors remove_unusable(const FilmFolder& film, RunEvents& events) {
  Result<std::vector<fs::path>> damaged = remove_damaged(film.out, drawn_range(film), film.preset.film);
  if (!damaged) return damaged.errors();
  for (const fs::path& picture : *damaged)
    events.note(fmt::format("note: {} is damaged; it is made again", picture.string()));
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

/// What a run will cost, which the machine bears.
Result<CostEstimate> borne_cost(const FilmFolder& film, const Machine& machine, RunEvents& events) {
  events.doing("estimating how much there will be");
  Result<CostEstimate> estimate = estimate_cost(film.preset, drawn_range(film));
  Errors refused = estimate ? refuse(*estimate, machine) : estimate.errors();
  for (Error& error : refused)
    error.where = film.file.string() + (error.where.empty() ? "" : ": " + error.where);
  if (!refused.empty()) return refused;
  Pace pace = pace_of(pace_key(film.file));
  events.report(fmt::format(
      "estimate: {} of disk, {} of processor to render (reckoned {})", bytes_text(estimate->disk()),
      seconds_text(pace.factor * estimate->frames * estimate->render_seconds), pace.measured));
  return estimate;
}

Result<Scene> grow_scene(const FilmFolder& film, RunEvents& events) {
  events.doing("growing what stands in the scene");
  Result<Scene> scene = build_scene(film.preset, sink_of(events));
  events.end();
  if (!scene) return scene;
  constexpr std::size_t kMostNotes = 100;
  const Errors& notes = film.preset.notes;
  for (const Error& note : std::span(notes).first(std::min(notes.size(), kMostNotes)))
    events.note("note: " + note.text());
  if (notes.size() > kMostNotes) events.note(fmt::format("note: and {} more", notes.size() - kMostNotes));
  for (const std::string& note : scene->notes) events.note("note: " + note);
  events.report(fmt::format("grown: {} organisms, {} nodes", scene->specimens.size(), scene->nodes()));
  return scene;
}

/// Writes the frames, what they include and what renders them, up to `at_once` at a time; what earlier runs
/// have left that nothing needs is removed.
Errors write_scene(const FilmFolder& film, const Scene& scene, const std::string& layout,
                   double render_seconds, int at_once, RunEvents& events) {
  fs::path folder = film.out / "frames";
  FolderInUse in_use(folder);
  std::set<std::string> needed;
  for (const Drawing& drawing : scene.drawings) needed.insert(drawing.names.begin(), drawing.names.end());
  ProgressSink watch = sink_of(events);
  events.doing("drawing bark and leaves");
  if (Errors errors = write_drawings(scene, folder, watch); !errors.empty()) return errors;
  events.doing("growing the models of what is sown");
  Result<CopyPlan> plan = write_models(scene, folder, watch);
  if (!plan) return plan.errors();
  for (const ModelFile& file : plan->files) needed.insert(file.name);
  needed.insert(plan->summaries.begin(), plan->summaries.end());
  events.end();
  events.doing("writing frames");
  Written written = write_frames(film, scene, std::move(*plan), layout, at_once, events);
  if (events.cancelled()) return {};
  if (!written.errors.empty()) return written.errors;
  if (Errors errors = write_jobs(film, written.nodes, render_seconds, false); !errors.empty()) return errors;
  if (Errors errors = remove_unusable(film, events); !errors.empty()) return errors;
  needed.merge(written.beside);
  if (in_use.by_us_alone()) tidy(film.out, needed, exposures(film.preset.film, film.preset.setup.camera));
  events.report(fmt::format("{}: {} frames, {} of them changed", film.out.string(), drawn_range(film).count(),
                            written.frames));
  return {};
}

/// What stands in the way of writing there.
Errors refuse_place(const fs::path& out) {
  Errors errors = refuse_folder(out);
  return errors.empty() ? refuse_links(out) : errors;
}

}  // namespace

ProgressSink sink_of(RunEvents& events) {
  return {.begin =
              [&events](std::string_view phase, std::size_t steps) {
                events.end();
                events.begin(phase, steps);
              },
          .step = [&events] { events.step(); },
          .cancelled = [&events] { return events.cancelled(); }};
}

Outcome write_film(const FilmFolder& film, RunEvents& events) {
  Result<std::string> layout = read_file(film.home / "templates" / "frame.pov");
  if (!layout) return {layout.errors()};
  if (Errors errors = refuse_place(film.out); !errors.empty()) return {errors};
  Machine machine = machine_for(film.out);
  Result<CostEstimate> cost = borne_cost(film, machine, events);
  if (!cost) return {cost.errors(), true};
  Result<Scene> scene = grow_scene(film, events);
  if (events.cancelled()) return {{}, false, true};
  if (!scene) return {scene.errors(), true};
  Errors errors = write_scene(film, *scene, *layout, cost->render_seconds, cost->at_once(machine), events);
  return {std::move(errors), false, events.cancelled()};
}

Outcome write_film_only(const FilmFolder& film, RunEvents& events) {
  Errors errors = refuse_place(film.out);
  if (errors.empty()) errors = write_jobs(film, {}, 0, true);
  if (errors.empty()) errors = remove_unusable(film, events);
  return {std::move(errors)};
}

}  // namespace frond
