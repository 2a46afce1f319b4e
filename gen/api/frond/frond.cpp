#include "frond/frond.h"

#include <fmt/format.h>

#include <cmath>

#include "core/files.h"
#include "core/home.h"
#include "core/parallel.h"
#include "core/work_folder.h"
#include "export/formats.h"
#include "grammar/figure.h"
#include "grammar/picture.h"
#include "grammar/review.h"
#include "organisms/grammar_file.h"
#include "passes/frame_passes.h"
#include "pipeline/pass_picture.h"
#include "pipeline/render_film.h"
#include "preset/json.h"
#include "preview/quick_look.h"
#include "render/process.h"
#include "scene/named_files.h"
#include "scene/scene.h"

namespace frond::api {

namespace fs = std::filesystem;

namespace {

std::vector<Message> messages_of(const Errors& errors) {
  std::vector<Message> messages;
  for (const Error& error : errors) messages.push_back({error.where, error.what});
  return messages;
}

std::string lines_of(const std::vector<Message>& messages) {
  std::string lines;
  for (const Message& message : messages)
    lines += (lines.empty() ? "" : "\n") + Error{message.where, message.what}.text();
  return lines;
}

/// The value, or all that is wrong as a Failure.
template <class T>
T or_throw(Result<T> result, bool of_input = true) {
  if (!result) throw Failure(messages_of(result.errors()), of_input);
  return std::move(*result);
}

/// A Listener as what a run tells, and as what stops it.
class Ears final : public RunEvents, public Stop {
 public:
  explicit Ears(Listener* listener) : listener_(listener ? *listener : nobody_) {}

  void note(std::string_view line) override { listener_.note(line); }
  void report(std::string_view line) override { note(line); }
  void begin(std::string_view phase, std::size_t steps) override { listener_.begin(phase, steps); }
  void step() override { listener_.step(); }
  void rendered(const RenderedSoFar& frames) override {
    listener_.rendered(frames.done, frames.all, frames.words);
  }
  bool cancelled() override { return listener_.cancelled(); }
  bool asked() override { return cancelled(); }

 private:
  Listener nobody_;
  Listener& listener_;
};

void throw_unless_well(const Outcome& outcome) {
  if (outcome.stopped) throw Cancelled();
  if (!outcome.well()) throw Failure(messages_of(outcome.errors), outcome.of_the_preset);
}

}  // namespace

Failure::Failure(std::vector<Message> messages, bool of_input)
    : std::runtime_error(lines_of(messages)), messages_(std::move(messages)), of_input_(of_input) {}

void set_home(const fs::path& folder) { set_home_folder(folder); }

std::string schema() { return serialize_pretty(preset_schema()); }

// Presets

struct Preset::Data {
  std::string source;  // its text as it was given
  fs::path file;
  bool on_disk = false;  // the file holds that text
  std::optional<fs::path> assets;
  std::vector<std::string> sets;  // as `--set` has them
  frond::Preset preset;

  Result<frond::Preset> read(const std::vector<std::string>& with) const {
    return read_preset(source, file.string(), with, assets);
  }
};

namespace {

std::unique_ptr<Preset::Data> data_of(std::string text, const fs::path& file, bool on_disk,
                                      const std::optional<fs::path>& assets) {
  auto data = std::make_unique<Preset::Data>(Preset::Data{std::move(text), file, on_disk, assets, {}, {}});
  data->preset = or_throw(data->read({}));
  return data;
}

}  // namespace

Preset::Preset(std::unique_ptr<Data> data) : data_(std::move(data)) {}
Preset::Preset(const Preset& other) : data_(std::make_unique<Data>(*other.data_)) {}
Preset::Preset(Preset&&) noexcept = default;
Preset& Preset::operator=(Preset other) {
  data_.swap(other.data_);
  return *this;
}
Preset::~Preset() = default;

Preset Preset::read(const fs::path& file, const std::optional<fs::path>& assets) {
  std::optional<fs::path> shipped;
  if (!path_exists(file)) shipped = shipped_by_name(file.string());
  fs::path found = shipped.value_or(file);
  return Preset(data_of(or_throw(read_file(found)), found, true, assets));
}

Preset Preset::parse(std::string text, const fs::path& file, const std::optional<fs::path>& assets) {
  return Preset(data_of(std::move(text), file, false, assets));
}

void Preset::set(const std::string& pointer, const std::string& json) {
  std::vector<std::string> sets = data_->sets;
  sets.push_back(pointer + "=" + json);
  data_->preset = or_throw(data_->read(sets));
  data_->sets = std::move(sets);
}

std::string Preset::text() const { return data_->preset.text; }
const fs::path& Preset::file() const { return data_->file; }
std::string Preset::title() const { return data_->preset.title; }
std::uint64_t Preset::seed() const { return data_->preset.seed; }
int Preset::frames() const { return data_->preset.film.frames; }
double Preset::frames_a_second() const { return data_->preset.film.fps; }
std::array<int, 2> Preset::size() const { return data_->preset.film.size; }
std::vector<Message> Preset::notes() const { return messages_of(data_->preset.notes); }

// Scenes

struct Scene::Data {
  frond::Scene scene;

  int frame(std::optional<int> asked) const {
    int last = scene.film.frames, number = asked.value_or(last);
    if (number < 1 || number > last)
      throw Failure({{"", fmt::format("{} is no frame of this film; expected 1-{}", number, last)}}, true);
    return number;
  }
  double time(std::optional<int> asked) const { return scene.film.time(frame(asked)); }
};

Scene grow(const Preset& preset, Listener* listener) {
  Ears ears(listener);
  Result<frond::Scene> scene = build_scene(preset.data().preset, sink_of(ears));
  if (ears.cancelled()) throw Cancelled();
  return Scene(std::make_shared<Scene::Data>(Scene::Data{or_throw(std::move(scene))}));
}

std::vector<Organism> Scene::organisms() const {
  std::vector<Organism> organisms;
  for (const Specimen& specimen : data_->scene.specimens) {
    Vec3 foot = specimen.placement.foot;
    organisms.push_back({specimen.name, specimen.model.skeleton.size(), {foot.x, foot.y, foot.z}});
  }
  return organisms;
}

std::size_t Scene::nodes() const { return data_->scene.nodes(); }

std::vector<std::string> Scene::notes() const { return data_->scene.notes; }

std::string Scene::look(std::optional<int> frame) const {
  return or_throw(png_text(quick_look(data_->scene, data_->time(frame))));
}

std::string Scene::passes(std::optional<int> frame, int side) const {
  if (side < 1 || side > 16) throw Failure({{"", "side: expected 1 to 16"}}, true);
  int number = data_->frame(frame);
  WorkFolder models;
  TracedFilm film = or_throw(traced_film(data_->scene, models.path()), false);
  return or_throw(pass_picture(data_->scene, or_throw(frame_passes(data_->scene, film, number, side))));
}

void Scene::export_to(const fs::path& file, const ExportOptions& options) const {
  auto within = [](double value, double low, double high) { return value >= low && value <= high; };
  if (!within(options.detail, 100, 1e9) || !within(options.sides, 3, 256) ||
      !within(options.texture, 0, 4096) || !within(options.levels, 1, 6) || !(options.voxel >= 0))
    throw Failure({{"", "export: an option is out of its range, see frond.h"}}, true);
  frond::ExportOptions how{.sides = options.sides,
                           .voxel = options.voxel,
                           .detail = options.detail,
                           .texture = options.texture,
                           .instances = options.instances,
                           .levels = options.levels};
  how.bake = {.home = home_folder(), .cache = cache_folder() / "materials"};
  or_throw(write_scene(*or_throw(format_of(file)), data_->scene, data_->time(options.frame), how, file,
                       [](const ExportTold&) {}));
}

// Films

namespace {

/// The words that say to `frond resolve` in a folder which preset it is. One without a file of its own is
/// written there.
std::vector<std::string> resolve_words(const Preset& preset, const std::vector<std::string>& sets,
                                       const fs::path& out) {
  const Preset::Data& data = preset.data();
  fs::path file = out / "preset.json";
  if (data.on_disk) {
    file = data.file;
  } else {
    std::string text = or_throw(with_whole_paths(data.source, data.file.parent_path()));
    or_throw(write_file(file, text), false);
  }
  std::vector<std::string> words{path_from(out, file).string(), "--film=.", "--quiet"};
  if (words[0].starts_with('-')) words[0].insert(0, "./");
  for (const std::string& set : sets) words.push_back("--set=" + set);
  if (data.assets) words.push_back("--assets=" + path_from(out, *data.assets).string());
  return words;
}

/// The program that build.ninja calls.
fs::path program_of(const RenderOptions& options) {
  std::error_code error;
  for (const fs::path& place :
       {options.program, fs::path(environment_or("FROND_BIN", "")), home_folder() / "build" / "frond",
        home_folder().parent_path().parent_path() / "bin" / "frond"})
    if (!place.empty() && fs::exists(place, error)) return fs::absolute(place, error);
  if (std::optional<fs::path> found = find_program("frond")) return *found;
  throw Failure({{"", "the program frond was not found; set FROND_BIN to it"}}, false);
}

/// Calls `then` with the folder of a film, its preset counted and its frames chosen.
template <class Then>
auto with_folder(const Preset& preset, const fs::path& out, const RenderOptions& options, Ears& ears,
                 const Then& then) {
  const Preset::Data& data = preset.data();
  frond::Preset read = data.preset;
  std::vector<std::string> sets = data.sets;
  auto again = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all = data.sets;
    all.insert(all.end(), more.begin(), more.end());
    return data.read(all);
  };
  std::vector<Manifest::Budget> budgets = or_throw(count_budgets(read, again, out, ears));
  for (const Manifest::Budget& budget : budgets) sets.push_back(set_of(budget));
  if (Errors errors = refuse_resolving(read.film, options.resolve); !errors.empty())
    throw Failure(messages_of(errors), true);
  read.film.raw = is_resolved(read.film, options.resolve);
  FrameRange range{1, read.film.frames};
  if (options.frames) range = {(*options.frames)[0], (*options.frames)[1]};
  if (range.first < 1 || range.last < range.first || range.last > read.film.frames)
    throw Failure(
        {{"", fmt::format("frames {}-{}: expected some of 1-{}", range.first, range.last, read.film.frames)}},
        true);
  FilmFolder folder{read, data.file, range, home_folder(), out, program_of(options), {}, budgets};
  if (read.film.raw) folder.resolve = resolve_words(preset, sets, out);
  return then(folder);
}

}  // namespace

void write_frames(const Preset& preset, const fs::path& folder, const RenderOptions& options,
                  Listener* listener) {
  Ears ears(listener);
  throw_unless_well(with_folder(preset, folder, options, ears,
                                [&](const FilmFolder& film) { return write_film(film, ears); }));
}

std::vector<fs::path> render(const Preset& preset, const fs::path& folder, const RenderOptions& options,
                             Listener* listener) {
  if (!options.format.empty() && std::ranges::find(kFilmFormats, options.format) == std::end(kFilmFormats))
    throw Failure(
        {{"", fmt::format("format: expected mp4, webm, gif, webp or mov, not '{}'", options.format)}}, true);
  Ears ears(listener);
  RenderSettings settings{.out = folder,
                          .format = options.format,
                          .jobs = options.jobs > 0 ? options.jobs : thread_count(),
                          .every = std::max(options.every, 1),
                          .watch = options.watch};
  RenderedFilm made = with_folder(preset, folder, options, ears, [&](const FilmFolder& film) {
    return render_film(film, settings, ears, ears);
  });
  throw_unless_well(made.outcome);
  return made.results;
}

// Grammars

struct Grammar::Data {
  frond::Grammar grammar;
  fs::path file;

  [[noreturn]] void fail(const Errors& errors) const {
    throw Failure(messages_of(in_file(frond::placed(errors, grammar.text), file.string())), true);
  }
};

Grammar Grammar::read(const fs::path& file) {
  std::string text = or_throw(read_file(file));
  GrammarText read = or_throw(read_grammar(text, file.string(), Assets(file.string(), std::nullopt)));
  Result<frond::Grammar> grammar = compile(read);
  if (!grammar) throw Failure(messages_of(in_file(grammar.errors(), file.string())), true);
  return Grammar(std::make_shared<Data>(Data{std::move(*grammar), file}));
}

std::string Grammar::derive(std::optional<int> steps, std::optional<std::uint64_t> seed) const {
  const GrammarText& asked = data_->grammar.text;
  Result<Word> word =
      frond::derive(data_->grammar, steps.value_or(static_cast<int>(std::ceil(asked.growth()))),
                    Seed{seed.value_or(asked.seed)}, asked.limits);
  if (!word) data_->fail(word.errors());
  return frond::text(data_->grammar, *word);
}

std::string Grammar::svg(std::optional<double> steps, std::optional<std::uint64_t> seed) const {
  const GrammarText& asked = data_->grammar.text;
  Result<std::string> svg = turtle_svg(data_->grammar, steps.value_or(asked.growth()),
                                       Seed{seed.value_or(asked.seed)}, asked.limits);
  if (!svg) data_->fail(svg.errors());
  return *svg;
}

}  // namespace frond::api
