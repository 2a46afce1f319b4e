#include "draw/solids.h"

#include <algorithm>
#include <cmath>

#include "core/bounds.h"
#include "core/parallel.h"
#include "draw/eyes.h"
#include "geometry/far.h"

namespace frond {

namespace {

// At each quality, in pixels:
constexpr double kOffPixels[] = {0.2, 0.16, 0.12};  // by how much a surface may be away from where it is
constexpr double kSidePixels[] = {2.2, 1.5, 1.0};   // how long a side of a triangle is where all of them show
constexpr double kPatternShare = 0.6;  // of kOffPixels, where what is drawn, perhaps by heights, goes by `uv`
constexpr std::size_t kFlat = 16;      // times as large may triangles be that have `uv`
constexpr float kSmooth = 0.8f;        // cosine of how far a normal may be from that of its triangle
constexpr double kUnseenPixels = 4;    // as coarse is what only throws a shadow
constexpr std::size_t kLeastTriangles = 100;
constexpr double kTriangleArea = 0.43;  // of a triangle with sides of 1: sqrt(3) / 4

/// How many triangles of a surface of an area, m2, still show where a pixel is so many metres.
double most_triangles(double area, double pixel, Quality quality) {
  double edge = kSidePixels[static_cast<std::size_t>(quality)] * pixel;
  return area / (kTriangleArea * edge * edge);
}

/// The normal of a triangle, of length 1; +y where the triangle has no size.
Vec3 facing_of(const std::vector<Vec3>& position, const Coarser& coarser,
               const std::array<std::uint32_t, 3>& triangle) {
  auto at = [&](std::size_t c) { return position[coarser.kept[triangle[c]]]; };
  return direction_or(glm::cross(at(1) - at(0), at(2) - at(0)), Vec3(0, 1, 0));
}

/// The values at the vertices that are kept, given those at all vertices, or at none.
template <class T>
std::vector<T> kept_of(const std::vector<T>& all, const Coarser& coarser) {
  std::vector<T> some;
  for (std::size_t k = 0; !all.empty() && k < coarser.kept.size(); ++k) some.push_back(all[coarser.kept[k]]);
  return some;
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

bool is_growing(const Solid& solid, const Growth& growth) {
  return !solid.past.empty() && growth.duration > 0;
}

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

double left_triangles(double triangles, double area, double pixel, Quality quality) {
  constexpr double kHalved = 0.055, kSlope = 1.25;  // errors in edges that leave a half, and how that goes on
  double edge = std::sqrt(area / (kTriangleArea * triangles));
  double off = kPatternShare * kOffPixels[static_cast<std::size_t>(quality)] * pixel / edge;
  return std::min(triangles / (1 + std::pow(off / kHalved, kSlope)), most_triangles(area, pixel, quality));
}

std::optional<Coarser> coarser(const Surface& whole, double pixel, Quality quality, bool edged) {
  if (pixel <= 0 || whole.triangle.size() <= kLeastTriangles) return std::nullopt;
  auto most = static_cast<std::size_t>(most_triangles(area(whole), pixel, quality));
  double off = kOffPixels[static_cast<std::size_t>(quality)] * pixel * (whole.uv.empty() ? 1 : kPatternShare);
  Coarser made;
  std::size_t least = whole.uv.empty() ? kLeastTriangles / 4 : std::max(most / kFlat, kLeastTriangles / 4);
  made.triangles = reduced_within(whole, off, least, std::max(most, kLeastTriangles), &made.kept).triangle;
  if (made.kept.empty()) return std::nullopt;
  made.vertices = whole.position.size();
  for (std::uint32_t t = 0; edged && t < made.triangles.size(); ++t) {
    Vec3 facing = facing_of(whole.position, made, made.triangles[t]);
    for (std::uint32_t& corner : made.triangles[t]) {
      std::uint32_t v = made.kept[corner];
      if (glm::dot(facing, whole.normal[v]) >= kSmooth) continue;
      corner = static_cast<std::uint32_t>(made.kept.size());
      made.kept.push_back(v);
      made.flat.push_back(t);
    }
  }
  return made;
}

std::optional<Coarser> coarser(const Solid& solid, double pixel, Quality quality) {
  if (solid.native || !solid.turned.empty()) return std::nullopt;
  return coarser(solid.surface, pixel, quality, !is_of_reef(solid.material.matter));
}

Surface drawn_coarser(const Surface& whole, const Coarser& coarser) {
  Surface drawn{kept_of(whole.position, coarser), kept_of(whole.normal, coarser), coarser.triangles,
                kept_of(whole.uv, coarser)};
  for (std::size_t k = 0, first = drawn.normal.size() - coarser.flat.size(); k < coarser.flat.size(); ++k)
    drawn.normal[first + k] = facing_of(whole.position, coarser, coarser.triangles[coarser.flat[k]]);
  return drawn;
}

Solid drawn_coarser(const Solid& solid, const Coarser& coarser) {
  Solid less{drawn_coarser(solid.surface, coarser), solid.material};
  less.light = kept_of(solid.light, coarser);
  for (const std::vector<Vec3>& step : solid.past) less.past.push_back(kept_of(step, coarser));
  return less;
}

Surface with_light_uv(Surface skin, const Solid& solid) {
  Matter m = solid.material.matter;
  for (std::size_t v = 0; is_tissue(m) && v < skin.uv.size(); ++v)
    skin.uv[v][m == Matter::meander ? 1 : 0] = solid.light.empty() ? 1 : solid.light[v];
  return skin;
}

Surface drawn_floor(const Scene& scene) {
  constexpr std::uint32_t kTiles = 24;  // along each side
  const Surface& floor = scene.ground->floor();
  Bounds box = bounds_of(floor.position);
  if (floor.triangle.size() <= kLeastTriangles) return floor;
  Vec3 side = glm::max(box.size() / static_cast<float>(kTiles), Vec3(1e-6f));
  std::vector<std::uint32_t> tile;
  std::vector<Bounds> boxes(kTiles * kTiles);
  for (const auto& t : floor.triangle) {
    Vec3 middle = (floor.position[t[0]] + floor.position[t[1]] + floor.position[t[2]]) / 3.0f;
    auto along = [&](int axis) {
      return std::min(static_cast<std::uint32_t>((middle[axis] - box.low[axis]) / side[axis]), kTiles - 1);
    };
    tile.push_back(along(0) * kTiles + along(2));
    for (std::uint32_t v : t) boxes[tile.back()].extend(floor.position[v]);
  }
  std::vector<Eye> all = different_eyes(scene);
  std::vector<double> error;
  for (const Bounds& own : boxes)
    error.push_back(kOffPixels[static_cast<std::size_t>(scene.film.quality)] *
                    nearest_pixel(all, own.middle(), glm::length(own.size()) / 2, kUnseenPixels));
  return reduced_tiles(floor, tile, error);
}

DrawnSolids drawn_solids(const Scene& scene) {
  std::size_t n = scene.specimens.size();
  DrawnSolids drawn{std::vector<std::optional<Solids>>(n),
                    std::vector<std::vector<std::optional<Coarser>>>(n)};
  std::vector<Eye> all = different_eyes(scene);
  parallel_for(n, [&](std::size_t i) {
    const Specimen& specimen = scene.specimens[i];
    const Solids& solids = specimen.model.solids;
    std::vector<double> pixel(solids.shapes.size(), 1e30);
    for (std::size_t k = 0; k < solids.size(); ++k) {
      Bounds box;
      for (const Vec3& p : solids.shapes[solids.shape[k]].surface.position) box.extend(solids.placed(k, p));
      double seen = nearest_pixel(all, box.middle(), glm::length(box.size()) / 2, kUnseenPixels);
      Vec3 scale = solids.scale[k];
      pixel[solids.shape[k]] = std::min(pixel[solids.shape[k]], seen / std::max({scale.x, scale.y, scale.z}));
    }
    std::vector<std::optional<Coarser>>& made = drawn.developed[i];
    for (std::size_t s = 0; s < pixel.size(); ++s)
      made.push_back(coarser(solids.shapes[s], pixel[s], scene.film.quality));
    if (specimen.life.develop) return;
    if (std::ranges::any_of(made, [](const auto& one) { return one.has_value(); }))
      drawn.still[i] = drawn.of(i, solids);
    made.clear();
  });
  return drawn;
}

const Solids& DrawnSolids::of(const Scene& scene, std::size_t organism) const {
  return organism < still.size() && still[organism] ? *still[organism]
                                                    : scene.specimens[organism].model.solids;
}

Solids DrawnSolids::of(std::size_t organism, const Solids& now) const {
  if (organism >= developed.size()) return now;
  const std::vector<std::optional<Coarser>>& shapes = developed[organism];
  Solids drawn{{}, now.shape, now.position, now.turn, now.scale, now.follow_ground};
  for (std::size_t s = 0; s < now.shapes.size(); ++s) {
    bool fits =
        s < shapes.size() && shapes[s] && shapes[s]->vertices == now.shapes[s].surface.position.size();
    drawn.shapes.push_back(fits ? drawn_coarser(now.shapes[s], *shapes[s]) : now.shapes[s]);
  }
  return drawn;
}

}  // namespace frond
