#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/text.h"
#include "emit/setting.h"
#include "settings/lawn.h"

// What the texts of several settings are put together from.

namespace frond {

std::string direction_text(Vec3 v);
std::string color_text(const Color& c);

/// Where the camera stands and what it looks at, in POV-Ray's axes and metres.
std::string eye_text(const Scene& scene, double time);
std::string look_text(const Scene& scene, double time);

/// The floor as an object with a texture.
std::string floor_text(const PovSpace& space, const Scene& scene, std::string_view texture);

/// Appends `Turf12`.
void append_name(std::string& text, std::string_view name, std::size_t index);

/// Declares shapes as Gravel0, Gravel1, ...
void append_shapes(std::string& text, const PovSpace& space, const std::vector<Surface>& shapes,
                   std::string_view name);

/// One union of all patches whose shape of that name there is, with the texture on it.
void append_patches(std::string& text, const PovSpace& space, const std::vector<Patch>& patches,
                    std::string_view name, std::string_view texture, const std::vector<bool>& missing = {});

/// The sky at some hour: linear colours of light.
struct Daytime {
  Vec3 sun{0, 1, 0};  ///< toward it, or the moon; of length 1
  Vec3 zenith{0}, horizon{0}, sunlight{0};
  Vec3 glow{0};   ///< what the sun adds to the sky round it
  Vec3 cloud{1};  ///< of lit clouds
};

/// The sky when the sun stands there. At night the moon stands where the sun would be by day, dim and blue;
/// at dusk light comes from the horizon.
Daytime daytime(Vec3 sun);

/// `<zenith>,<horizon>` and `<sun>,<sunlight>,<glow>,<cloud>`: arguments of macros.
std::string sky_text(const Daytime& day);
std::string sun_text(const Daytime& day);

/// What shines under that sky over a ground of that colour.
Ambience ambience(const Daytime& day, const Color& ground);

/// A lawn of a colour, with its grass and gravel.
std::string lawn_text(const PovSpace& space, const Scene& scene, const Color& grass, const Color& gravel);

}  // namespace frond
