#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"

namespace frond {

/// The text of a file named in a preset or grammar, and where it was found.
struct NamedFile {
  std::filesystem::path path;
  std::string text;
  std::vector<std::filesystem::path>* noted = nullptr;  ///< where to note the files that it names in turn
};

/// A file as a property names it.
struct FileName {
  std::string name;     ///< empty: none
  std::string content;  ///< a hash of what it held when it was read; empty: it was not

  bool empty() const { return name.empty(); }
};

/// The one rule for finding files that a preset or a grammar names: relative to the folder of the file that
/// names them, then relative to the working folder. With `only`, nothing is read outside the folder of the
/// preset, the folder `only` (links resolved), which replaces the working folder, and Frond's own presets.
class Assets {
 public:
  /// `preset` is the path of the file that is read first.
  explicit Assets(const std::filesystem::path& preset, const std::optional<std::filesystem::path>& only = {});

  /// The file of that name, named in a file in `folder` (empty: the working folder). An error has no position
  /// of its own; it says where the file was looked for and never quotes file contents.
  Result<NamedFile> read(const std::string& name, const std::filesystem::path& folder) const;
  /// The file of that name, named in the preset itself; errors are those of the other read().
  Result<NamedFile> read(const std::string& name) const { return read(name, folder_); }

  /// Appends the path of each file read from now on to `paths`.
  void note_in(std::vector<std::filesystem::path>& paths) { noted_ = &paths; }

 private:
  /// The path if it may be read, with `only` after resolving links; otherwise nothing.
  std::optional<std::filesystem::path> allowed(const std::filesystem::path& path) const;

  std::filesystem::path folder_;
  std::optional<std::filesystem::path> only_;
  std::vector<std::filesystem::path>* noted_ = nullptr;
};

}  // namespace frond
