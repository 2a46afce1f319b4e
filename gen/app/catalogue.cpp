#include <fmt/format.h>

#include <algorithm>

#include "app/commands.h"
#include "app/inputs.h"
#include "core/files.h"
#include "core/printable.h"
#include "grammar/symbols.h"
#include "preset/json.h"
#include "scene/describe.h"

// What there is and how large it is: check, info, list, schema.

namespace frond {

namespace fs = std::filesystem;

namespace {

// As measured over the presets.
constexpr double kBytesANode = 85;           // of a frame's text
constexpr double kBytesANodeInMemory = 130;  // the skeleton and its pose
constexpr double kBytesOfGround = 1.4e6;     // floor and stones in a frame's text

/// One thing that can be named in a preset.
struct Entry {
  std::string group, name, doc;
};

std::vector<Entry> entries(const fs::path& root) {
  std::vector<Entry> list;
  for (const auto& row : kOrganismKinds)
    list.push_back({"growers", std::string(row.name), std::string(row.doc)});
  for (const auto& row : kSettings) list.push_back({"settings", std::string(row.name), std::string(row.doc)});
  std::vector<fs::path> files = files_below(root / "presets");
  std::erase_if(
      files, [](const fs::path& file) { return file.extension() != ".json" || is_grammar(file.string()); });
  for (const fs::path& file : files) {
    Result<std::string> text = read_file(file);
    Result<Preset> preset = text ? read_preset(*text, file.string(), {}) : text.errors();
    list.push_back(
        {"presets", file.lexically_relative(root).string(), preset ? preset->title : "(has faults)"});
  }
  for (const TurtleSymbol& symbol : turtle_symbols())
    list.push_back({"symbols", std::string(symbol.name), std::string(symbol.doc)});
  return list;
}

}  // namespace

int check(const std::vector<std::string>& paths, const std::optional<std::string>& assets) {
  int result = kDone;
  for (const std::string& path : paths) {
    PresetArguments named;
    named.path = path;
    named.assets = assets;
    Result<Preset> preset = load_preset(named);
    if (preset) {
      tell_notes(preset->notes);
    } else {
      result = fail(preset.errors(), kWrongInput);
    }
  }
  return result;
}

int info(const PresetArguments& arguments, bool json) {
  if (is_grammar(arguments.path)) return info_grammar(arguments.path, arguments.assets, json);
  Result<Preset> preset = load_preset(arguments);
  if (!preset) return fail(preset.errors(), kWrongInput);
  double organisms = 0, nodes = 0, modules = 0, word_bytes = 0;
  for (const Organism& organism : preset->organisms) {
    Result<Foresight> foresight = foresee(organism, Seed{preset->seed});
    if (!foresight) return fail(foresight.errors(), kWrongInput);
    double count = std::max<double>(organism.count, static_cast<double>(organism.place.at.size()));
    organisms += count;
    nodes += count * foresight->nodes;
    modules += count * foresight->word.modules;
    word_bytes = std::max(word_bytes, foresight->word.bytes);
  }
  double memory = word_bytes + nodes * kBytesANodeInMemory, frame = nodes * kBytesANode + kBytesOfGround;
  std::string_view form =
      json ? "{{\"organisms\": {:.0f}, \"modules\": {:.0f}, \"nodes\": {:.0f}, \"memory_bytes\": {:.0f}, "
             "\"frames\": {}, \"bytes_a_frame\": {:.0f}}}\n"
           : "up to {:.0f} organisms, {:.0f} modules, {:.0f} nodes, {:.3g} bytes of memory; {} frames of "
             "about "
             "{:.3g} bytes\n";
  fmt::print(fmt::runtime(form), organisms, modules, nodes, memory, preset->film.frames, frame);
  return kDone;
}

int list_everything(bool json) {
  Result<fs::path> root = home();
  if (!root) return fail(root.errors(), kCouldNot);
  std::string group;
  Value all = make_list();
  for (const Entry& entry : entries(*root)) {
    if (json) {
      Value row = make_object();
      row.set("group", make_text(entry.group))
          .set("name", make_text(entry.name))
          .set("doc", make_text(entry.doc));
      all.items.push_back(std::move(row));
      continue;
    }
    if (entry.group != group) fmt::print("{}\n", entry.group);
    group = entry.group;
    fmt::print("  {:24} {}\n", printable(entry.name), printable(entry.doc));
  }
  if (json) fmt::print("{}", serialize_pretty(all) + "\n");
  return kDone;
}

int print_schema() {
  fmt::print("{}", preset_schema());
  return kDone;
}

}  // namespace frond
