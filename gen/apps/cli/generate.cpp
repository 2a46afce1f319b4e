#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <optional>
#include <set>
#include <span>

#include "cli/budgets.h"
#include "cli/commands.h"
#include "cli/heartbeat.h"
#include "cli/inputs.h"
#include "cli/judge.h"
#include "cli/out_folder.h"
#include "cli/pace.h"
#include "cli/progress.h"
#include "cli/rendering.h"
#include "cli/streams.h"
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
#include "resolve/resolve.h"
#include "scene/scene.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

/// What a run is asked for, read and checked.
struct Run {
  const GenerateArguments& arguments;
  const Preset& preset;
  FrameRange range;
  fs::path root{}, out{};  // of Frond, and where to write
  std::string name{};      // of the preset
  std::vector<Manifest::Budget> budgets{};

  FrameRange drawn() const { return arguments.alone ? range : drawn_frames(preset.film, range); }
  int frames() const { return drawn().last - drawn().first + 1; }
};

struct Written {
  int frames = 0;  // that changed on disk
  Errors errors;
  std::set<std::string> beside;    // what frames include
  std::vector<std::size_t> nodes;  // that each shows
};

/// Writes the frames of a run, up to `at_once` at a time.
Written write_frames(const Run& run, const Scene& scene, CopyPlan plan, const std::string& layout,
                     int at_once) {
  fs::path folder = run.out / "frames";
  FrameParts parts = prepare_frames(scene, std::move(plan));
  std::set<std::string> beside;
  for (const Picture& file : parts.files) {
    beside.insert(file.name);
    Result<bool> written = write_file(folder / file.name, file.bytes);
    if (!written) return {0, written.errors(), {}, {}};
  }
  if (Errors lost = write_light(scene, parts, folder); !lost.empty()) return {0, lost, {}, {}};
  if (!parts.light.empty()) beside.insert(parts.light);
  int each = exposures(scene.film, scene.stage.camera), count = run.frames() * each;
  Progress progress("frames", count, run.arguments.quiet);
  std::atomic<int> next = 0;
  std::vector<Errors> errors(static_cast<std::size_t>(count));
  std::vector<char> changed(errors.size());
  std::vector<std::size_t> nodes(static_cast<std::size_t>(count / each));
  parallel_for(static_cast<std::size_t>(std::min(at_once, count)), [&](std::size_t) {
    for (int i; (i = next++) < count;) {
      int frame = run.drawn().first + i / each, exposure = each > 1 ? 1 + i % each : 0;
      Result<FrameFile> written = write_frame_file(scene, parts, layout, folder, frame, exposure);
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

/// What says to `frond resolve` in the folder of the film what it is of.
std::vector<std::string> resolve_words(const Run& run) {
  std::error_code error;
  PresetArguments preset = run.arguments.preset;
  preset.path = fs::relative(preset.path, run.out, error).string();
  if (preset.assets) preset.assets = fs::relative(*preset.assets, run.out, error).string();
  std::vector<std::string> words;
  add_words(words, preset);
  words.insert(words.end(), {"--film=.", "--quiet"});  // ninja would show what is told only afterwards
  return words;
}

/// Writes build.ninja and manifest.json for the frames of a run; `nodes` of each, where that is known.
/// `rendered`: the pictures come from elsewhere.
Errors write_jobs(const Run& run, const std::vector<std::size_t>& nodes, double render_seconds,
                  bool rendered) {
  const Preset& preset = run.preset;
  const Film& film = preset.film;
  JobList jobs;
  jobs.size = film.drawn_size();
  jobs.quality = kRenderings[static_cast<std::size_t>(film.quality)].quality;
  FrameRange drawn = run.drawn();
  if (film.raw) {
    for (int frame = drawn.first; frame <= drawn.last; ++frame) jobs.raws.push_back(frame);
    jobs.window = ResolveOptions{}.window;
    jobs.resolve = resolve_words(run);
  }
  jobs.lens = preset.stage.camera.aperture.has_value();
  jobs.exposures = exposures(film, preset.stage.camera);
  jobs.fps = film.fps;
  jobs.still = film.frames == 1;
  jobs.transparent = film.transparent();
  jobs.dpi = film.dpi;
  jobs.rendered = rendered;
  jobs.title = preset.title;
  jobs.seed = preset.seed;
  std::error_code error;
  jobs.povinc = fs::relative(run.root / "povinc", run.out, error).string();
  jobs.program = fs::relative(own_program(), run.out, error).string();
  for (const fs::path& file : files_in(run.root / "povinc"))
    if (file.extension() == ".inc") jobs.includes.push_back(file.filename());
  if (error || jobs.includes.empty())
    return {{(run.root / "povinc").string(), "holds no .inc files; set FROND_HOME to the folder of Frond"}};

  Manifest manifest;
  manifest.version = FROND_VERSION;
  manifest.preset = run.name;
  manifest.title = preset.title;
  manifest.preset_hash = content_id(preset.text);
  manifest.seed = preset.seed;
  manifest.fps = film.fps;
  manifest.size = film.size;
  manifest.quality = jobs.quality;
  manifest.still = jobs.still;
  manifest.transparent = jobs.transparent;
  manifest.render_seconds = render_seconds;
  if (film.raw) manifest.raw = {drawn.first, drawn.last};
  manifest.budgets = run.budgets;
  for (int frame = run.range.first; frame <= run.range.last; ++frame) {
    jobs.frames.push_back(frame);
    auto i = static_cast<std::size_t>(frame - drawn.first);
    manifest.frames.push_back({frame, film.time(frame), i < nodes.size() ? nodes[i] : 0});
  }
  Errors errors;
  auto write = [&](const char* file, const std::string& text) {
    Result<bool> written = write_file(run.out / file, text);
    if (!written) errors = written.errors();
  };
  write("manifest.json", manifest_text(manifest));
  write("build.ninja", ninja_text(jobs));
  return errors;
}

/// Removes pictures that cannot be used, and tells of those that are damaged.
Errors remove_unusable(const Run& run) {
  Result<std::vector<fs::path>> damaged = remove_damaged(run.out, run.drawn(), run.preset.film);
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

/// What a run will cost, which the machine bears.
Result<CostEstimate> borne_cost(const Run& run, const Machine& machine) {
  now_doing("estimating how much there will be");
  Result<CostEstimate> estimate = estimate_cost(run.preset, {run.drawn().first, run.drawn().last});
  Errors refused = estimate ? refuse(*estimate, machine) : estimate.errors();
  for (Error& error : refused)
    error.where = run.arguments.preset.path + (error.where.empty() ? "" : ": " + error.where);
  if (!refused.empty()) return refused;
  if (!run.arguments.quiet) {
    Pace pace = pace_of(pace_key(run.arguments.preset.path));
    tell(fmt::format("estimate: {} of disk, {} of processor to render (reckoned {})",
                     bytes_text(estimate->disk()),
                     seconds_text(pace.factor * estimate->frames * estimate->render_seconds), pace.measured));
  }
  return estimate;
}

/// Shows how far each phase is.
ProgressSink watch_by(std::optional<Progress>& shown, bool quiet) {
  return {.begin =
              [&shown, quiet](std::string_view phase, std::size_t steps) {
                shown.emplace(std::string(phase), static_cast<int>(steps), quiet);
              },
          .step = [&shown] { shown->step(); }};
}

Result<Scene> grow_scene(const Run& run) {
  std::optional<Progress> shown;
  now_doing("growing what stands in the scene");
  Result<Scene> scene = build_scene(run.preset, watch_by(shown, run.arguments.quiet));
  shown.reset();
  if (!scene) return scene;
  tell_notes(run.preset.notes);
  for (const std::string& note : scene->notes) tell("note: " + note);
  if (!run.arguments.quiet)
    tell(fmt::format("grown: {} organisms, {} nodes", scene->specimens.size(), scene->nodes()));
  return scene;
}

/// Writes the frames, what they include and what renders them, up to `at_once` at a time; what earlier runs
/// have left that nothing needs is removed.
Errors write_film(const Run& run, const Scene& scene, const std::string& layout, double render_seconds,
                  int at_once) {
  fs::path folder = run.out / "frames";
  FolderInUse in_use(folder);
  std::set<std::string> needed;
  for (const Drawing& drawing : scene.drawings) needed.insert(drawing.names.begin(), drawing.names.end());
  std::optional<Progress> shown;
  ProgressSink watch = watch_by(shown, run.arguments.quiet);
  now_doing("drawing bark and leaves");
  if (Errors errors = write_drawings(scene, folder, watch); !errors.empty()) return errors;
  now_doing("growing the models of what is sown");
  Result<CopyPlan> plan = write_models(scene, folder, watch);
  if (!plan) return plan.errors();
  for (const ModelFile& file : plan->files) needed.insert(file.name);
  needed.insert(plan->summaries.begin(), plan->summaries.end());
  shown.reset();
  now_doing("writing frames");
  Written written = write_frames(run, scene, std::move(*plan), layout, at_once);
  if (!written.errors.empty()) return written.errors;
  if (Errors errors = write_jobs(run, written.nodes, render_seconds, false); !errors.empty()) return errors;
  if (Errors errors = remove_unusable(run); !errors.empty()) return errors;
  needed.merge(written.beside);
  if (in_use.by_us_alone()) tidy(run.out, needed, exposures(run.preset.film, run.preset.stage.camera));
  if (!run.arguments.quiet)
    tell(fmt::format("{}: {} frames, {} of them changed", run.out.string(), run.frames(), written.frames));
  return {};
}

/// Reads the preset; budgets of growth that it gives in seconds become numbers of internodes, which are told
/// and set from then on.
Result<Preset> load_counted(PresetArguments& arguments, const fs::path& out,
                            std::vector<Manifest::Budget>& budgets) {
  Result<Preset> preset = load_preset(arguments);
  if (!preset) return preset;
  Result<std::vector<Manifest::Budget>> counted = counted_budgets(arguments, *preset, out);
  if (!counted) return counted.errors();
  budgets = std::move(*counted);
  for (const Manifest::Budget& budget : budgets) {
    tell(fmt::format(
        "note: {}: {:g} s are counted as {} internodes; \"internodes\": {} in the preset gives the "
        "same trees in any folder",
        budget.pointer, budget.seconds, budget.internodes, budget.internodes));
    arguments.sets.push_back(set_of(budget));
  }
  return budgets.empty() ? preset : load_preset(arguments);
}

}  // namespace

int generate(GenerateArguments arguments) {
  limit_threads(arguments.threads);
  Heartbeat heartbeat(arguments.quiet);
  std::string name = fs::path(arguments.preset.path).stem();
  fs::path out = arguments.out.empty() ? fs::path("out") / name : fs::path(arguments.out);
  std::vector<Manifest::Budget> budgets;
  Result<Preset> preset = load_counted(arguments.preset, out, budgets);
  if (!preset) return fail(preset.errors(), kWrongInput);
  if (Errors errors = refuse_resolving(preset->film, arguments.resolve); !errors.empty())
    return fail(errors, kWrongInput);
  preset->film.raw = is_resolved(preset->film, arguments.resolve);
  Result<FrameRange> range = read_frames(arguments.frames, preset->film.frames, {1, preset->film.frames});
  if (!range) return fail(range.errors(), kWrongInput);
  Run run{arguments, *preset, *range, {}, out, name, budgets};
  Result<fs::path> root = home();
  if (!root) return fail(root.errors(), kCouldNot);
  run.root = *root;
  Result<std::string> layout = read_file(run.root / "templates" / "frame.pov");
  if (!layout) return fail(layout.errors(), kCouldNot);
  if (Errors errors = refuse_folder(run.out); !errors.empty()) return fail(errors, kCouldNot);
  if (Errors errors = refuse_links(run.out); !errors.empty()) return fail(errors, kCouldNot);

  Errors errors;
  if (arguments.film_only) {
    errors = write_jobs(run, {}, 0, true);
    if (errors.empty()) errors = remove_unusable(run);
  } else {
    Machine machine = machine_for(run.out);
    Result<CostEstimate> cost = borne_cost(run, machine);
    if (!cost) return fail(cost.errors(), kWrongInput);
    Result<Scene> scene = grow_scene(run);
    if (!scene) return fail(scene.errors(), kWrongInput);
    errors = write_film(run, *scene, *layout, cost->render_seconds, cost->at_once(machine));
  }
  return errors.empty() ? kDone : fail(errors, kCouldNot);
}

}  // namespace frond
