#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "core/result.h"

namespace frond {

/// The whole of a file.
Result<std::string> read_file(const std::filesystem::path& path);

/// Writes a file so that it is seen whole or not at all, even after a crash of the machine (a temporary
/// beside it that lies on the disk before it is renamed), making the folders above it. A file that already
/// holds just this text is left alone with its time stamp. True where the file was written.
Result<bool> write_file(const std::filesystem::path& path, std::string_view text);

/// Writes a file that lies on the disk when this returns. It is a new one: what stands in its place goes, and
/// a link there is not followed.
std::error_code write_new(const std::filesystem::path& path, std::string_view text);

/// A file beside another that nobody else writes, no thread of ours either, to be renamed to it when it is
/// whole: its name goes on with ".tmp" and digits.
std::filesystem::path temporary_beside(const std::filesystem::path& path);

/// Holds a folder, made where it is not there, against all others who ask for it like this, in this process
/// or another, as long as it lives. Where the disk knows no locks it holds nothing.
class FolderLock {
 public:
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int file_ = -1;
};

/// What lies in a folder, sorted; nothing of a folder that is not there, and what there was of one that goes
/// away meanwhile. (The increment of std::filesystem's iterators throws.)
std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder);
/// The same of a folder and all folders below it.
std::vector<std::filesystem::path> files_below(const std::filesystem::path& folder);

/// What the system says of an error, but "no room on the disk" of a full one.
std::string reason_of(std::error_code error);

}  // namespace frond
