#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "cli/commands.h"
#include "cli/heartbeat.h"
#include "cli/inputs.h"
#include "cli/streams.h"
#include "core/figures.h"
#include "core/files.h"
#include "core/printable.h"
#include "draw/sizes.h"
#include "estimate/estimate_cost.h"
#include "grammar/symbols.h"
#include "organisms/kinds.h"
#include "pipeline/pace.h"
#include "preset/json.h"
#include "scene/scene.h"
#include "scene/taxon.h"
#include "settings/settings.h"

// What there is and how large it is: info, list, schema.

namespace frond {

namespace fs = std::filesystem;

namespace {

/// One thing that can be named in a preset.
struct Entry {
  std::string group, name, doc;
};

/// The title of a preset, which is read whole only where it has none of its own. Other
/// faults are for `frond check` to tell.
std::string title_of(const fs::path& file) {
  Result<std::string> text = read_file(file);
  Result<Document> document = text ? parse_json(*text, file.string()) : text.errors();
  const Value* title = document ? document->root.find("title") : nullptr;
  if (title && title->is(Value::Type::text)) return title->text;
  Result<Preset> preset = document ? read_preset(*text, file.string(), {}) : document.errors();
  return preset ? preset->title : "(has faults)";
}

/// `Rosa canina: dog rose, briar; flowers June to July`.
std::string names_text(const Taxon& taxon) {
  constexpr std::string_view kMonths[] = {"January",   "February", "March",    "April",
                                          "May",       "June",     "July",     "August",
                                          "September", "October",  "November", "December"};
  auto month = [&](float number) { return kMonths[static_cast<std::size_t>(number) - 1]; };
  std::string text = fmt::format("{}: {}", taxon.latin, fmt::join(taxon.names, ", "));
  if (taxon.flowering)
    text += fmt::format("; flowers {} to {}", month(taxon.flowering->x), month(taxon.flowering->y));
  if (taxon.fruiting)
    text += fmt::format("; fruit {} to {}", month(taxon.fruiting->x), month(taxon.fruiting->y));
  return text;
}

std::vector<Entry> entries(const fs::path& root) {
  std::vector<Entry> list;
  for (const auto& row : organism_kinds())
    list.push_back({"growers", std::string(row.name), std::string(row.doc)});
  for (const auto& row : settings())
    list.push_back({"settings", std::string(row.name), std::string(row.doc)});
  std::vector<fs::path> files = files_below(root / "presets");
  std::erase_if(
      files, [](const fs::path& file) { return file.extension() != ".json" || is_grammar(file.string()); });
  for (const fs::path& file : files) {
    list.push_back({"presets", file.lexically_relative(root).string(), title_of(file)});
  }
  for (const ShippedSpecies& one : shipped_species())
    list.push_back({"species", one.file.stem().string(), names_text(one.taxon)});
  for (const TurtleSymbol& symbol : turtle_symbols())
    list.push_back({"symbols", std::string(symbol.name), std::string(symbol.doc)});
  return list;
}

std::string sizes_json(const std::vector<GrownSize>& sizes) {
  Value list = make_list();
  for (const GrownSize& s : sizes) {
    Value one = make_object();
    one.set("name", make_text(s.name)).set("count", make_number(static_cast<double>(s.count)));
    one.set("height", make_number(s.height))
        .set("width", make_number(s.width))
        .set("stem", make_number(s.stem));
    list.items.push_back(std::move(one));
  }
  return ", \"sizes\": " + serialize(list);
}

}  // namespace

void info(const InfoArguments& to) {
  const PresetArguments& arguments = to.preset;
  if (is_grammar(arguments.path)) return info_grammar(arguments.path, arguments.assets, to.json);
  Heartbeat heartbeat;
  Preset preset = or_fail(load_preset(arguments), kWrongInput);
  tell_notes(preset.notes);
  FrameRange asked =
      or_fail(read_frames(to.frames, preset.film.frames, {1, preset.film.frames}), kWrongInput);
  int frame = or_fail(read_frame(to.frame, preset.film.frames), kWrongInput);
  bool json = to.json, sizes = to.sizes || to.frame > 0;
  preset.film.raw = is_resolved(preset.film, std::nullopt);
  FrameRange range = drawn_frames(preset.film, asked);
  now_doing("estimating how much there will be");
  const CostEstimate f = or_fail(estimate_cost(preset, {range.first, range.last}), kWrongInput);
  Machine machine = this_machine(".");
  double memory = f.memory(f.at_once(machine));
  std::vector<GrownSize> grown;
  if (sizes) {
    now_doing("growing what stands in the scene");
    Scene scene = or_fail(build_scene(preset), kWrongInput);
    grown = or_fail(sizes_of(scene, preset, preset.film.time(frame)), kCouldNot);
  }
  Pace pace = pace_of(pace_key(arguments.path));
  double render = pace.factor * f.frames * f.render_seconds;
  if (json)
    put(
        fmt::format("{{\"organisms\": {:.0f}, \"modules\": {:.0f}, \"nodes\": {:.0f}, \"organs\": {:.0f}, "
                    "\"copies\": {:.0f}, \"models\": {:.0f}, \"memory_bytes\": {:.0f}, \"frames\": {}, "
                    "\"bytes_a_frame\": {:.0f}, \"written_bytes\": {:.0f}, \"disk_bytes\": {:.0f}, "
                    "\"seconds\": {:.2f}, \"render_seconds\": {:.1f}{}}}\n",
                    f.organisms, f.modules, f.nodes, f.organs, f.copies, f.models, memory, f.frames,
                    f.frame_bytes + f.picture_bytes, f.written(), f.disk(), f.seconds(), render,
                    sizes ? sizes_json(grown) : ""));
  else
    put(fmt::format(
        "about {:.0f} organisms, {:.0f} modules, {:.0f} nodes, {:.0f} organs; {:.0f} copies of {:.0f} "
        "models; {} of memory; {} frames of {}, {} in all; {} of processor to generate, "
        "{} to render (reckoned {})\n",
        f.organisms, f.modules, f.nodes, f.organs, f.copies, f.models, bytes_text(memory), f.frames,
        bytes_text(f.frame_bytes + f.picture_bytes), bytes_text(f.disk()), seconds_text(f.seconds()),
        seconds_text(render), pace.measured));
  if (!json)
    for (const std::string& line : sizes_lines(grown)) put(line + "\n");
  Errors errors = refuse(f, machine);
  for (Error& error : errors) error.where = arguments.path;
  or_fail(errors, kWrongInput);
}

void list_files(const PresetArguments& arguments) {
  Preset preset = or_fail(load_preset(arguments), kWrongInput);
  std::set<std::string> names{arguments.path};
  for (const fs::path& file : preset.files) names.insert(file.string());
  for (const std::string& name : names) put(name + '\0');
}

void list_everything(bool json) {
  fs::path root = or_fail(home(), kCouldNot);
  std::string group;
  Value all = make_list();
  for (const Entry& entry : entries(root)) {
    if (json) {
      Value row = make_object();
      row.set("group", make_text(entry.group))
          .set("name", make_text(entry.name))
          .set("doc", make_text(entry.doc));
      all.items.push_back(std::move(row));
      continue;
    }
    if (entry.group != group) put(entry.group + "\n");
    group = entry.group;
    put(fmt::format("  {:24} {}\n", printable(entry.name), printable(entry.doc)));
  }
  if (json) put(serialize_pretty(all) + "\n");
}

void print_schema() { put(serialize_pretty(preset_schema())); }

}  // namespace frond
