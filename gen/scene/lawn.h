#pragma once

#include "geometry/ground.h"
#include "scene/scene.h"

namespace frond {

/// Lays the floor of a meadow or garden, with the pond of a garden and what floats on it. The scene's film
/// and stage are set.
void lay_lawn(Scene& scene, const Ground& ground, Seed seed);

/// Covers that floor, whose heights are given: grass, and gravel on the path.
void cover_lawn(Scene& scene, const Heights& heights, Seed seed);

}  // namespace frond
