#pragma once

#include <optional>
#include <vector>

#include "draw/organs.h"
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

/// A shape as it is at one time, and where it stands.
struct DrawnBody {
  const Solid* solid = nullptr;
  std::size_t shape = 0;  ///< its number in the solids
  std::optional<Surface>
      now;           ///< of what a film sees grow: how far it has come; else it is as the solid has it
  double front = 1;  ///< share of its growth that it has reached, 0..1
  std::vector<DrawnPlace> places;

  const Surface& surface() const { return now ? *now : solid->surface; }
};
/// The bodies that are the same in the whole film, in the order of their shapes. Refers to the solids.
std::vector<DrawnBody> still_bodies(const Solids& solids, const Growth& growth);
/// Those that a film sees grow, if they have begun to.
std::vector<DrawnBody> growing_bodies(const Solids& solids, const Growth& growth, double time);

/// The solids of each organism as a film draws them, where that is otherwise than they are: what lives has no
/// more triangles than show from where the camera comes nearest.
using DrawnSolids = std::vector<std::optional<Solids>>;
DrawnSolids drawn_solids(const Scene& scene);
/// Those of one organism.
const Solids& solids_of(const DrawnSolids& drawn, const Scene& scene, std::size_t organism);

}  // namespace frond
