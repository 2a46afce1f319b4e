#include "studio/put_files.h"

#include <fmt/format.h>

#include "core/files.h"
#include "core/printable.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

constexpr int kMost = 1000;  // of one name

/// Whether files stand in a folder as they are told.
bool holds(const fs::path& folder, const std::map<std::string, std::string>& contents) {
  for (const auto& [name, content] : contents)
    if (Result<std::string> there = read_file(folder / name); !there || *there != content) return false;
  return true;
}

/// Writes files as a new folder: all of them or, as where the disk fills, none.
Errors write_folder(const fs::path& folder, const std::map<std::string, std::string>& contents) {
  fs::path temporary = temporary_beside(folder);
  Errors errors;
  for (const auto& [file, content] : contents)
    if (Result<bool> written = write_file(temporary / file, content); !written) {
      errors = written.errors();
      for (Error& error : errors) error.where = (folder / file).string();
      break;
    }
  std::error_code error, ignored;
  if (errors.empty()) fs::rename(temporary, folder, error);
  if (error) errors.push_back({folder.string(), "cannot be put in place: " + reason_of(error)});
  if (!errors.empty()) fs::remove_all(temporary, ignored);
  return errors;
}

}  // namespace

Result<PutFiles> put_beside(const fs::path& folder, const std::string& name, const std::string& content) {
  // The name is a person's; what becomes of it is a plain one that nothing else has.
  std::string stem = plain_name(fs::path(name).stem().string(), "file").substr(0, 60);
  std::string type = fs::path(name).extension().string();
  for (int number = 1; number < kMost; ++number) {
    std::string own = number == 1 ? stem + type : fmt::format("{}-{}{}", stem, number, type);
    if (path_exists(folder / own)) {
      Result<std::string> there = read_file(folder / own);
      if (there && *there == content) return PutFiles{own};
      continue;
    }
    Result<bool> written = write_file(folder / own, content);
    if (!written) return written.errors();
    return PutFiles{own, true};
  }
  return Error{name, "there are too many files of that name"};
}

Result<PutFiles> put_folder(const fs::path& folder, const std::string& name,
                            const std::map<std::string, std::string>& contents) {
  for (int number = 1; number <= kMost; ++number) {
    std::string own = number == 1 ? name : fmt::format("{}-{}", name, number);
    if (path_exists(folder / own)) {
      if (holds(folder / own, contents)) return PutFiles{own};
      continue;
    }
    if (Errors errors = write_folder(folder / own, contents); !errors.empty()) return errors;
    return PutFiles{own, true};
  }
  return Error{name, "there are too many folders of that name"};
}

}  // namespace frond
