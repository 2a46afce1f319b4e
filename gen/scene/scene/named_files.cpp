#include "scene/named_files.h"

#include <algorithm>
#include <vector>

#include "core/files.h"
#include "preset/json.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

/// All texts of a preset that may be names of files: those with an ending.
void find_names(const Value& value, std::vector<const Value*>& names) {
  if (value.is(Value::Type::text) && fs::path(value.text).has_extension()) names.push_back(&value);
  for (const Value& item : value.items) find_names(item, names);
  for (const Member& member : value.members)
    if (member.name != "$schema") find_names(member.value, names);
}

/// Where a line begins.
std::size_t line_start(std::string_view text, int line) {
  std::size_t at = 0;
  for (int i = 1; i < line && at < text.size(); ++i) at = std::min(text.find('\n', at), text.size() - 1) + 1;
  return at;
}

}  // namespace

Result<std::string> renamed(const std::string& text, const fs::path& folder,
                            const std::function<Result<std::string>(const fs::path& file)>& name_of) {
  Result<Document> document = parse_json(text, "preset");
  if (!document) return text;  // no preset yet: it goes as it is
  std::vector<const Value*> names;
  find_names(document->root, names);
  std::string changed = text;
  // From the end, so that places before stay what they are.
  std::ranges::reverse(names);
  for (const Value* name : names) {
    fs::path file = folder / name->text;
    if (!is_file(file)) continue;
    Result<std::string> own = name_of(file);
    if (!own) return own;
    std::string written = serialize(*name);
    std::size_t at =
        own->empty() ? changed.npos : changed.find(written, line_start(changed, name->origin.line));
    if (at != changed.npos) changed.replace(at, written.size(), serialize(make_text(*own)));
  }
  return changed;
}

Result<std::string> with_whole_paths(const std::string& text, const fs::path& folder) {
  return renamed(text, folder, [](const fs::path& file) -> Result<std::string> {
    std::error_code error;
    return fs::absolute(file, error).lexically_normal().string();
  });
}

}  // namespace frond
