#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "emit/copies.h"
#include "emit/frame.h"
#include "scene/scene.h"

namespace frond {

// What a film needs on the disk, each file whole or not there. A watch hears of the phases "texture" and
// "models".

/// Plans how copies are drawn, and grows the models whose files are not in a folder yet.
Result<CopyPlan> write_models(const Scene& scene, const std::filesystem::path& folder,
                              const ProgressSink& watch);

/// Works out the soft light, where it is the same in all frames, and notes in `parts` where frames find it.
/// The models must have been written.
Errors write_light(const Scene& scene, FrameParts& parts, const std::filesystem::path& folder);

/// Draws the pictures of bark and leaves that are not there yet.
Errors write_drawings(const Scene& scene, const std::filesystem::path& folder, const ProgressSink& watch);

/// Writes pictures, or other files that frames include, into a folder.
Errors write_pictures(const std::filesystem::path& folder, const std::vector<Picture>& pictures);

struct FrameFile {
  bool changed = false;   ///< it was not there just so
  std::size_t nodes = 0;  ///< that growth has reached in it
};

/// Writes one frame, or one exposure of it as write_frame() has it, into a folder under its exposure_name(),
/// with its soft light where that is its own; that of a frame serves all its exposures.
Result<FrameFile> write_frame_file(const Scene& scene, const FrameParts& parts, const std::string& layout,
                                   const std::filesystem::path& folder, int frame, int exposure = 0);

}  // namespace frond
