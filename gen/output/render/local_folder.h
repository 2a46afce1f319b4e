#pragma once

#include <filesystem>

#include "render/descriptor.h"

namespace frond {

/// A folder of this task's own on the disk of this machine ($SLURM_TMPDIR, $TMPDIR or /tmp); gone with this,
/// and what killed tasks have left goes when it is made.
class LocalFolder {
 public:
  LocalFolder();
  ~LocalFolder();

  /// Empty where none could be made.
  const std::filesystem::path& path() const { return path_; }
  const std::filesystem::path& near() const { return near_; }

 private:
  std::filesystem::path near_, path_;
  Descriptor lock_;  // held as long as the task lives
};

}  // namespace frond
