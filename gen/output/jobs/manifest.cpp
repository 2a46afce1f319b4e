#include "core/files.h"
#include "jobs/jobs.h"
#include "preset/json.h"

namespace frond {

namespace {

/// Gives a member of an object to what reads it; false where there is none of that kind.
template <class Read>
bool read_member(const Value& object, std::string_view name, Value::Type type, const Read& read) {
  const Value* found = object.find(name);
  if (!found || !found->is(type)) return false;
  read(*found);
  return true;
}

bool read_text_member(const Value& object, std::string_view name, std::string& text) {
  return read_member(object, name, Value::Type::text, [&](const Value& value) { text = value.text; });
}

template <class Number>
bool read_number_member(const Value& object, std::string_view name, Number& number) {
  return read_member(object, name, Value::Type::number,
                     [&](const Value& value) { number = static_cast<Number>(value.number); });
}

bool read_pair_member(const Value& object, std::string_view name, std::array<int, 2>& size) {
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
      read_text_member(root, "version", manifest.version) &&
      read_text_member(root, "preset", manifest.preset) && read_text_member(root, "title", manifest.title) &&
      read_text_member(root, "preset_hash", manifest.preset_hash) &&
      read_number_member(root, "seed", manifest.seed) && read_number_member(root, "fps", manifest.fps) &&
      read_pair_member(root, "size", manifest.size) &&
      read_number_member(root, "render_seconds", manifest.render_seconds) &&
      read_member(root, "still", Value::Type::boolean,
                  [&](const Value& value) { manifest.still = value.boolean; });
  read_pair_member(root, "raw", manifest.raw);
  read_member(root, "transparent", Value::Type::boolean,
              [&](const Value& value) { manifest.transparent = value.boolean; });
  if (const Value* budgets = root.find("budgets"))
    for (const Value& item : budgets->items) {
      Manifest::Budget& budget = manifest.budgets.emplace_back();
      whole = whole && read_text_member(item, "pointer", budget.pointer) &&
              read_number_member(item, "seconds", budget.seconds) &&
              read_number_member(item, "internodes", budget.internodes);
    }
  const Value* frames = root.find("frames");
  if (!whole || !frames || !frames->is(Value::Type::list) || frames->items.empty())
    return Error{file_name, "is no manifest that `frond generate` has written"};
  for (const Value& item : frames->items) {
    Manifest::Frame frame;
    if (!read_number_member(item, "number", frame.number) || !read_number_member(item, "time", frame.time) ||
        !read_number_member(item, "nodes", frame.nodes))
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
