#pragma once

#include <string>
#include <vector>

#include "emit/pov.h"
#include "scene/scene.h"

namespace frond {

/// The skin of a solid with the `uv` that its texture asks for: tissue is told how much light it has, valleys
/// in v, all others in u, which say nothing of their own there.
Surface with_light_uv(Surface skin, const Solid& solid);

/// Whether it is a living skin, or the rock that such skins made.
bool lives(const Material& material);

/// About how long a side of a triangle is that shows, metres, of what lies round a place, up to `reach` away,
/// from where the camera comes nearest over the film.
double drawn_edge(const Film& film, const Camera& camera, Vec3 middle, float reach);

/// The same solid of triangles that are about so long, metres; as it is where its own are no shorter.
Solid with_edges(const Solid& solid, double edge);

/// Appends the share of growth that what lives has reached, by which its texture knows what is young.
void append_front(std::string& text, double front);

/// The names of the povinc files that the solids of a scene need, each once, as `stone` for frond_stone.inc.
std::vector<std::string_view> solid_includes(const Scene& scene);

/// The `texture{...}` of a material, and what is inside; the name of the povinc file that it needs.
std::string material_text(const Material& material);
std::string_view material_include(const Material& material);

/// The solids of each organism as a film draws them, where that is otherwise than they are: what lives has no
/// more triangles than show from where the camera comes nearest.
using DrawnSolids = std::vector<std::optional<Solids>>;
DrawnSolids drawn_solids(const Scene& scene);
/// Those of one organism.
const Solids& solids_of(const DrawnSolids& drawn, const Scene& scene, std::size_t organism);

/// Declares the shapes of all solids and places them, but for those that a film sees grow or become others;
/// the same in each frame. Without `drawn` they are written as they are.
ObjectText solids_text(const PovSpace& space, const Scene& scene, const DrawnSolids& drawn = {});

/// The solids of an organism that becomes another shape, as it is now.
ObjectText developed_solids_text(const PovSpace& space, const Solids& solids, std::size_t organism);

/// The solids of one organism that a film sees grow, as they are at a time.
ObjectText growing_solids_text(const PovSpace& space, const Solids& solids, const Growth& growth,
                               double time);

}  // namespace frond
