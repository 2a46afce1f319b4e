#pragma once

#include <optional>
#include <vector>

#include "scene/scene.h"

// The bodies of organisms, as fine as they are drawn.

namespace frond {

/// The skin of a solid with the `uv` that its texture asks for: tissue is told how much light it has, valleys
/// in v, all others in u, which say nothing of their own there.
Surface with_light_uv(Surface skin, const Solid& solid);

/// About how long a side of a triangle is that shows, metres, of what lies round a place, up to `reach` away,
/// from where the camera comes nearest over the film.
double drawn_edge(const Film& film, const Camera& camera, Vec3 middle, float reach);

/// The same solid of triangles that are about so long, metres; as it is where its own are no shorter.
Solid with_edges(const Solid& solid, double edge);

/// Whether a film sees it grow.
bool is_growing(const Solid& solid, const Growth& growth);

/// The solids of each organism as a film draws them, where that is otherwise than they are: what lives has no
/// more triangles than show from where the camera comes nearest.
using DrawnSolids = std::vector<std::optional<Solids>>;
DrawnSolids drawn_solids(const Scene& scene);
/// Those of one organism.
const Solids& solids_of(const DrawnSolids& drawn, const Scene& scene, std::size_t organism);

}  // namespace frond
