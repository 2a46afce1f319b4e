#pragma once

#include <filesystem>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace frond {

/// Files and folders that the page had written beside a preset while it was worked on: pictures of masks and
/// of materials, meshes, models that were edited. Each change writes another, so that it can be undone; when
/// the preset is saved, those that it does not name go. What was removed is put back where a text names it
/// again, as after an undo, as long as this lives. What a saved text has named once stays for good.
class MadeFiles {
 public:
  explicit MadeFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// `name` was written below the folder, while the preset `of` was worked on. `fresh`: it was not there
  /// before. What was there and is not known here is somebody's own, and stays.
  void add(const std::string& name, const std::filesystem::path& of, bool fresh);
  /// A preset was saved with that text.
  void saved(const std::filesystem::path& of, const std::string& text);
  /// Puts back what a text names.
  void restore(const std::string& text);

 private:
  struct Made {
    std::string name;
    std::filesystem::path of;
    std::vector<std::pair<std::filesystem::path, std::string>> held;  // of what was removed
  };
  void remove(Made& made) const;

  std::filesystem::path folder_;
  std::mutex mutex_;
  std::vector<Made> made_;
};

}  // namespace frond
