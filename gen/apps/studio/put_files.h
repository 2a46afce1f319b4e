#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "core/result.h"

// Files that are put beside a preset, under names that nothing else there has.
namespace frond {

/// What files are called in the folder that they were put into.
struct PutFiles {
  std::string name;
  bool fresh = false;  ///< whether they were written; else the same was there already, and is somebody's
};

/// Puts a file into a folder under a name like the one given; what it is called there. The same content is
/// not put there twice.
Result<PutFiles> put_beside(const std::filesystem::path& folder, const std::string& name,
                            const std::string& content);

/// Puts files that name each other into a new folder in another, under a name like the one given; what that
/// is called. They are told by their paths in it. Where they stand in such a folder already it is that one.
Result<PutFiles> put_folder(const std::filesystem::path& folder, const std::string& name,
                            const std::map<std::string, std::string>& contents);

}  // namespace frond
