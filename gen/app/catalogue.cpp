#include <fmt/format.h>

#include <algorithm>

#include "app/commands.h"
#include "app/inputs.h"
#include "core/files.h"
#include "preset/json.h"
#include "scene/describe.h"
#include "scene/scene.h"

// What there is and how large it is: check, info, list, schema.

namespace frond {

namespace fs = std::filesystem;

namespace {

constexpr double kBytesANode = 85;  // of a frame's text, as measured over the presets

/// One thing that can be named in a preset.
struct Entry {
  std::string group, name, doc;
};

std::vector<Entry> entries(const fs::path& root) {
  std::vector<Entry> list;
  for (const auto& row : kOrganismKinds)
    list.push_back({"growers", std::string(row.name), std::string(row.doc)});
  for (const auto& row : kSettings) list.push_back({"settings", std::string(row.name), std::string(row.doc)});
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& file : fs::directory_iterator(root / "presets", error))
    if (file.path().extension() == ".json") files.push_back(file.path());
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) {
    Result<std::string> text = read_file(file);
    Result<Preset> preset = text ? read_preset(*text, file.string(), {}) : text.errors();
    list.push_back(
        {"presets", "presets/" + file.filename().string(), preset ? preset->title : "(has faults)"});
  }
  return list;
}

}  // namespace

int check(const std::vector<std::string>& paths) {
  int result = kDone;
  for (const std::string& path : paths) {
    Result<Preset> preset = load_preset({path, {}, {}, {}});
    if (!preset) result = fail(preset.errors(), kWrongInput);
  }
  return result;
}

int info(const PresetArguments& arguments, bool json) {
  Result<Preset> preset = load_preset(arguments);
  if (!preset) return fail(preset.errors(), kWrongInput);
  Result<Scene> scene = build_scene(*preset);
  if (!scene) return fail(scene.errors(), kWrongInput);
  auto bytes = static_cast<std::size_t>(kBytesANode * static_cast<double>(scene->nodes())) + 700'000;
  std::string_view form =
      json ? "{{\"organisms\": {}, \"nodes\": {}, \"stones\": {}, \"frames\": {}, \"bytes_a_frame\": {}}}\n"
           : "{} organisms, {} nodes, {} stones, {} frames of about {} bytes\n";
  fmt::print(fmt::runtime(form), scene->branches.size(), scene->nodes(), scene->stone_instances.size(),
             preset->film.frames, bytes);
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
    fmt::print("  {:24} {}\n", entry.name, entry.doc);
  }
  if (json) fmt::print("{}", serialize_pretty(all) + "\n");
  return kDone;
}

int print_schema() {
  fmt::print("{}", preset_schema());
  return kDone;
}

}  // namespace frond
