#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include "draw/levels.h"
#include "light/light.h"
#include "scene/scene.h"

// Passes
// ======
// What each ray from the camera meets, exactly and without shading: by which thing, where, how far away, and
// where that spot of its surface is at any other time of the film. A TracedFilm holds what is the same all
// the time; a TracedFrame is one moment of it, which rays are sent into (Embree: round cones for branches,
// triangles, instances for organs and copies). Metres; the results depend neither on threads nor on what was
// traced before.
//
// Branches are the cones that POV-Ray sweeps, without the relief of a bark; bodies and organs the meshes of
// the draw list in all detail, twigs of a palette those that POV-Ray draws. What a setting draws by text
// alone (the sea's surface, specks, mountains) is not known here: rays go through it.

namespace frond {

/// What kind of thing something is.
enum class ThingKind : std::uint8_t {
  nothing,
  branches,
  organ,
  blades,
  body,
  copy,
  floor,
  stone,
  food,
  cover,
  water
};

/// Something that is drawn, under the same name in all frames of a film.
struct Thing {
  ThingKind kind = ThingKind::nothing;
  std::uint32_t owner = 0;   ///< of a copy its set, of a patch its kind, of what grows the specimen, else 0
  std::uint32_t number = 0;  ///< among those of its kind: the organ's number in the model, a copy's, a
                             ///< stone's, a grain's, a patch's; of a twig of a palette, that of its first
                             ///< node as branches and that of its first organ as an organ

  auto operator<=>(const Thing&) const = default;
};

/// A spot of a thing's surface, by terms that hold while it moves, bends and grows.
struct SurfaceSpot {
  Thing thing;
  std::uint32_t part = 0;  ///< which of the meshes of an organ or a copy
  std::uint32_t face = 0;  ///< triangle of the mesh; of a branch, the node that its segment ends at
  /// The place and normal. For what keeps its shape: in its own axes. For a mesh that changes: shares of the
  /// triangle's second and third corner in x and y. For a branch: the offset from its axis as shares of the
  /// radius in the axes of the node.
  Vec3 own{0}, own_normal{0};
  float along = 0;  ///< of a branch: 0 at the lower node of the segment .. 1 at the upper one
  /// Cosine of the angle between the way to the main light and the normal that it is shaded by.
  float facing = 0;
};

/// What a ray meets.
struct PassHit {
  SurfaceSpot spot;
  float away = 0;  ///< metres along the ray
  Vec3 at{0};
  Vec3 normal{0, 1, 0};  ///< of length 1, toward where the ray came from
};

/// A place and what faces outward there.
struct PlaceNormal {
  Vec3 at, normal;
};

/// Where a ray begins, and its direction of length 1.
struct CameraRay {
  Vec3 from, along;
};

class TracedFrame {
 public:
  struct Parts;
  explicit TracedFrame(std::unique_ptr<Parts> parts);
  ~TracedFrame();
  TracedFrame(TracedFrame&&) noexcept;

  /// The first surface on the way from a place in a direction of length 1; none where there is none.
  std::optional<PassHit> trace(Vec3 from, Vec3 direction) const;
  /// Whether nothing stands between a hit and the main light's middle, and it faces that.
  bool lit(const PassHit& hit) const;
  /// Whether a ray from a place in the air, in a direction of length 1, meets nothing.
  bool open(Vec3 from, Vec3 direction) const;
  /// Where a spot, of whatever time, is now; none where its thing, or that part of it, is not there.
  std::optional<PlaceNormal> where(const SurfaceSpot& spot) const;

  /// Number `ray` of the rays through a place of the picture, which share the opening of the camera's lens
  /// evenly; without one all begin in its middle. `spread`, 0..1, moves them all.
  CameraRay ray(Vec2 place, int ray, float spread) const;
  /// Width of the circle as which a lens shows a place, as a share of the picture's width.
  float blur(Vec3 at) const;

  Eye eye;          ///< of the camera
  float lens = 0;   ///< metres, width of the opening of its lens; 0: all is sharp
  float sharp = 1;  ///< metres along its axis to what is in focus

 private:
  /// The direction, of length 1, from a place to the main light's middle, and how far that is.
  std::pair<Vec3, float> to_light(Vec3 at) const;

  std::unique_ptr<Parts> parts_;
};

class TracedFilm {
 public:
  /// The traced film of a scene, which must outlive it, with the plan of its copies, whose models are grown.
  /// An error where a model or a specimen cannot be made.
  static Result<TracedFilm> of(const Scene& scene, CopyPlan plan = {});
  ~TracedFilm();
  TracedFilm(TracedFilm&&) noexcept;

  /// The film at a time, seconds; an error where a specimen cannot be developed.
  Result<TracedFrame> at(double time) const;

 private:
  struct Parts;
  explicit TracedFilm(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

/// Direction of length 1 of the ray through a place of the picture, 0..1 from its left and upper edges.
Vec3 picture_ray(const Eye& eye, Vec2 place);
/// Where ray number `ray` of side * side goes through a pixel, 0..1: an even grid, row by row.
inline Vec2 place_in_pixel(int ray, int side) {
  return (Vec2(ray % side, ray / side) + 0.5f) / static_cast<float>(side);
}
/// How the rays of a pixel are spread over a lens, for TracedFrame::ray(): otherwise than those beside it.
inline float pixel_spread(Vec2 pixel) { return glm::fract(glm::dot(pixel, Vec2(0.7548777f, 0.5698403f))); }
/// Where a point is in the picture, as above and perhaps beyond its edges; none behind the camera.
std::optional<Vec2> picture_place(const Eye& eye, Vec3 at);

}  // namespace frond
