#include <type_traits>

#include "core/files.h"
#include "jobs/jobs.h"
#include "preset/json.h"

namespace frond {

namespace {

/// Reads a member of an object; false where there is none of that kind.
template <class T>
bool read_member(const Value& object, std::string_view name, T& to) {
  constexpr bool text = std::is_same_v<T, std::string>, boolean = std::is_same_v<T, bool>;
  const Value* found = object.find(name);
  if (!found || !found->is(text ? Value::Type::text : boolean ? Value::Type::boolean : Value::Type::number))
    return false;
  if constexpr (text)
    to = found->text;
  else if constexpr (boolean)
    to = found->boolean;
  else
    to = static_cast<T>(found->number);
  return true;
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
  bool whole = read_member(root, "version", manifest.version) &&
               read_member(root, "preset", manifest.preset) && read_member(root, "title", manifest.title) &&
               read_member(root, "preset_hash", manifest.preset_hash) &&
               read_member(root, "seed", manifest.seed) && read_member(root, "fps", manifest.fps) &&
               read_pair_member(root, "size", manifest.size) &&
               read_member(root, "render_seconds", manifest.render_seconds) &&
               read_member(root, "still", manifest.still);
  read_pair_member(root, "raw", manifest.raw);
  read_member(root, "transparent", manifest.transparent);
  if (const Value* budgets = root.find("budgets"))
    for (const Value& item : budgets->items) {
      Manifest::Budget& budget = manifest.budgets.emplace_back();
      whole = whole && read_member(item, "pointer", budget.pointer) &&
              read_member(item, "seconds", budget.seconds) &&
              read_member(item, "internodes", budget.internodes);
    }
  const Value* frames = root.find("frames");
  if (!whole || !frames || !frames->is(Value::Type::list) || frames->items.empty())
    return Error{file_name, "is no manifest that `frond generate` has written"};
  for (const Value& item : frames->items) {
    Manifest::Frame frame;
    if (!read_member(item, "number", frame.number) || !read_member(item, "time", frame.time) ||
        !read_member(item, "nodes", frame.nodes))
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
