#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace frond {

/// Points on the outside of the named organisms as they are when they have grown, some hundred: no plane has
/// more of the organisms before it than of these points by more than a hundredth of their size. For organisms
/// that are sown the room that each copy takes counts.
std::vector<Vec3> outside_of(const Scene& scene, const std::vector<std::string>& names);

/// Points on the outside of one model, some hundred.
std::vector<Vec3> outside_of(const Model& model);

/// The camera moved, at each of its keyframes, to where the points fill its picture but for its margins. It
/// goes on looking the same way, unless that took it under the ground: then it stands on that and turns.
/// `aspect`: height of the picture by its width.
Camera fitted(const Camera& camera, const std::vector<Vec3>& points, double aspect, const Heights& heights);

}  // namespace frond
