#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "core/result.h"

namespace frond {

/// Writes a file as write_file() does, but piece by piece, so that a long one need not be held in memory. If
/// it is never closed, nothing is left behind.
class GrowingFile {
 public:
  explicit GrowingFile(std::filesystem::path path);
  ~GrowingFile();
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;

  void add(std::string_view text);

  /// Renames the file into place; true where its content is new.
  Result<bool> close();

 private:
  std::filesystem::path path_, temporary_;
  std::string held_;  // not written to the temporary file yet
  std::ofstream out_;
  int error_ = 0;  // errno of the first write that failed
};

}  // namespace frond
