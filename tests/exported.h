#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/files.h"
#include "scene/scene.h"

namespace frond {

/// The scene of a preset's text.
inline Scene scene_of_text(const std::string& text, const std::string& file = "text.json",
                           const std::vector<std::string>& sets = {}) {
  Result<Preset> preset = read_preset(text, file, sets);
  EXPECT_TRUE(preset) << preset.errors()[0].text();
  Result<Scene> scene = build_scene(*preset);
  EXPECT_TRUE(scene) << scene.errors()[0].text();
  return std::move(*scene);
}

/// That of a file below Frond's folder.
inline Scene scene_of_file(const std::string& file, const std::vector<std::string>& sets = {}) {
  std::string path = std::string(FROND_ROOT) + "/" + file;
  return scene_of_text(*read_file(path), path, sets);
}

}  // namespace frond
