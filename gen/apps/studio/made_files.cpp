#include "studio/made_files.h"

#include <algorithm>

#include "core/files.h"

namespace frond {

namespace fs = std::filesystem;

void MadeFiles::add(const std::string& name, const fs::path& of, bool fresh) {
  std::lock_guard lock(mutex_);
  const std::size_t known = std::erase_if(made_, [&](const Made& made) { return made.name == name; });
  if (fresh || known > 0) made_.push_back({name, of, {}});
}

void MadeFiles::saved(const fs::path& of, const std::string& text) {
  std::lock_guard lock(mutex_);
  std::erase_if(made_, [&](const Made& made) { return text.find(made.name) != text.npos; });
  for (Made& made : made_)
    if (made.of == of && made.held.empty()) remove(made);
}

void MadeFiles::remove(Made& made) const {
  const fs::path path = folder_ / made.name;
  std::vector<fs::path> files{path};
  if (is_folder(path)) files = files_below(path);
  for (const fs::path& file : files) {
    if (!is_file(file)) continue;
    // What could not be put back is not taken away.
    Result<std::string> held = read_file(file);
    if (!held || !remove_file(file)) continue;
    made.held.emplace_back(file, std::move(*held));
  }
  std::ranges::reverse(files);
  for (const fs::path& folder : files)
    if (is_folder(folder)) remove_file(folder);  // an empty one
  if (is_folder(path)) remove_file(path);
}

void MadeFiles::restore(const std::string& text) {
  std::lock_guard lock(mutex_);
  for (Made& made : made_) {
    if (made.held.empty() || text.find(made.name) == text.npos) continue;
    for (const auto& [file, content] : made.held) {
      if (!path_exists(file)) (void)write_file(file, content);
    }
    made.held.clear();
  }
}

}  // namespace frond
