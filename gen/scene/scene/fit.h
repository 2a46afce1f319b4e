#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace frond {

/// Points on the outside of the named organisms as they are when they have grown, some hundred: no plane
/// has more of them before it than these by more than a hundredth of their size. Of what is sown, its room.
std::vector<Vec3> outside_of(const Scene& scene, const std::vector<std::string>& names);

/// The same of one model.
std::vector<Vec3> outside_of(const Model& model);

/// The camera moved, at each of its keyframes, to where the points fill its picture but for its margins. It
/// goes on looking the same way, unless that took it under the ground: then it stands on that and turns.
/// `aspect`: height of the picture by its width.
Camera fitted(const Camera& camera, const std::vector<Vec3>& points, double aspect, const Heights& heights);

}  // namespace frond
