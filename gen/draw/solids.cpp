#include "draw/solids.h"

#include <algorithm>
#include <cmath>

#include "core/bounds.h"
#include "core/parallel.h"
#include "geometry/far.h"

namespace frond {

namespace {

constexpr double kSidePixels[] = {2.2, 1.5, 1.0};  // that a triangle is long, at each quality

/// How many pixels a metre is where the camera comes nearest to a place over the film.
double nearest_pixels(const Film& film, const Camera& camera, Vec3 middle, float reach) {
  double most = 0;
  for (int frame = 1; frame <= film.frames; ++frame) {
    double time = film.time(frame);
    double away = std::max(0.05f, glm::distance(camera.location.at(time), middle) - reach);
    most = std::max(most, film.size[0] / (2 * away * std::tan(radians(camera.angle.at(time)) / 2)));
  }
  return most;
}

bool is_growing(const Solid& solid, const Growth& growth) {
  return !solid.past.empty() && growth.duration > 0;
}

/// The shapes that are wanted and stand somewhere.
template <class Wanted>
std::vector<DrawnBody> placed_shapes(const Solids& solids, const Wanted& wanted) {
  std::vector<DrawnBody> all(solids.shapes.size()), placed;
  for (std::size_t i = 0; i < solids.size(); ++i)
    all[solids.shape[i]].places.push_back({solids.position[i], solids.turn[i], solids.scale[i]});
  for (std::size_t s = 0; s < all.size(); ++s) {
    if (all[s].places.empty() || !wanted(solids.shapes[s])) continue;
    all[s].solid = &solids.shapes[s], all[s].shape = s;
    placed.push_back(std::move(all[s]));
  }
  return placed;
}

}  // namespace

std::vector<DrawnBody> still_bodies(const Solids& solids, const Growth& growth) {
  return placed_shapes(solids, [&](const Solid& solid) { return !is_growing(solid, growth); });
}

std::vector<DrawnBody> growing_bodies(const Solids& solids, const Growth& growth, double time) {
  auto front = static_cast<float>(growth_front(growth, time));
  if (front <= 0) return {};
  std::vector<DrawnBody> bodies =
      placed_shapes(solids, [&](const Solid& solid) { return is_growing(solid, growth); });
  for (DrawnBody& body : bodies)
    body.now = surface_at(*body.solid, front), body.front = std::min(static_cast<double>(front), 1.0);
  return bodies;
}

double drawn_edge(const Film& film, const Camera& camera, Vec3 middle, float reach) {
  return kSidePixels[static_cast<std::size_t>(film.quality)] / nearest_pixels(film, camera, middle, reach);
}

Solid with_edges(const Solid& solid, double edge) {
  auto triangles = static_cast<std::size_t>(area(solid.surface) / (0.43 * edge * edge));
  if (triangles >= solid.surface.triangle.size()) return solid;
  std::vector<std::uint32_t> kept;
  Solid less{reduced(solid.surface, std::max<std::size_t>(triangles, 400), &kept), solid.material};
  if (kept.empty()) return solid;
  for (const std::vector<Vec3>& step : solid.past) {
    std::vector<Vec3>& places = less.past.emplace_back();
    for (std::uint32_t v : kept) places.push_back(step[v]);
  }
  for (std::uint32_t v : solid.light.empty() ? std::vector<std::uint32_t>() : kept)
    less.light.push_back(solid.light[v]);
  return less;
}

Surface with_light_uv(Surface skin, const Solid& solid) {
  Matter m = solid.material.matter;
  for (std::size_t v = 0; is_tissue(m) && v < skin.uv.size(); ++v)
    skin.uv[v][m == Matter::meander ? 1 : 0] = solid.light.empty() ? 1 : solid.light[v];
  return skin;
}

DrawnSolids drawn_solids(const Scene& scene) {
  DrawnSolids drawn(scene.specimens.size());
  parallel_for(drawn.size(), [&](std::size_t i) {
    const Solids& solids = scene.specimens[i].model.solids;
    for (std::size_t k = 0; k < solids.size(); ++k) {
      const Solid& solid = solids.shapes[solids.shape[k]];
      if (!is_of_reef(solid.material.matter)) continue;
      Bounds box;
      for (const Vec3& p : solid.surface.position) box.take(solids.placed(k, p));
      double edge = drawn_edge(scene.film, scene.stage.camera, box.middle(), glm::length(box.size()) / 2) /
                    solids.scale[k].x;
      Solid coarse = with_edges(solid, edge);
      if (coarse.surface.triangle.size() == solid.surface.triangle.size()) continue;
      if (!drawn[i]) drawn[i] = solids;
      drawn[i]->shapes[solids.shape[k]] = std::move(coarse);
    }
  });
  return drawn;
}

const Solids& solids_of(const DrawnSolids& drawn, const Scene& scene, std::size_t organism) {
  return organism < drawn.size() && drawn[organism] ? *drawn[organism]
                                                    : scene.specimens[organism].model.solids;
}

}  // namespace frond
