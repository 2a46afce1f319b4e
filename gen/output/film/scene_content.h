#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "core/result.h"

namespace frond {

/// What scenes on the disk show, whatever the files that they are made of are called.
struct SceneContent {
  std::string id;                            ///< 16 hexadecimal digits: equal where the scenes are
  std::set<std::string, std::less<>> words;  ///< with a capital in front, which macros may be among
};

/// Reads scenes and all that they name of what lies in a folder: models, shared parts, soft light, pictures.
/// Names by content change with the code that made it, so each counts as what it is a name of. The order of
/// lines does not count, which may follow such names, nor do comments, but for the first line of a scene
/// from "Render with" on; of a PNG file its samples count.
Result<SceneContent> scene_content(const std::filesystem::path& folder,
                                   const std::vector<std::filesystem::path>& scenes);

}  // namespace frond
