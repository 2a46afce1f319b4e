#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"

namespace frond {

/// The text of a file that was named somewhere, and where it was found.
struct NamedFile {
  std::filesystem::path path;
  std::string text;
};

/// The one rule by which files are found that a preset or a grammar names: seen from the folder of what names
/// them, and where they are not there, from the working folder. With `only` nothing is read but what lies
/// below the folder of the preset and that one, links followed, and the second place to look is that one.
class Assets {
 public:
  /// `preset` is the path of the file that is read first.
  explicit Assets(const std::filesystem::path& preset, const std::optional<std::filesystem::path>& only = {});

  /// The file of that name, named in one that lies in `folder`, the working folder where that is empty. An
  /// error has no place: it is about the value that names the file, and says where it was looked for. It
  /// shows nothing that stands in a file.
  Result<NamedFile> read(const std::string& name, const std::filesystem::path& folder) const;
  /// Named in the preset itself.
  Result<NamedFile> read(const std::string& name) const { return read(name, folder_); }

  /// Names each file that is read from now on.
  void note_in(std::vector<std::filesystem::path>& paths) { noted_ = &paths; }

 private:
  /// The path as it may be read, with `only` without links; nothing where it may not.
  std::optional<std::filesystem::path> allowed(const std::filesystem::path& path) const;

  std::filesystem::path folder_;
  std::optional<std::filesystem::path> only_;
  std::vector<std::filesystem::path>* noted_ = nullptr;
};

}  // namespace frond
