#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

#include "core/result.h"

namespace frond {

/// Writes a file as write_file() does, whole and flushed to disk before it is seen, but piece by piece, so
/// that a long one need not be held in memory. If it is never closed, nothing is left behind.
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
  /// Hands what is held to the system.
  void write_held();
  /// Removes the temporary file; what went wrong.
  Error failed(std::string_view what);

  std::filesystem::path path_, temporary_;
  std::string held_;  // not written to the temporary file yet
  int file_ = -1;
  std::error_code error_;  // of the first write that failed
};

}  // namespace frond
