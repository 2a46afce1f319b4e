#pragma once

#include <filesystem>
#include <string>

#include "emit/frame.h"
#include "passes/frame_passes.h"

namespace frond {

/// The colours of surfaces as POV-Ray's textures have them, without light.
class Albedo {
 public:
  /// The albedo of a scene, which must outlive it. What POV-Ray reads, and models, are written into a folder.
  static Result<Albedo> of(Scene& scene, const std::filesystem::path& folder);

  /// Adds the colours to the passes of that frame.
  Errors add_to(FramePasses& passes, int frame) const;

 private:
  Albedo(Scene& scene, std::filesystem::path folder) : scene_(scene), folder_(std::move(folder)) {}
  Errors write_scene(int frame) const;

  Scene& scene_;
  std::filesystem::path folder_;
  FrameParts parts_;
  std::string layout_;
};

}  // namespace frond
