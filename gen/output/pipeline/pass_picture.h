#pragma once

#include <filesystem>
#include <string>

#include "core/result.h"
#include "passes/frame_passes.h"

namespace frond {

/// A scene made to be traced, with its sown models, whose files are kept in that folder.
Result<TracedFilm> traced_film(const Scene& scene, const std::filesystem::path& models);

/// The passes of a frame as the bytes of an OpenEXR picture, with masks of entries, organisms and parts as
/// Cryptomatte has them; docs/data.md names its channels.
Result<std::string> pass_picture(const Scene& scene, const FramePasses& passes);

}  // namespace frond
