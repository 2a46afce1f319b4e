#include "core/work_folder.h"

#include <stdlib.h>

#include <string>

#include "core/files.h"

namespace frond {

namespace fs = std::filesystem;

WorkFolder::WorkFolder() {
  std::error_code error;
  std::string path = (fs::temp_directory_path(error) / "frond.XXXXXX").string();
  if (!error && ::mkdtemp(path.data())) path_ = path;
}

WorkFolder::~WorkFolder() {
  if (!path_.empty()) remove_tree(path_);
}

}  // namespace frond
