#include "scene/preset.h"

#include <fmt/format.h>

#include "preset/json.h"
#include "preset/override.h"
#include "preset/reader.h"
#include "preset/schema.h"
#include "scene/describe.h"

namespace frond {

Result<Preset> read_preset(std::string_view text, const std::string& file_name,
                           const std::vector<std::string>& sets) {
  Result<Document> document = parse_json(text, file_name);
  if (!document) return document.errors();
  Errors errors;
  for (const std::string& set : sets)
    for (Error& error : apply_set(*document, set)) errors.push_back(std::move(error));
  if (!errors.empty()) return errors;

  Result<Preset> preset = read_preset<Preset>(*document);
  if (!preset) return preset;
  preset->text = serialize(document->root);
  for (std::size_t i = 0; i < preset->organisms.size(); ++i) {
    for (Error& error : check(preset->organisms[i])) {
      std::string where = fmt::format("{}: /organisms/{}/grammar", file_name, i);
      errors.push_back({error.where.empty() ? where : where + ": " + error.where, error.what});
    }
  }
  if (!errors.empty()) return errors;
  return preset;
}

std::string preset_schema() {
  return schema_text<Preset>("Frond preset", "A film or a still of things that grow.");
}

}  // namespace frond
