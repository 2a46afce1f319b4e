#include "core/home.h"

#include <dlfcn.h>

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

constexpr const char* kInstalled = "share/frond";

/// The folder of the program or the shared library that this code is in.
fs::path folder_of_code() {
  Dl_info info{};
  std::error_code error;
  if (::dladdr(reinterpret_cast<void*>(&folder_set), &info) == 0 || !info.dli_fname) return {};
  return fs::weakly_canonical(info.dli_fname, error).parent_path();
}

}  // namespace

void set_home_folder(fs::path folder) { folder_set() = std::move(folder); }

fs::path home_folder() {
  if (const char* given = std::getenv("FROND_HOME")) return given;
  if (!folder_set().empty()) return folder_set();
  std::error_code error;
  fs::path usual = fs::read_symlink("/proc/self/exe", error).parent_path().parent_path();
  fs::path own = folder_of_code();
  // Where it was built, and where it is installed: PREFIX/bin and PREFIX/lib/x86_64-linux-gnu.
  for (const fs::path& place :
       {usual, usual / kInstalled, own / "..", own / ".." / kInstalled, own / ".." / ".." / kInstalled})
    if (fs::exists(place / "templates" / "frame.pov", error)) return place.lexically_normal();
  return usual;
}

fs::path cache_folder() {
  const char* cache = std::getenv("XDG_CACHE_HOME");
  const char* user = std::getenv("HOME");
  if (cache && *cache) return fs::path(cache) / "frond";
  return fs::path(user ? user : "/") / ".cache" / "frond";
}

std::optional<fs::path> shipped_preset(std::string_view name) {
  fs::path path(name);
  bool plain = !name.empty() && name.find('\0') == name.npos && path.is_relative();
  if (!plain || std::ranges::find(path, "..") != path.end()) return std::nullopt;
  const fs::path presets = home_folder() / "presets";
  if (path.extension() != ".json") path += ".json";
  for (const fs::path& file : {home_folder() / path, presets / path})
    if (std::ranges::mismatch(presets, file).in1 == presets.end() && is_file(file)) return file;
  if (path.has_parent_path()) return std::nullopt;
  for (const fs::path& file : files_below(presets))
    if (file.filename() == path && file.parent_path().filename() != "grammars" && is_file(file)) return file;
  return std::nullopt;
}

}  // namespace frond
