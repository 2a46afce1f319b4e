#pragma once

#include <vector>

#include "light/light.h"
#include "scene/scene.h"

namespace frond {

/// What the camera sees at a time.
Eye eye_at(const Film& film, const Camera& camera, double time);
inline Eye eye_at(const Scene& scene, double time) { return eye_at(scene.film, scene.setup.camera, time); }

/// By how much the samples of a frame lie aside of the middles of their pixels, to the right and down;
/// pixels, -0.5..0.5. Those of successive frames are spread evenly (Halton). 0 where the film is not raw, or
/// a still.
Vec2 sample_shift(const Film& film, int frame);

/// What the camera sees at each frame of the film.
std::vector<Eye> eyes(const Film& film, const Camera& camera);
inline std::vector<Eye> eyes(const Scene& scene) { return eyes(scene.film, scene.setup.camera); }

/// What the camera sees at the frames of the film, without those that are like the one before.
std::vector<Eye> different_eyes(const Scene& scene);

/// Metres that a pixel is, where the eyes come nearest to what lies round a place, up to `reach` away. What
/// none has in view, which may throw a shadow or be reflected, needs to be less fine: there it is `unseen`
/// times as much.
double nearest_pixel(const std::vector<Eye>& eyes, Vec3 at, double reach, double unseen = 1);

/// Metres that a pixel is at the node, organ or body of each organism that comes nearest to the camera in the
/// film.
std::vector<double> nearest_pixels(const Scene& scene);

}  // namespace frond
