#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "core/result.h"

namespace frond {

/// The whole content of a file.
Result<std::string> read_file(const std::filesystem::path& path);

/// Writes a file atomically: readers see all of it or nothing, even after a crash of the machine (a temporary
/// file beside it is flushed to disk, then renamed). Makes missing folders. A file that already has this
/// content is left untouched with its time stamp. True where the file was written.
Result<bool> write_file(const std::filesystem::path& path, std::string_view text);

/// Writes a file that is flushed to disk when this returns. Always a new file: an existing one is removed
/// first, and a link there is not followed.
std::error_code write_new(const std::filesystem::path& path, std::string_view text);

/// Writes all of a text to an open file.
std::error_code write_fully(int file, std::string_view text);

/// The error that the system told last.
std::error_code error_now();

/// The name of a temporary file beside another, unique among processes and threads, to be renamed to it when
/// complete: the name followed by ".tmp" and digits.
std::filesystem::path temporary_beside(const std::filesystem::path& path);

/// Locks a folder (made if missing) against all others who lock it so, in this process or another, for the
/// lifetime of this object. Does nothing on file systems without locks.
class FolderLock {
 public:
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int file_ = -1;
};

/// The sorted entries of a folder; empty for a missing folder, incomplete for one that is removed meanwhile.
/// (The increment of std::filesystem's iterators throws.)
std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder);
/// The sorted entries of a folder and of all folders below it, as far as files_in() lists them.
std::vector<std::filesystem::path> files_below(const std::filesystem::path& folder);

/// Whether a path leads to anything, to a file or to a folder; false where that cannot be told.
bool path_exists(const std::filesystem::path& path);
bool is_file(const std::filesystem::path& path);
bool is_folder(const std::filesystem::path& path);

/// Removes a file or an empty folder, and a folder with all that is in it; what cannot be removed stays. True
/// where the file was removed.
bool remove_file(const std::filesystem::path& path);
void remove_tree(const std::filesystem::path& path);

/// A path as seen from a folder, which need not be there yet: one that is not is no reason for an empty path,
/// as it is to std::filesystem::relative.
std::filesystem::path path_from(const std::filesystem::path& folder, const std::filesystem::path& path);

/// The system's message for an error, but "no room on the disk" for a full one.
std::string reason_of(std::error_code error);

}  // namespace frond
