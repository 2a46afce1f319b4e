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

/// Points on the outside of the organ of that name, of the organisms of those names, that shows best from
/// where the camera stands: of the large ones the nearest to it, with as much room round it as it is wide; as
/// it is at the beginning of the film. Of what is sown the nearest copy that bears it counts. None where
/// they bear none.
std::vector<Vec3> outside_of_part(const Scene& scene, const std::vector<std::string>& names,
                                  std::string_view part);

/// The names of the organs that these organisms bear.
std::vector<std::string> organ_names(const Scene& scene, const std::vector<std::string>& names);

/// The camera moved, at each of its keyframes, to where the points fill its picture but for its margins. It
/// goes on looking the same way, unless that took it under the ground: then it stands on that and turns.
/// Where it has a composition, it is turned about the vertical until the light falls as that says, and stands
/// as high above the ground as it says, with the points in their third of the picture. Close to a
/// part it focuses on that, its aperture no wider than f/11. `aspect`: height of
/// the picture by its width; `sun`: direction towards the light.
Camera fitted(const Camera& camera, const std::vector<Vec3>& points, double aspect, const Heights& heights,
              Vec3 sun);

}  // namespace frond
