#include "core/files.h"
#include "jobs/jobs.h"
#include "preset/json.h"

namespace frond {

namespace {

/// Gives a member of an object to what takes it; false where there is none of that kind.
template <class Take>
bool take(const Value& object, std::string_view name, Value::Type type, const Take& take_it) {
  const Value* found = object.find(name);
  if (!found || !found->is(type)) return false;
  take_it(*found);
  return true;
}

bool take_text(const Value& object, std::string_view name, std::string& text) {
  return take(object, name, Value::Type::text, [&](const Value& value) { text = value.text; });
}

template <class Number>
bool take_number(const Value& object, std::string_view name, Number& number) {
  return take(object, name, Value::Type::number,
              [&](const Value& value) { number = static_cast<Number>(value.number); });
}

bool take_two(const Value& object, std::string_view name, std::array<int, 2>& size) {
  const Value* list = object.find(name);
  if (!list || list->items.size() != 2) return false;
  for (std::size_t i = 0; i < 2; ++i) size[i] = static_cast<int>(list->items[i].number);
  return true;
}

}  // namespace

Result<Manifest> read_manifest(std::string_view text, const std::string& file_name) {
  Result<Document> document = parse_json(text, file_name);
  if (!document) return document.errors();
  const Value& root = document->root;
  Manifest manifest;
  bool whole =
      take_text(root, "version", manifest.version) && take_text(root, "preset", manifest.preset) &&
      take_text(root, "title", manifest.title) && take_text(root, "preset_hash", manifest.preset_hash) &&
      take_number(root, "seed", manifest.seed) && take_number(root, "fps", manifest.fps) &&
      take_two(root, "size", manifest.size) && take_number(root, "render_seconds", manifest.render_seconds) &&
      take(root, "still", Value::Type::boolean, [&](const Value& value) { manifest.still = value.boolean; });
  take_two(root, "raw", manifest.raw);
  take(root, "transparent", Value::Type::boolean,
       [&](const Value& value) { manifest.transparent = value.boolean; });
  if (const Value* budgets = root.find("budgets"))
    for (const Value& item : budgets->items) {
      Manifest::Budget& budget = manifest.budgets.emplace_back();
      whole = whole && take_text(item, "pointer", budget.pointer) &&
              take_number(item, "seconds", budget.seconds) &&
              take_number(item, "internodes", budget.internodes);
    }
  const Value* frames = root.find("frames");
  if (!whole || !frames || !frames->is(Value::Type::list) || frames->items.empty())
    return Error{file_name, "is no manifest that `frond generate` has written"};
  for (const Value& item : frames->items) {
    Manifest::Frame frame;
    if (!take_number(item, "number", frame.number) || !take_number(item, "time", frame.time) ||
        !take_number(item, "nodes", frame.nodes))
      return Error{file_name, "names a frame without number, time or nodes"};
    manifest.frames.push_back(frame);
  }
  return manifest;
}

Result<Manifest> manifest_in(const std::filesystem::path& folder) {
  std::filesystem::path file = folder / "manifest.json";
  Result<std::string> text = read_file(file);
  return text ? read_manifest(*text, file.string()) : text.errors();
}

}  // namespace frond
