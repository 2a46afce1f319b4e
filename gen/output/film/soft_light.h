#pragma once

#include <span>
#include <string>
#include <vector>

#include "draw/surfels.h"
#include "emit/pov.h"
#include "light/light.h"
#include "scene/scene.h"

namespace frond {

/// How large the grids are that the soft light of a scene's ground is worked out in, with things on it that
/// rise to `tall` metres.
SoftLight::Size estimate_light(const Scene& scene, double tall);

/// How many metres from where it was worked out soft light serves, where a pixel is so many.
double light_reach(Quality quality, double pixel);

/// How often the cube of each surfel of a copy set's model has to be halved, so that its copies next to the
/// camera have finer ones; 0: it is fine enough.
std::vector<int> wanted_halvings(const Scene& scene, std::size_t copy_set, int model,
                                 const std::vector<Surfel>& surfels);

/// Whether the soft light is another in each frame: where something grows, becomes another shape or comes so
/// far from where it is in the first frame that it would be dark, or the sun moves. What sways a little keeps
/// the light of the first frame. `pixel`: nearest_pixels().
bool light_changes(const Scene& scene, std::span<const double> pixel);

/// The soft light of a scene at a time, as POV-Ray's radiosity keeps it in files (+RFI): each line a place, a
/// direction and the light that comes from the half of all directions round it. Empty where the setting
/// brings lamps of its own instead. Where it `changes`, it is as fine as the camera needs at that time alone.
Result<std::string> soft_light_text(const PovSpace& space, const Scene& scene, const Surfels& surfels,
                                    double time, bool changes);

}  // namespace frond
