#include "studio/scenes.h"

#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/cancellation.h"
#include "core/content.h"
#include "core/machine.h"
#include "estimate/estimate_cost.h"
#include "export/materials.h"
#include "grammar/forecast.h"
#include "grammar/picture.h"
#include "grammar/review.h"
#include "images/raster.h"
#include "model/bytes.h"
#include "preview/quick_look.h"
#include "scene/describe.h"
#include "studio/answers.h"

namespace frond {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kSessions = 64;    // tabs
constexpr std::size_t kKnown = 4096;     // organisms
constexpr std::size_t kDrawings = 4096;  // that are remembered by how they are drawn
constexpr std::size_t kDrawing = 4096;   // bytes of that, about
constexpr int kLookWide = 360;           // pixels, of a card's picture
constexpr int kMomentWide = 160;         // pixels, of a moment of a film
constexpr double kLongestLook = 8;       // seconds of growing for that
constexpr std::size_t kWorthTidying = std::size_t{128} << 20;
constexpr std::size_t kShownWord = 4000;  // characters
constexpr double kLongestWord = 3e6;      // modules
constexpr std::int64_t kMostSteps = 1'000'000;
constexpr double kMostLines = 3e4;          // of a drawing of the turtle
constexpr std::size_t kLargestTree = 2000;  // modules, see derivation_tree_svg()

/// The size of a picture of a film's shape that is so many pixels wide.
std::array<int, 2> look_size(const Film& film, int wide) {
  return {wide, std::clamp(static_cast<int>(std::lround(wide * film.aspect())), 16, 2 * wide)};
}

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// An overtaken question is no fault: browsers would tell of it on their consoles.
Answer stale() { return {202, {{"stale", true}}}; }

/// All that an organism grows from, but for its place.
std::string name_of(const Preset& preset, std::size_t entry) {
  const Organism& o = preset.organisms[entry];
  return content_id(
      fmt::format("{} {} {} {}", preset.seed, o.count, o.grower->keys().all(), o.sown ? o.sown->models : 0));
}

/// A preset is held as a tree of values, and once more by its growers.
std::size_t bytes_of(const Preset& preset) {
  constexpr std::size_t kOfText = 40;
  return kOfText * preset.text.size();
}

/// Lets some organisms grow roughly, in about that share of the time; whether any of them can.
bool make_coarse(Preset& preset, const std::set<std::size_t>& entries, double share) {
  bool any = false;
  for (std::size_t entry : entries) {
    // A rough plant has other branches than those that edits name.
    if (entry >= preset.organisms.size() || !preset.organisms[entry].edits.empty()) continue;
    Organism& organism = preset.organisms[entry];
    std::shared_ptr<const Grower> coarse = organism.grower->coarse(share);
    if (!coarse) continue;
    organism.grower = std::move(coarse);
    any = true;
  }
  return any;
}

ViewRequest request_of(const Json& question) {
  ViewRequest request;
  request.time = time_in(question);
  if (question.contains("have"))
    for (const Json& id : question["have"])
      if (id.is_string()) request.kept.insert(id.get<std::string>());
  if (question.contains("solo") && question["solo"].is_array()) request.solo = numbers(question, "solo");
  request.hidden = numbers(question, "hide");
  return request;
}

}  // namespace

Scenes::Scenes(const Documents& documents, std::size_t memory, BakeOptions bake)
    : documents_(documents),
      bake_(std::move(bake)),
      budget_(std::make_shared<CacheBudget>(memory)),
      drawings_(kDrawings * kDrawing) {}

Scenes::Hurry Scenes::hurry_of(const Json& question) {
  if (!question.contains("only") || !question["only"].is_array()) return {};
  return {numbers(question, "only"), number_in(question, "share", 1, 0, 1)};
}

std::shared_ptr<Scenes::Session> Scenes::session(const std::string& name) {
  std::lock_guard lock(mutex_);
  if (sessions_.size() >= kSessions && !sessions_.contains(name)) sessions_.clear();
  auto& session = sessions_[name];
  if (!session) session = std::make_shared<Session>();
  return session;
}

std::shared_ptr<const Scenes::Built> Scenes::find(const std::string& key) {
  std::shared_ptr<const Built> built = built_.find(key);
  // While it is looked at, what it grew from is wanted as well: for when something in it is changed.
  if (built)
    for (const std::string& name : built->scene.cached) cache_.find(name);
  return built;
}

void Scenes::Session::ask(std::uint64_t number) {
  for (std::uint64_t now = newest; now < number && !newest.compare_exchange_weak(now, number);) {
  }
}

void Scenes::leave(const std::string& name, std::uint64_t number) { session(name)->ask(number + 1); }

Json Scenes::progress(const std::string& name) {
  std::shared_ptr<Session> tab = session(name);
  return {{"done", tab->done.load()}, {"of", tab->of.load()}};
}

Scenes::Bearable Scenes::bearable(const Json& question) {
  Bearable most;
  auto read = [&](const char* name, double& value) {
    if (question.contains(name) && question[name].is_number()) value = question[name].get<double>();
  };
  read("ask", most.seconds), read("most", most.nodes);
  return most;
}

Result<Json> Scenes::estimate(const Preset& preset, const EntryFilter& only, const Bearable& most) {
  Preset fresh = preset;
  {
    std::lock_guard lock(mutex_);
    for (std::size_t i = 0; i < fresh.organisms.size(); ++i)
      if ((only && !only->contains(i)) || known_.contains(name_of(preset, i)))
        fresh.organisms[i].count = 0, fresh.organisms[i].sown.reset();
  }
  Result<ViewCostEstimate> estimate = estimate_view_cost(fresh);
  if (!estimate) return estimate.errors();
  Machine machine = this_machine(".");
  if (Errors errors = refuse(*estimate, machine); !errors.empty()) return errors;
  double wait = estimate->wait(machine.threads);
  if (wait <= most.seconds && estimate->nodes <= most.nodes) return Json(nullptr);
  return Json{{"nodes", estimate->nodes}, {"seconds", wait}, {"memory", estimate->memory}};
}

Result<std::shared_ptr<const Scenes::Built>> Scenes::build(const std::string& key, Preset preset,
                                                           const ProgressSink& watch, const Hurry& hurry) {
  bool coarse = hurry.share < 1 && make_coarse(preset, *hurry.only, hurry.share);
  Result<Scene> scene = build_scene(preset, watch, &cache_, hurry.only);
  if (!scene) return scene.errors();
  std::optional<Drawing> sky = sky_drawing(*scene, bake_);
  std::string sky_name = sky ? sky->names[0] : "";
  if (sky) drawings_.put(sky_name, std::make_shared<const Drawing>(std::move(*sky)), kDrawing);
  auto built =
      std::make_shared<const Built>(Built{std::move(preset), std::move(*scene), std::move(sky_name), coarse});
  for (const Drawing& drawing : built->scene.drawings)
    for (const std::string& name : drawing.names)
      drawings_.put(name, std::make_shared<const Drawing>(drawing), kDrawing);
  add_tiles(built->scene);
  if (coarse || !built->scene.missing.empty()) return built;
  built_.put(key, built, built->scene.bytes() + bytes_of(built->preset));
  std::lock_guard lock(mutex_);
  if (known_.size() > kKnown) known_.clear();
  for (std::size_t i = 0; i < built->preset.organisms.size(); ++i) known_.insert(name_of(built->preset, i));
  return built;
}

void Scenes::add_tiles(const Scene& scene) {
  auto keep = [&](const std::optional<Tile>& tile, std::size_t bytes, const auto& draw) {
    if (!tile || drawings_.find(tile->colors)) return;
    auto drawing = std::make_shared<const Drawing>(draw());
    for (const std::string& name : drawing->names) drawings_.put(name, drawing, bytes);
  };
  auto add = [&](const auto& tiled, std::size_t bytes) {
    keep(tile_of(tiled), bytes, [&] { return tile_drawing(tiled, bake_); });
  };
  auto add_barks = [&](const BranchLook& look) {
    for (std::size_t k = 0; k <= look.others.size(); ++k)
      keep(tile_of(look, look.color_of(k)), kDrawing,
           [&] { return tile_drawing(look, bake_, look.color_of(k)); });
  };
  add(scene.setup, kDrawing);
  for (const Specimen& specimen : scene.specimens) {
    if (specimen.model.skeleton.size() > 1) add_barks(specimen.look.branches);
    for (const Solid& solid : specimen.model.solids.shapes)
      add(solid, kDrawing + (is_vessel(solid) ? bytes_of(solid.surface) : 0));
  }
  for (const CopySet& set : scene.copy_sets) add_barks(set.appearance.look.branches);
}

Result<std::shared_ptr<const Scene>> Scenes::scene(const Doc& doc, Preset preset,
                                                   const std::function<bool()>& cancelled) {
  std::string key = key_of(doc, preset);
  std::shared_ptr<const Built> built = find(key);
  if (!built) {
    // What the machine has no memory for is refused before it is grown.
    if (Result<Json> told = estimate(preset, {}, {}); !told) return told.errors();
    auto made = build(key, std::move(preset), {[](auto, auto) {}, [] {}, cancelled}, {});
    if (!made) return made.errors();
    built = std::move(*made);
  }
  return std::shared_ptr<const Scene>(built, &built->scene);
}

Result<std::string> Scenes::look(const std::string& file) {
  Result<Json> read = documents_.read(file);
  if (!read) return read.errors();
  std::string name = "look " + file + " " + (*read)["disk"].get<std::string>();
  if (auto found = pictures_.find(name)) return *found;
  std::lock_guard lock(looking_);
  if (auto found = pictures_.find(name)) return *found;
  Doc doc{(*read)["text"].get<std::string>(), (*read)["file"].get<std::string>()};
  Result<Preset> preset = documents_.preset(doc);
  if (!preset) return preset.errors();
  Film& film = preset->film;
  film.size = look_size(film, kLookWide);
  film.quality = Quality::draft;
  Result<CostEstimate> estimate = estimate_cost(*preset, {1, 1});
  if (!estimate) return estimate.errors();
  if (estimate->growth_seconds > kLongestLook) return Error{file, "takes long to grow"};
  auto cancelled = [this, views = views_.load()] { return ending_ || views_ != views; };
  Result<Scene> scene = build_scene(*preset, {[](auto, auto) {}, [] {}, cancelled});
  Result<std::string> png = scene ? png_text(quick_look(*scene, film.time(film.frames))) : scene.errors();
  if (png) pictures_.put(name, std::make_shared<const std::string>(*png), png->size());
  return png;
}

Result<std::string> Scenes::moment(const Doc& doc, double time) {
  Result<Preset> preset = documents_.preset(doc);
  if (!preset) return preset.errors();
  std::shared_ptr<const Built> built = find(key_of(doc, *preset));
  if (!built) return Error{doc.file.string(), "has not been grown"};
  std::lock_guard lock(looking_);
  return png_text(quick_look(built->scene, time, look_size(preset->film, kMomentWide)));
}

void Scenes::tidy() {
  tidied_at_ = sent_ + budget_->evicted();
  malloc_trim(0);
}

void Scenes::tidy_at_times(std::size_t sent) {
  sent_ += sent;
  if (sent_ + budget_->evicted() - tidied_at_ > kWorthTidying) tidy();
}

Answer Scenes::view(const Doc& doc, const Json& question, const std::string& name, std::uint64_t number) {
  std::shared_ptr<Session> tab = session(name);
  tab->ask(number);
  ++views_;
  auto cancelled = [&] { return ending_ || tab->newest > number; };
  std::lock_guard lock(tab->in_work);
  if (cancelled()) return stale();

  auto start = Clock::now();
  Result<Preset> preset = documents_.preset(doc);
  if (!preset) return wrong(preset.errors());
  Errors notes = preset->notes;
  std::string key = key_of(doc, *preset);
  std::shared_ptr<const Built> built = find(key);
  Json grown = Json::array();
  std::size_t made_bytes = 0;
  Hurry hurry = hurry_of(question);
  if (!built) {
    if (question.contains("ask") && question["ask"].is_number()) {
      Result<Json> told = estimate(*preset, hurry.only, bearable(question));
      if (!told) return wrong(told.errors(), notes);
      if (!told->is_null()) return {202, {{"estimate", *told}}};
    }
    ProgressSink watch{[&](auto, std::size_t steps) { tab->done = 0, tab->of = steps; }, [&] { ++tab->done; },
                       cancelled};
    auto made = build(key, std::move(*preset), watch, hurry);
    if (cancelled()) return stale();
    if (!made) return wrong(made.errors(), notes);
    built = *made;
    grown = built->scene.grown;
    made_bytes = built->scene.bytes();  // growing takes as much again, and more, for a while
  }
  double grow = seconds_since(start);
  Json header{{"seconds", {{"grow", grow}}}, {"regrown", grown},  {"missing", built->scene.missing},
              {"coarse", built->coarse},     {"sky", built->sky}, {"notes", Json::array()}};
  for (const Error& note : notes) header["notes"].push_back(note.text());
  for (const std::string& note : built->scene.notes) header["notes"].push_back(note);
  Result<std::string> packet = Error{"", "given up"};
  try {
    while_wanted(cancelled, [&] {
      packet = view_of(built->scene, built->preset, request_of(question), models_, std::move(header));
    });
  } catch (const Cancelled&) {
  }
  if (packet) tidy_at_times(packet->size() + made_bytes);
  if (cancelled()) return stale();
  if (!packet) return wrong(packet.errors(), notes);
  return {200, {}, std::move(*packet), "application/octet-stream"};
}

Answer Scenes::derive(const Doc& doc, const Json& question) const {
  Result<Preset> preset = documents_.preset(doc);
  if (!preset) return wrong(preset.errors());
  std::size_t entry = index_in(question, "entry", 0);
  if (entry >= preset->organisms.size()) return refused(400, "there is no such organism");
  std::optional<Result<Grammar>> grammar = preset->organisms[entry].grower->grammar();
  if (!grammar) return refused(400, "it does not grow by a grammar");
  if (!*grammar) return wrong(grammar->errors());
  const Grammar& rules = **grammar;
  bool asked = question.contains("steps") && question["steps"].is_number();
  int steps =
      asked ? static_cast<int>(whole_number(question["steps"], "steps", 0, kMostSteps)) : rules.text.steps;
  Seed seed{rules.text.seed};
  Forecast size = forecast(rules, steps, seed, rules.text.limits);
  Json answer{{"steps", steps},
              {"predicted", {{"modules", size.modules}, {"segments", size.segments}, {"bytes", size.bytes}}},
              {"word", nullptr},
              {"length", nullptr},
              {"counts", Json::object()},
              {"tree", nullptr},
              {"svg", nullptr}};
  if (Errors errors = refuse(size, rules.text.limits); !errors.empty())
    return wrong(placed(errors, rules.text));
  if (size.modules > kLongestWord) return {200, answer};
  Result<Word> word = frond::derive(rules, steps, seed, rules.text.limits);
  if (!word) return wrong(placed(word.errors(), rules.text));
  std::string whole = text(rules, *word);
  answer["length"] = word->size();
  answer["word"] = whole.substr(0, kShownWord);
  for (const auto& [symbol, count] : counts(rules, *word)) answer["counts"][symbol] = count;
  if (word->size() <= kLargestTree)
    if (Result<std::string> tree = derivation_tree_svg(rules, steps, seed)) answer["tree"] = *tree;
  if (size.segments <= kMostLines)
    if (Result<std::string> svg = turtle_svg(rules, steps, seed, rules.text.limits)) answer["svg"] = *svg;
  return {200, answer};
}

Result<std::string> Scenes::picture(const std::string& name) {
  if (auto found = pictures_.find(name)) return *found;
  std::shared_ptr<const Drawing> drawing = drawings_.find(name);
  if (!drawing) return Error{name, "no scene has named such a picture"};
  Result<std::vector<Picture>> drawn = drawing->draw();
  if (!drawn) return drawn.errors();
  std::string asked;
  for (Picture& picture : *drawn) {
    if (picture.name == name) asked = picture.bytes;
    std::size_t bytes = picture.bytes.size();
    pictures_.put(picture.name, std::make_shared<const std::string>(std::move(picture.bytes)), bytes);
  }
  return asked;
}

}  // namespace frond
