#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "emit/pov.h"
#include "scene/scene.h"

namespace frond {

/// How a setting is written: a row a setting, in the order of settings().
struct SettingText {
  std::vector<std::string_view> includes;  ///< files of povinc, as `sand` for frond_sand.inc
  /// The surroundings as the camera sees them at one time: light, air and backdrop.
  std::string (*surroundings)(const Scene& scene, double time);
  /// The ground with what lies on it; the same in each frame.
  std::string (*ground)(const PovSpace& space, const Scene& scene);
  /// Pictures that its text names at a time, to be put beside the frame; null where there are none.
  Result<std::vector<Picture>> (*pictures)(const Scene& scene, double time) = nullptr;
  /// What stands in the texture of a floor that nothing covers.
  std::string_view bare_floor = {};
  bool sky = false;  ///< whether its surroundings have a sky all around
};

/// The texture of a setting's floor, for what draws it by itself.
struct FloorTexture {
  std::vector<std::string_view> includes;  ///< as those of SettingText
  std::string_view inside;                 ///< of `texture{}`; its y is up
};
/// None where there is no floor, or grass or litter covers it.
std::optional<FloorTexture> floor_texture(const SceneSetup& setup);

/// The `#include` lines of the files that a scene needs.
std::string includes_text(const Scene& scene);

/// The sky alone as a scene that a spherical camera looks at from where the scene's is, for a picture twice
/// as wide as high, north (-z) in its middle; none where there is no sky, or it is another in each frame.
std::optional<std::string> sky_scene_text(const PovSpace& space, const Scene& scene);

std::string setting_text(const Scene& scene, double time);
Result<std::vector<Picture>> setting_pictures(const Scene& scene, double time);
/// Whether its light may be a picture that each frame has of its own, as that through waves is.
bool has_pictures(const SceneSetup& setup);
std::string ground_text(const PovSpace& space, const Scene& scene);
/// What drifts over the ground at a time: each shape, and an object of it for each place.
std::string adrift_text(const PovSpace& space, const Scene& scene, double time);

}  // namespace frond
