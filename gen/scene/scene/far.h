#pragma once

#include <optional>
#include <vector>

#include "scene/scene.h"

namespace frond {

/// The far land round a scene's ground as the cameras of its film see it; nothing where its setting has none.
std::optional<DistantTerrain> far_land_round(const Scene& scene, Seed seed);

/// Makes copies of the organisms that `scene.far.trees` names of the trees of the far land: they go over into
/// `scene.copy_sets`, whose models are drawn as coarsely as they are small.
void plant_far_trees(Scene& scene, const Preset& preset, DistantTerrain& far, Seed seed);

/// What all cameras of a film have in view.
FarView far_view(const Film& film, const Camera& camera);

/// The far land in plain colours, for quick looks; refers to it.
std::vector<ScatteredInstances> strewn_far(const DistantTerrain& far);

}  // namespace frond
