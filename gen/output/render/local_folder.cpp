#include "render/local_folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <stdlib.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <string>

#include "core/files.h"
#include "render/process.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

/// Removes a folder that no task holds.
void remove_left(const fs::path& folder) {
  Descriptor file(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
  if (!file) return;
  struct stat about {};
  bool ours = ::fstat(*file, &about) == 0 && about.st_uid == ::getuid();
  if (ours && ::flock(*file, LOCK_EX | LOCK_NB) == 0) remove_tree(folder);
}

}  // namespace

LocalFolder::LocalFolder() {
  near_ = environment_or("SLURM_TMPDIR", environment_or("TMPDIR", "/tmp"));
  std::string name = fmt::format("frond-farm.{}.", ::getuid());
  for (const fs::path& path : files_in(near_))
    if (path.filename().string().starts_with(name)) remove_left(path);
  // Another task may find the folder before it is held, and take it for left: then it is gone, and there is a
  // next one.
  constexpr int kTries = 100;
  for (int i = 0; i < kTries; ++i) {
    std::string path = (near_ / (name + "XXXXXX")).string();
    if (!::mkdtemp(path.data())) return;
    Descriptor lock(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (lock) ::flock(*lock, LOCK_EX);
    if (!lock || !is_folder(path)) continue;
    path_ = path, lock_ = std::move(lock);
    return;
  }
}

LocalFolder::~LocalFolder() {
  if (!path_.empty()) remove_tree(path_);
}

}  // namespace frond
