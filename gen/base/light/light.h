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

/// Position and view of a camera at one moment. Metres.
struct Eye {
  Vec3 at{0}, ahead{0, 0, -1}, up{0, 1, 0};  ///< the last two of length 1, at right angles
  double broad = 1, tall = 1;  ///< half width and half height of the picture at a distance of 1 m, metres
  double pixel = 0.001;        ///< metres, size of a pixel at a distance of 1 m

  bool operator==(const Eye&) const = default;
};

/// An eye that looks toward a point; x is horizontal in its picture.
Eye eye_toward(Vec3 at, Vec3 toward, double broad, double tall, double pixel);

/// Whether a ball may be in view.
bool in_view(const Eye& eye, Vec3 at, double radius);

/// Light from far away. Linear colours; that of the sky is radiance: a white matt surface lit by nothing else
/// shows it.
struct Ambience {
  Vec3 sun{0, 1, 0};                     ///< direction toward it, of length 1
  Vec3 sunlight{0};                      ///< brightness of a white matt surface that faces it
  Vec3 zenith{0}, horizon{0}, below{0};  ///< of the sky; `below`: of directions below the horizon
  Vec3 ground{0.2f};                     ///< share of light reflected by the land
};

/// The directions that a surface faces: a bit for each of +x, -x, +y, -y, +z, -z.
using Facing = std::uint8_t;
inline constexpr Facing kAllFacings = 63;
Facing facing(Vec3 normal);

/// The light that arrives at a place from the hemisphere round one axis.
struct Probe {
  Vec3 at;     ///< metres
  int axis;    ///< bit number of its Facing
  float cell;  ///< metres to its neighbours
  Vec3 light;  ///< linear; brightness of a white matt surface there with that orientation
};

/// Sides of cells, metres, from the least and below the most.
struct CellSizes {
  float least = 0, most = 1e30f;
};

/// Soft light in a scene: the sky light that reaches each place past the objects, and the sun and sky light
/// that these reflect. Objects are entered into nested grids of cells, finer near the camera, each cell with
/// its optical depth and colour, as for voxel cone tracing (Crassin and others 2011). First add everything,
/// then query once. The result does not depend on the order of adding.
class SoftLight {
 public:
  /// For the eyes of a film, within bounds. A cell covers about `pixels`, or more if grids would be too
  /// large; its side is a power of two times `unit` metres.
  SoftLight(std::vector<Eye> eyes, const Bounds& bounds, double pixels, double unit);

  /// One that only knows its cells: nothing can be added.
  static SoftLight bare(std::vector<Eye> eyes, const Bounds& bounds, double pixels, double unit);

  /// Side of the cells there, metres; of the smallest within so many metres.
  float cell_at(Vec3 at, double within = 0) const;

  /// Predicted size of the grids of such a scene.
  struct Size {
    double cells = 0;  ///< in all grids
    double land = 0;   ///< columns of cells for which the light on the land is computed
    double cover = 0;  ///< cells of these columns within the cover `tall` metres high
  };
  static Size estimate_size(std::vector<Eye> eyes, const Bounds& bounds, double pixels, double unit,
                            const std::function<float(Vec2)>& height, float tall,
                            std::span<const Eye> seen_by);

  /// A piece of a surface. `facing` tells which sides are outside; `bulk` is the width in metres of the body
  /// that it belongs to, 0 for a leaf, whose two sides are one piece; the piece is spread over a cube `wide`
  /// across. It is added to the grids with such `cells`. Thread-safe.
  void add(Vec3 at, float area, Vec3 albedo, Facing facing, float bulk, float wide = 0, CellSizes cells = {});

  /// A place that light is wanted at, of surfaces that face all ways and hide nothing, in the grids with such
  /// cells. Thread-safe.
  void want(Vec3 at, CellSizes cells);

  /// Land, solid below. Grass or litter covers it `tall` metres high, with `area` m2 per square metre.
  void add_land(const std::function<float(Vec2)>& height, Vec3 albedo, float tall, float area);

  /// The light at everything added, in the resolution that the eyes need, coarser where they do not see.
  std::vector<Probe> probes(const Ambience& ambience, std::span<const Eye> seen_by);

 private:
  struct Level {
    float cell = 1;
    glm::ivec3 low{0}, size{0};
    Vec3 center{0}, half{0};  // of its box, metres
    // Until light() sums in fixed point: areas of all, of bodies thinner than a cell and of others, and of
    // all by colour. Then optical depths across a cell: leaves and twigs horizontally (`area`) and vertically
    // (`thin`), bodies; and radiance.
    std::vector<std::uint32_t> area, thin, body;
    std::array<std::vector<std::uint32_t>, 3> color;
    std::vector<Facing> facings;

    void add(Vec3 at, float share, Vec3 albedo, Facing facing, float bulk);
    std::size_t count() const;
    std::size_t index(glm::ivec3 of) const;
    bool index(Vec3 at, std::size_t& found) const;
    Vec3 middle(glm::ivec3 of) const;
    /// In a direction with that square of y (`upright`); of leaves and twigs, and of all.
    float loose(std::size_t i, float upright) const;
    float depth(std::size_t i, float upright = 1.0f / 3) const;
    Vec3 radiance(std::size_t i) const;
  };

  static constexpr double kNearest = 0.3;  // metres from the eye within which cells are not made smaller
  static constexpr Facing kLand = 64;      // bit: the land is in the cell
  static constexpr int kUnseen = 2;        // number of levels by which parts that no eye sees are coarser

  SoftLight(std::vector<Eye> eyes, double pixels) : eyes_(std::move(eyes)), pixels_(pixels) {}

  /// Sets the positions and sizes of the grids; returns whether they are small enough.
  bool lay_levels(const Bounds& bounds, double unit);
  /// Metres to the nearest eye, and the wanted side of a cell at a distance.
  double away(Vec3 at) const;
  double fit(double far) const { return std::max(far, kNearest) * eyes_[0].pixel * pixels_; }
  std::size_t level_for(double cell) const;
  /// Whether light at a place is computed with cells of that level: its own, or the next ones if objects
  /// there have another.
  bool wanted(std::size_t level, Vec3 at, std::span<const Eye> seen_by) const;
  /// The light that arrives at the middle of a cell from a direction.
  Vec3 arriving(std::size_t level, Vec3 at, Vec3 direction, float spread, const Ambience& ambience,
                float& open) const;
  /// Adds to `sum` of each wanted direction the light from the hemisphere round it.
  void gather(std::size_t level, Vec3 at, Facing facing, const Ambience& ambience,
              std::array<Vec3, 6>& sum) const;
  /// Optical depth of leaves and twigs across a cell, horizontal and vertical, from the transmission of its
  /// parts: gaps between them let in more light than an even density. Large if its parts are not known.
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
