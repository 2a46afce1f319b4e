#pragma once

#include <memory>
#include <vector>

#include "scene/scene.h"

namespace frond {

/// The far land round a scene's ground as the cameras of its film see it; null where its setting has none.
std::shared_ptr<const FarCountry> far_land_round(const Scene& scene, Seed seed);

/// What all cameras of a film have in view.
FarView far_view(const Film& film, const Camera& camera);

/// The far land in plain colours, for quick looks; refers to it.
std::vector<Strewn> strewn_far(const FarCountry& far);

}  // namespace frond
