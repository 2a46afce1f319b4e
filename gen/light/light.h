#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "core/bounds.h"
#include "core/vec.h"

namespace frond {

/// Where a camera is at one moment and what it sees. Metres.
struct Eye {
  Vec3 at{0}, ahead{0, 0, -1}, up{0, 1, 0};  ///< the last two of length 1, at right angles
  double broad = 1, tall = 1;                ///< of half the picture a metre away, metres
  double pixel = 0.001;                      ///< metres that a pixel covers a metre away
};

/// An eye that looks toward a place; x is to its right or left.
Eye eye_toward(Vec3 at, Vec3 toward, double broad, double tall, double pixel);

/// Whether a ball may be in view.
bool in_view(const Eye& eye, Vec3 at, double radius);

/// What shines on a scene from far away. Linear colours; of the sky as radiance: a white matt surface that
/// sees nothing else shows it.
struct Ambience {
  Vec3 sun{0, 1, 0};                     ///< toward it, of length 1
  Vec3 sunlight{0};                      ///< what a white matt surface that faces it shows
  Vec3 zenith{0}, horizon{0}, below{0};  ///< of the sky; of what is lower than all that stands
  Vec3 ground{0.2f};                     ///< share of light that the land throws back
};

/// Which way a surface faces: a bit for each of +x, -x, +y, -y, +z, -z.
using Facing = std::uint8_t;
inline constexpr Facing kAllFacings = 63;
Facing facing(Vec3 normal);

/// The light that comes to a place from the half of all directions round one axis.
struct Probe {
  Vec3 at;     ///< metres
  int axis;    ///< bit of its Facing
  float cell;  ///< metres to its neighbours
  Vec3 light;  ///< linear; what a white matt surface there that faces that way shows of it
};

/// Soft light in a scene: how much of the sky each place sees past what stands there, and what that throws
/// back of sun and sky. All that stands is laid into nested grids of cells, finer near the camera, each cell
/// with the optical depth and colour of what is in it, as for voxel cone tracing (Crassin and others 2011).
/// Add all, then ask once. The sum of what is added does not depend on its order.
class SoftLight {
 public:
  /// For eyes of a film, within bounds. A cell covers about `pixels`, or more where grids would be too large;
  /// its side is a power of two of `unit` metres.
  SoftLight(std::vector<Eye> eyes, const Bounds& bounds, double pixels, double unit);

  /// The side of the cells there, metres.
  float cell_at(Vec3 at) const;

  /// How large the grids of such a scene are, found without making them.
  struct Size {
    double cells = 0;  ///< of all grids
    double land = 0;   ///< columns of cells at whose foot the light on the land is asked for
    double cover = 0;  ///< cells of theirs that lie in what stands `tall` metres on the land
  };
  static Size estimate_size(std::vector<Eye> eyes, const Bounds& bounds, double pixels, double unit,
                            const std::function<float(Vec2)>& height, float tall,
                            std::span<const Eye> seen_by);

  /// A bit of a surface. `facing` tells which way its sides look; `bulk` is how many metres across the body
  /// is whose skin it belongs to, 0 of a leaf, both sides of which are one bit; the bit is spread over a cube
  /// `wide` across. From many threads at once.
  void add(Vec3 at, float area, Vec3 albedo, Facing facing, float bulk, float wide = 0);

  /// Land, solid below. Grass or litter stands `tall` metres on it, `area` m2 a square metre.
  void add_land(const std::function<float(Vec2)>& height, Vec3 albedo, float tall, float area);

  /// The light at all that was added, as far as the eyes given see it, and coarser beyond.
  std::vector<Probe> probes(const Ambience& ambience, std::span<const Eye> seen_by);

 private:
  struct Level {
    float cell = 1;
    glm::ivec3 low{0}, size{0};
    Vec3 center{0}, half{0};  // of its box, metres
    // Sums in fixed point until light(): areas of all, of bodies thinner than a cell and of others; of all by
    // their colour. Then optical depths across a cell, of leaves and twigs level (`area`) and upright
    // (`thin`) and of bodies; and radiance.
    std::vector<std::uint32_t> area, thin, body;
    std::array<std::vector<std::uint32_t>, 3> color;
    std::vector<Facing> facings;

    void add(Vec3 at, float share, Vec3 albedo, Facing facing, float bulk);
    std::size_t count() const;
    std::size_t index(glm::ivec3 of) const;
    bool index(Vec3 at, std::size_t& found) const;
    Vec3 middle(glm::ivec3 of) const;
    /// In a direction, the square of whose y is `upright`; of leaves and twigs, of all.
    float loose(std::size_t i, float upright) const;
    float depth(std::size_t i, float upright = 1.0f / 3) const;
    Vec3 radiance(std::size_t i) const;
  };

  static constexpr double kNearest = 0.3;  // metres from the eye from where on cells do not become smaller
  static constexpr Facing kLand = 64;      // bit: the land is in the cell
  static constexpr int kUnseen = 2;        // levels that what no eye sees is coarser

  SoftLight(std::vector<Eye> eyes, double pixels) : eyes_(std::move(eyes)), pixels_(pixels) {}

  /// Sets the grids' places and sizes; whether they are small enough.
  bool lay_levels(const Bounds& bounds, double unit);
  /// Metres from the next eye, and the side of a cell that is wanted at a distance.
  double away(Vec3 at) const;
  double fit(double far) const { return std::max(far, kNearest) * eyes_[0].pixel * pixels_; }
  std::size_t level_for(double cell) const;
  /// Whether light is asked for at a place by cells of that level: its own, or the next ones where what
  /// stands there has another.
  bool wanted(std::size_t level, Vec3 at, std::span<const Eye> seen_by) const;
  /// What comes to the middle of a cell from a direction.
  Vec3 arriving(std::size_t level, Vec3 at, Vec3 direction, float spread, const Ambience& ambience,
                float& open) const;
  /// Adds to `sum` of each of the directions what comes from the half of all that is round it.
  void gather(std::size_t level, Vec3 at, Facing facing, const Ambience& ambience,
              std::array<Vec3, 6>& sum) const;
  /// The optical depth of leaves and twigs across a cell, level and upright, by what its parts let through:
  /// gaps between them let in more than an even haze of them. Much, where its parts are not known.
  Vec2 merged(std::size_t level, glm::ivec3 of) const;
  void set_depths();
  void light(const Ambience& ambience);
  std::vector<Probe> probes_of(std::size_t level, const Ambience& ambience,
                               std::span<const Eye> seen_by) const;

  std::vector<Eye> eyes_;
  double pixels_;
  std::vector<Level> levels_;
};

}  // namespace frond
