#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "emit/setting.h"
#include "settings/meadow.h"

// What the texts of several settings are put together from.

namespace frond {

std::string direction_text(Vec3 v);
std::string color_text(const Color& c);
/// `rgb <r,g,b>` of linear light.
std::string light_text(Vec3 light);

/// Where the camera stands and what it looks at, in POV-Ray's axes and metres.
std::string eye_text(const Scene& scene, double time);
std::string look_text(const Scene& scene, double time);

/// The floor as an object with a texture.
std::string floor_text(const PovSpace& space, const Scene& scene, std::string_view texture);

/// Declares shapes as Gravel0, Gravel1, ...
void append_shapes(std::string& text, const PovSpace& space, const std::vector<Surface>& shapes,
                   std::string_view name);

/// One union of all patches whose shape of that name there is, with the texture on it.
void append_patches(std::string& text, const PovSpace& space, const std::vector<Patch>& patches,
                    std::string_view name, std::string_view texture, const std::vector<bool>& missing = {});

/// The sky: its colours in all directions as `Sky_Clear`, with clouds and the sun's glare before it.
std::string sky_text(const Sky& sky, double clouds);

/// `<zenith>,<horizon>` and `<lamp>,<lamplight>`: arguments of macros.
std::string air_text(const Sky& sky);
std::string lamp_text(const Sky& sky);

/// That sky with haze under it; `air`: light of the haze.
std::string country_text(const Sky& sky, const Meadow& meadow, Vec3 air);

/// `<r,g,b>` of linear light: an argument of macros.
std::string vector_text(Vec3 light);
/// The global settings by the macro of a setting's file, as `Meadow` for Meadow_Globals().
std::string globals_text(std::string_view prefix);
/// What of the year the ground shows is declared by each frame under these names.
inline constexpr std::string_view kYearGrass = "Year_Grass", kYearLitter = "Year_Litter";

/// The air before the far land and the time of its year, as a frame has them. The scene must have far land.
std::string far_air_text(const Scene& scene, double time);

/// The far land with all that stands on it, the same in each frame.
std::string far_text(const PovSpace& space, const Scene& scene);

/// A lawn of a colour, with its grass, gravel and bare earth.
std::string lawn_text(const PovSpace& space, const Scene& scene, const Color& grass, const Color& gravel,
                      const Color& earth);

}  // namespace frond
