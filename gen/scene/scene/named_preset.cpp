#include "scene/named_preset.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "core/files.h"
#include "preset/fault.h"
#include "preset/json.h"
#include "preset/merge.h"
#include "preset/palettes.h"
#include "preset/reader.h"
#include "scene/describe.h"
#include "scene/taxon.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

constexpr int kMostBases = 8;

/// The names of a preset's properties, as Reader tells them of one that is none.
std::vector<std::string_view> preset_names() {
  Value probe = make_object();
  probe.set("", make_boolean(true));
  Preset preset;
  Reader reader;
  reader.read_root(probe, preset);
  std::vector<std::string_view> names = reader.faults().list().front().names;
  names.push_back("$schema");
  return names;
}

/// A file that was named as a base. Where it is no preset, nothing that stands in it is shown: it may be a
/// file that was not meant to be read.
Result<Document> read_base(const NamedFile& file) {
  std::string path = file.path.string();
  std::string hint = fmt::format("; expected a preset, see `frond check {}`", path);
  Result<Document> base = parse_json(file.text, path);
  if (!base) {
    std::string where = base.errors().front().where;
    return Error{where.substr(0, where.find(": /")), "is no JSON" + hint};
  }
  std::vector<std::string_view> names = preset_names();
  const Value& root = base->root;
  if (!root.is(Value::Type::object)) return Error{root.origin.text(), "is no object" + hint};
  for (const Member& member : root.members)
    if (std::ranges::find(names, member.name) == names.end())
      return Error{member.origin.text(), "is a name that presets do not have" + hint};
  return base;
}

/// The folder in which a value was written, be that of a base; of what was set, that of the preset.
fs::path folder_of(const Value& value, const std::string& file_name) {
  bool written = value.origin.source && value.origin.line > 0;
  return fs::path(written ? *value.origin.source : file_name).parent_path();
}

/// The file of a preset that another one in `folder` names, as its `base` or a `species`: by the rule for all
/// files, and where there is none by that rule, one that comes with Frond, as shipped_by_name() finds it.
Result<NamedFile> read_named_preset(const Assets& assets, const std::string& name, const fs::path& folder) {
  Result<NamedFile> file = assets.read(name, folder);
  if (file || path_exists(folder / name)) return file;
  std::optional<fs::path> shipped = shipped_by_name(name);
  return shipped ? assets.read(shipped->string(), folder) : file;
}

}  // namespace

Value merged_organism(const Value& root, std::size_t index) {
  std::vector<std::string> force;
  if (const Value* names = root.find("force"))
    for (const Value& name : names->items) force.push_back(name.text);
  const Value* defaults = root.find("defaults");
  return merge(defaults ? *defaults : make_object(), root.find("organisms")->items[index], force);
}

Errors lay_on_base(Value& root, const std::string& file_name, const Assets& assets, int depth) {
  const Value* base = root.find("base");
  if (!base) return {};
  auto fault = [&](std::string what) {
    return Errors{Fault{base->origin, "/base", std::move(what)}.error()};
  };
  // What is no text is told where all else is read, but for that of a base, which goes.
  if (!base->is(Value::Type::text))
    return depth == 0 ? Errors{} : fault(fmt::format("found {}; expected a text", found_text(*base)));
  if (base->text.empty()) return {};
  if (depth == kMostBases) return fault("more than 8 bases on each other; is one its own?");
  Result<NamedFile> file = read_named_preset(assets, base->text, fs::path(file_name).parent_path());
  if (!file) return fault(file.errors().front().what);
  Result<Document> below = read_base(*file);
  if (!below) return below.errors();
  if (Errors errors = lay_on_base(below->root, file->path.string(), assets, depth + 1); !errors.empty())
    return errors;
  below->root.remove("base");
  root = overlay(below->root, root);
  return {};
}

Errors lay_on_species(Value& root, const std::string& file_name, const Assets& assets, int depth) {
  Value* organisms = root.find("organisms");
  Errors errors;
  for (std::size_t i = 0; organisms && i < organisms->items.size() && (depth == 0 || i == 0); ++i) {
    Value& organism = organisms->items[i];
    const Value* species = organism.find("species");
    if (!species) continue;
    auto fault = [&](std::string what) {
      errors.push_back(
          Fault{species->origin, fmt::format("/organisms/{}/species", i), std::move(what)}.error());
    };
    if (!species->is(Value::Type::text)) {
      fault(fmt::format("found {}; expected a text", found_text(*species)));
      continue;
    }
    if (species->text.empty()) continue;
    if (species->text.ends_with(".xml")) {
      fault("an XML file is no preset; species of Arbaro are named by \"arbaro\", of the kind weber_penn");
      continue;
    }
    Result<NamedFile> file = Error{"", "more than 8 species on each other; is one its own?"};
    if (depth < kMostBases) file = read_named_preset(assets, species->text, folder_of(*species, file_name));
    if (!file) {
      fault(file.errors().front().what);
      continue;
    }
    Result<Document> other = read_base(*file);
    Errors below = other ? lay_on_base(other->root, file->path.string(), assets) : other.errors();
    if (below.empty()) below = use_palettes(other->root);
    if (below.empty()) below = lay_on_species(other->root, file->path.string(), assets, depth + 1);
    if (!below.empty()) return below;
    const Value* list = other->root.find("organisms");
    if (!list || list->items.empty()) {
      fault(fmt::format("{} has no organism", file->path.string()));
      continue;
    }
    Value kind = merged_organism(other->root, 0);
    for (std::string_view own : {"count", "group", "sown", "species"}) kind.remove(own);
    if (Value* place = kind.find("place"))
      for (std::string_view own : {"at", "in", "along", "on", "center", "inner", "radius"})
        place->remove(own);
    // Copies are sown by rules of their own.
    if (Value* place = organism.find("sown") ? kind.find("place") : nullptr)
      for (std::string_view own : {"spacing", "rock"}) place->remove(own);
    organism.remove("species");
    organism = overlay(kind, organism);
  }
  return errors;
}

}  // namespace frond
