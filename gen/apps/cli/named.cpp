#include "cli/named.h"

#include <filesystem>
#include <optional>

#include "core/files.h"
#include "core/home.h"
#include "organisms/kinds.h"
#include "scene/taxon.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

/// Where something lies, as one types it here.
std::string typed(const fs::path& file) {
  std::error_code error;
  fs::path near = fs::proximate(file, error);
  return error || near.string().starts_with("..") ? file.string() : near.string();
}

/// A file at that path, with or without its .json.
std::optional<std::string> file_at(const std::string& word) {
  for (const std::string& path : {word, word + ".json"})
    if (!word.empty() && word.find('\0') == word.npos && path_exists(path) && !is_folder(path)) return path;
  return std::nullopt;
}

}  // namespace

std::string preset_named(const std::string& word) {
  if (std::optional<std::string> own = file_at(word)) return *own;
  for (const auto& row : organism_kinds())
    if (fs::path file = home_folder() / "templates" / "new" / (word + ".json");
        row.name == word && is_file(file))
      return typed(file);
  std::optional<fs::path> shipped = shipped_by_name(word);
  return shipped ? typed(*shipped) : word;
}

std::string grammar_named(const std::string& word) {
  if (std::optional<std::string> own = file_at(word)) return *own;
  fs::path grammar = home_folder() / "presets" / "grammars" / (word + ".json");
  bool plain = !word.empty() && word.find('/') == word.npos && word.find('\0') == word.npos;
  return plain && is_file(grammar) ? typed(grammar) : preset_named(word);
}

}  // namespace frond
