#include "studio/carry.h"

#include <algorithm>
#include <vector>

#include "core/files.h"
#include "preset/json.h"
#include "studio/grammar_files.h"
#include "studio/mesh_files.h"
#include "studio/put_files.h"

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

/// The text of a preset of a folder with other names for the files that it names and that are there; none
/// where `name_of` gives an empty one.
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
    std::error_code error;
    if (!fs::is_regular_file(file, error)) continue;
    Result<std::string> own = name_of(file);
    if (!own) return own;
    std::string written = serialize(*name);
    std::size_t at =
        own->empty() ? changed.npos : changed.find(written, line_start(changed, name->origin.line));
    if (at != changed.npos) changed.replace(at, written.size(), serialize(make_text(*own)));
  }
  return changed;
}

}  // namespace

Result<std::string> carried(const std::string& text, const fs::path& from, const fs::path& to,
                            const std::function<bool(const fs::path&)>& readable) {
  return renamed(text, from, [&](const fs::path& file) -> Result<std::string> {
    if (!readable(file)) return std::string();
    auto put = [&]() -> Result<PutFiles> {
      if (file.extension() == ".l") return put_grammar(to, file);
      if (is_mesh_name(file)) return copy_mesh(to, file);
      Result<std::string> content = read_file(file);
      if (!content) return content.errors();
      return put_beside(to, file.filename().string(), *content);
    }();
    if (!put) return put.errors();
    return put->name;
  });
}

Result<std::string> with_whole_paths(const std::string& text, const fs::path& folder) {
  return renamed(text, folder, [](const fs::path& file) -> Result<std::string> {
    std::error_code error;
    return fs::absolute(file, error).lexically_normal().string();
  });
}

}  // namespace frond
