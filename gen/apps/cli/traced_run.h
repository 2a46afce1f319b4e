#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "cli/heartbeat.h"
#include "cli/inputs.h"
#include "core/work_folder.h"
#include "passes/traced_film.h"
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

  /// Grows the scene; `to` is the folder, of frames the last one is there without. Fails where something is
  /// wrong.
  void begin(const Preset& preset, const std::filesystem::path& to, const std::optional<std::string>& frames);
};

}  // namespace frond
