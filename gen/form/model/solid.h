#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/bounds.h"
#include "core/curve.h"
#include "core/mask.h"
#include "core/vec.h"
#include "model/implicit.h"
#include "model/matter.h"
#include "model/surface.h"

namespace frond {

/// The pattern painted in a band.
enum class Motif { plain, zigzag, waves, dots, meander, petals, rings };

/// A band painted round a vessel, on its `uv`: u once round, v from 0 at the foot to 1 at the lip.
struct Band {
  double at = 0.6;      ///< of its middle, as a share of the height
  double width = 0.06;  ///< as a share of the height
  Color color{0.12f, 0.18f, 0.42f};
  Motif motif = Motif::plain;
  int repeats = 24;  ///< number round the vessel
};

/// The polyps on living tissue.
struct Polyps {
  double width = 0;            ///< metres, spread of a polyp's tentacles; 0: invisible
  Animated<double> open{1.0};  ///< 0 retracted .. 1 spread, by seconds
  double glow = 0;             ///< fluorescence of polyps and skin in blue light
};

/// The septa of stony corals: thin walls that run down from the ridges into valleys and cups.
struct Septa {
  double apart = 0;   ///< metres, from one to the next along a ridge; 0: none are drawn
  double valley = 0;  ///< metres, from ridge to ridge
  double depth = 0;   ///< metres, of the valleys

  bool operator==(const Septa&) const = default;
};

/// A part of a living skin that has died: bare skeleton that algae have overgrown.
struct DeadPatch {
  Vec3 at{0};        ///< metres, in the space of its solid
  float radius = 0;  ///< metres, about which its ragged border runs
};

/// The surface of a solid.
struct Material {
  Matter matter = Matter::plain;
  Color color{0.55f, 0.53f, 0.50f};
  Color second{0.35f, 0.33f, 0.30f};  ///< of the second part: veins, joints, bands
  double scale = 0.2;                 ///< metres, size of the pattern, > 0
  double relief = 0.5;                ///< depth of the pattern
  double moss = 0;                    ///< 0 none .. 1: amount of moss and lichen on surfaces that face upward
  double gloss = 0.1;                 ///< 0 matt .. 1 polished
  std::vector<Band> bands{};
  Polyps polyps{};                 ///< of living tissue
  Septa septa{};                   ///< of living tissue whose `uv` says what is ridge and what is valley
  std::vector<DeadPatch> dead{};   ///< of living tissue
  std::string picture{};           ///< a PNG file that it uses, one of its look
  std::optional<Mask> moss_map{};  ///< scales moss in the world; its picture is one of its look
};

/// A body of one material. Metres.
struct Solid {
  Surface surface;
  Material material;
  /// The body as cubic Bézier spans (radius, y) turned about the y axis, for renderers that support it; empty
  /// where it has no such shape.
  std::vector<std::array<glm::dvec2, 4>> turned{};
  std::optional<Isosurface> native{};  ///< drawn in place of `surface`, which still has its shape
  /// Positions of the vertices of `surface` at equal steps of growth, from the first to the last but one;
  /// `surface` is the last step. Empty: the body does not change.
  std::vector<std::vector<Vec3>> past{};
  /// Share of light, 0..1, that reaches each vertex past its neighbours when all are fully grown; empty: 1.
  std::vector<float> light{};
};

/// The surface of a solid at a share of its growth, 0..1, interpolated smoothly between the steps.
Surface surface_at(const Solid& solid, float share);

/// Bodies without branches: rocks, walls, vases. Each shape is stored once and may be placed many times.
/// Placements are a structure of arrays.
struct Solids {
  std::vector<Solid> shapes;
  std::vector<std::uint16_t> shape;  ///< of each placement, index into `shapes`
  std::vector<Vec3> position;
  std::vector<Quat> turn;   ///< of length 1
  std::vector<Vec3> scale;  ///< along the shape's axes, each > 0
  bool follow_ground =
      false;  ///< each keeps its height above the ground below it, not above that of the foot

  /// Transforms a point of its shape by placement `i`.
  Vec3 placed(std::size_t i, Vec3 at) const { return position[i] + turn[i] * (scale[i] * at); }

  std::size_t size() const { return position.size(); }

  /// Adds a shape and returns its index; at most 65535 of them.
  std::uint16_t add_shape(Solid solid);
  void place(std::uint16_t which, Vec3 at = Vec3(0), Quat turned = Quat(1, 0, 0, 0), Vec3 sized = Vec3(1));

  /// Checks all invariants: one line for the first violation, empty if there is none.
  std::string find_fault() const;
};

/// The bounding box of all placements.
Bounds bounds_of(const Solids& solids);
/// A larger box that is faster to compute: the transformed boxes of the shapes.
Bounds rough_bounds_of(const Solids& solids);

/// The solids at a share of their growth, without a past.
Solids grown_to(const Solids& solids, float share);

/// All placements as one mesh without `uv`: the surface for ivy and for measuring.
Surface merged(const Solids& solids);

}  // namespace frond
