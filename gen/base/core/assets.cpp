#include "core/assets.h"

#include <algorithm>

#include "core/files.h"
#include "core/home.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

/// The folder of a file, by a name that can be shown.
fs::path folder_of(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

/// Whether a path without links lies below a folder, or is that.
bool below(const fs::path& path, const fs::path& folder) {
  std::error_code error;
  fs::path top = fs::canonical(folder, error);
  if (error) return false;
  auto [rest, step] = std::mismatch(top.begin(), top.end(), path.begin(), path.end());
  return rest == top.end();
}

}  // namespace

Assets::Assets(const fs::path& preset, const std::optional<fs::path>& only)
    : folder_(folder_of(preset)), only_(only) {}

std::optional<fs::path> Assets::allowed(const fs::path& path) const {
  if (!only_) return path;
  std::error_code error;
  fs::path real = fs::weakly_canonical(fs::absolute(path, error), error);
  // What comes with Frond is no secret.
  bool inside =
      !error && (below(real, folder_) || below(real, *only_) || below(real, home_folder() / "presets"));
  return inside ? std::optional(real) : std::nullopt;
}

Result<NamedFile> Assets::read(const std::string& name, const fs::path& named_in) const {
  const fs::path folder = named_in.empty() ? "." : named_in;
  if (name.empty()) return Error{"", "no file is named; expected the name of one"};
  // To the system a name would end at a zero byte, and another file would be read than was judged.
  if (name.find('\0') != name.npos) return Error{"", "no file has a zero byte in its name"};
  std::vector<fs::path> places{named_in / name};
  if (fs::path(name).is_relative()) places.push_back(only_ ? *only_ / name : fs::path(name));
  bool outside = false;
  for (const fs::path& path : places) {
    // What lies outside is not even asked for, so that nobody learns whether it is there.
    std::optional<fs::path> real = allowed(path);
    outside = outside || !real;
    if (!real || !path_exists(*real)) continue;
    Result<std::string> text = read_file(*real);
    if (!text) return error_at("", "{} {}", path.string(), text.errors().front().what);
    if (noted_) noted_->push_back(path);
    return NamedFile{path, std::move(*text), noted_};
  }
  if (outside)
    return error_at("", "\"{}\" lies outside of what may be read; expected a file below {} or {}", name,
                    folder_.string(), only_->string());
  if (places.size() == 1) return error_at("", "there is no file {}", name);
  std::error_code error;
  fs::path second = only_ ? *only_ : fs::current_path(error);
  std::string where = fs::equivalent(folder, second, error) ? "" : folder.string() + " and in ";
  return error_at("", "there is no file \"{}\"; looked for in {}{}", name, where, second.string());
}

}  // namespace frond
