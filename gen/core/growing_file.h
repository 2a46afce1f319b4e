#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "core/result.h"

namespace frond {

/// Writes a file as write_file() does, piece by piece, so that a long one need not be held in memory. What is
/// not closed leaves nothing behind.
class GrowingFile {
 public:
  explicit GrowingFile(std::filesystem::path path);
  ~GrowingFile();
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;

  void add(std::string_view text);

  /// Puts the file in its place; true where it was not there just so.
  Result<bool> close();

 private:
  std::filesystem::path path_, temporary_;
  std::string held_;  // what is not in the temporary yet
  std::ofstream out_;
  int error_ = 0;  // errno of the first write that failed
};

}  // namespace frond
