#include "core/home.h"

#include <algorithm>
#include <cstdlib>

#include "core/files.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

fs::path& folder_set() {
  static fs::path folder;
  return folder;
}

}  // namespace

void set_home_folder(fs::path folder) { folder_set() = std::move(folder); }

fs::path home_folder() {
  if (const char* given = std::getenv("FROND_HOME")) return given;
  if (!folder_set().empty()) return folder_set();
  std::error_code error;
  return fs::read_symlink("/proc/self/exe", error).parent_path().parent_path();
}

std::optional<fs::path> shipped_preset(std::string_view name) {
  fs::path path(name);
  bool plain = !name.empty() && name.find('\0') == name.npos && path.is_relative();
  if (!plain || std::ranges::find(path, "..") != path.end()) return std::nullopt;
  std::error_code error;
  const fs::path presets = home_folder() / "presets";
  if (path.extension() != ".json") path += ".json";
  for (const fs::path& file : {home_folder() / path, presets / path})
    if (std::ranges::mismatch(presets, file).in1 == presets.end() && fs::is_regular_file(file, error))
      return file;
  if (path.has_parent_path()) return std::nullopt;
  for (const fs::path& file : files_below(presets))
    if (file.filename() == path && file.parent_path().filename() != "grammars" &&
        fs::is_regular_file(file, error))
      return file;
  return std::nullopt;
}

}  // namespace frond
