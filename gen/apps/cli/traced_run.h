#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "cli/heartbeat.h"
#include "cli/inputs.h"
#include "core/work_folder.h"
#include "scene/scene.h"

namespace frond {

/// Frames of a preset that are traced without POV-Ray, and the folder that their pictures go to.
struct TracedRun {
  Heartbeat heartbeat;
  FrameRange range;
  std::filesystem::path out;
  WorkFolder models;  ///< files of sown models are in its folder `frames`
  std::optional<Scene> scene;
  std::optional<TracedFilm> film;

  /// Grows the scene. `arguments` has `preset`, `frames`, the last one without, and `out`, which is
  /// out/<preset name>/<kind> where it is empty. What is wrong is told; the exit code, kDone where all is
  /// well.
  template <class Arguments>
  int begin(const Preset& preset, const Arguments& arguments, const char* kind) {
    out = arguments.out;
    if (out.empty())
      out = std::filesystem::path("out") / std::filesystem::path(arguments.preset.path).stem() / kind;
    return begin(preset, arguments.frames);
  }

 private:
  int begin(const Preset& preset, const std::optional<std::string>& frames);
};

}  // namespace frond
