#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "draw/organs.h"
#include "scene/scene.h"

// The bodies of organisms and the floor, as fine as they are drawn.

namespace frond {

/// The skin of a solid with the `uv` that its texture asks for: tissue is told how much light it has, valleys
/// in v, all others in u, which say nothing of their own there.
Surface with_light_uv(Surface skin, const Solid& solid);

/// About how many triangles of a skin with `uv`, m2 of so many triangles, coarser() leaves where a pixel is
/// so many metres: a fit to plates, cushions and tables with edges of 1.8 to 6 mm, which holds within a
/// factor 2.
double left_triangles(double triangles, double area, double pixel, Quality quality);

/// Which triangles a surface is drawn with where fewer show than it has. It holds for all surfaces of as many
/// vertices, which must have the same triangles, so nothing pops while one of them grows or moves.
struct Coarser {
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< their corners are numbers in `kept`
  std::vector<std::uint32_t> kept;                      ///< vertices of the surface
  /// Triangles of the last of `kept`, whose normals are those of these alone: what rounded an edge is gone.
  std::vector<std::uint32_t> flat;
  std::size_t vertices = 0;  ///< how many the surface has
};
/// The triangles of a surface whose pixels are so many metres: none where all of it shows. `edged`: the
/// surface may have rounded edges between flat faces.
std::optional<Coarser> coarser(const Surface& whole, double pixel, Quality quality, bool edged = true);
/// The triangles of a solid whose pixels are so many metres: none where all of it shows, or POV-Ray has a
/// shape of its own for it.
std::optional<Coarser> coarser(const Solid& solid, double pixel, Quality quality);
Surface drawn_coarser(const Surface& whole, const Coarser& coarser);
Solid drawn_coarser(const Solid& solid, const Coarser& coarser);

/// A shape as it is at one time, and where it stands.
struct DrawnBody {
  const Solid* solid = nullptr;
  std::size_t shape = 0;  ///< its number in the solids
  std::optional<Surface>
      now;           ///< the surface at that time, where a film sees it grow; empty: that of `solid`
  double front = 1;  ///< share of its growth that it has reached, 0..1
  std::vector<OrganPlace> places;

  const Surface& surface() const { return now ? *now : solid->surface; }
};
/// Whether a film sees it grow.
bool is_growing(const Solid& solid, const Growth& growth);

/// Calls `visit(number, solid, skin, front)` for each of the solids that has `places`, with its skin at a
/// time, if it has begun to grow.
template <class Places, class Visit>
void each_grown_skin(const Solids& solids, const std::vector<Places>& places, const Growth& growth,
                     double time, const Visit& visit) {
  auto front = static_cast<float>(growth_front(growth, time));
  if (front <= 0) return;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    const Solid& solid = solids.shapes[solids.shape[i]];
    if (!places[i].empty()) visit(i, solid, surface_at(solid, front), front);
  }
}

/// The bodies that are the same in the whole film, in the order of their shapes. Refers to the solids.
std::vector<DrawnBody> still_bodies(const Solids& solids, const Growth& growth);
/// The bodies that a film sees grow, if they have begun to.
std::vector<DrawnBody> growing_bodies(const Solids& solids, const Growth& growth, double time);

/// The floor of a scene, of triangles as large as lets it show nowhere in the film.
Surface drawn_floor(const Scene& scene);

/// The solids of each organism as a film draws them: with no more triangles than show from where the camera
/// comes nearest.
struct DrawnSolids {
  std::vector<std::optional<Solids>> still;  ///< where those of the scene are finer than that
  /// The triangles of each shape, for organisms whose shapes are others at each time.
  std::vector<std::vector<std::optional<Coarser>>> developed;

  const Solids& of(const Scene& scene, std::size_t organism) const;
  /// The solids `now` of an organism that develops, as a film draws them.
  Solids of(std::size_t organism, const Solids& now) const;
};
DrawnSolids drawn_solids(const Scene& scene);

}  // namespace frond
