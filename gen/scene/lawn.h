#pragma once

#include "geometry/ground.h"
#include "scene/scene.h"

namespace frond {

/// Lays the floor of a meadow or garden, with the pond of a garden and what floats on it. The scene's film
/// and stage are set; `reach` metres from the middle is as far as anything stands.
void lay_lawn(Scene& scene, const Ground& ground, double reach, Seed seed);

/// Covers that floor, whose heights are given: grass, and gravel on the path.
void cover_lawn(Scene& scene, const Heights& heights, Seed seed);

}  // namespace frond
