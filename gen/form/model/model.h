#pragma once

#include <cmath>
#include <optional>

#include "model/skeleton.h"
#include "model/solid.h"
#include "model/surface.h"

namespace frond {

/// What a part of an organ is made of.
enum class Tissue { leaf, petal, heart, fruit, skin, ivy, dew };

/// Whether a tissue is a thin sheet, seen from both sides.
inline bool is_leaf(Tissue tissue) {
  return tissue == Tissue::leaf || tissue == Tissue::petal || tissue == Tissue::ivy;
}

/// A part of an organ with one texture.
struct OrganPart {
  Tissue tissue = Tissue::leaf;
  Surface surface;
  std::vector<std::string> pictures =
      {};                   ///< PNG files, one for each colour of the prototype; empty: a plain tissue
  std::string relief = {};  ///< a PNG file of heights; empty: what is pale in the picture is high
};

/// Optical properties of an organ, if given.
struct Luster {
  double through = 0.35;  ///< share of the reflected light that shines through instead
  double gloss = 0.16;    ///< of the upper side; the lower side is matt
  double relief = 0;      ///< of veins and folds
  double yellow = 0;      ///< how much yellower than it reflects a leaf of pictures lets through, 0..1
};

/// The shape of an organ, stored once for all its placements: its foot at the origin, growing along +y, its
/// upper side toward +z, about one unit long.
struct Prototype {
  std::string name;
  std::vector<OrganPart> parts;
  std::vector<Color> colors;          ///< selected cyclically by the turtle's colour index; at least one
  Color second;                       ///< of the second part: the heart of a flower, the veins of a leaf
  std::optional<Color> bud = {};      ///< initial colour while the organ unfolds; none: colours do not change
  std::optional<Luster> luster = {};  ///< none: the default of its tissue
  std::size_t summer = 0;  ///< number of summer colours, followed by those of other seasons; 0: all
  std::size_t ailing = 0;  ///< index of the first colour of failing health, which come last; 0: none
  bool piece = false;  ///< of a flower whose other pieces stand in the same place and have the same number
  double borne = 0;    ///< of what comes with the season, how many each organ of full leaf bears; 0: unknown
  double mean = 0;     ///< of the same, metres long
};

/// Index of the colour that a turtle's colour index selects, cyclically.
inline std::size_t color_index(std::int32_t color, std::size_t count) {
  auto n = static_cast<std::int32_t>(count);
  return static_cast<std::size_t>(((color % n) + n) % n);
}

/// Index of the colour at a place on merged leaves, the whole part of whose `u` is the turtle's colour index.
inline std::size_t color_index(Vec2 uv, std::size_t count) {
  return color_index(static_cast<std::int32_t>(std::floor(uv.x)), count);
}

/// Leaves, flowers, berries: one entry per organ. Metres.
struct Organs {
  std::vector<std::uint16_t> prototype;
  std::vector<Vec3> position;
  std::vector<Quat> turn;          ///< of length 1; from the prototype's axes to the world's
  std::vector<Vec3> scale;         ///< along the prototype's axes, each > 0
  std::vector<std::int32_t> node;  ///< skeleton node that it is attached to, or Skeleton::kRoot
  std::vector<float> birth;        ///< 0..1, as that of a node
  std::vector<std::int32_t> color;
  std::vector<std::uint32_t> id;  ///< identifies single organs for shade and flutter
  std::vector<float> loose;       ///< 0 attached to its node .. 1 free, at `position`; empty: all attached
  std::vector<float> supple;      ///< flutter amplitude, about the length of its stalk over 5 cm; empty: none

  std::size_t size() const { return position.size(); }
  void reserve(std::size_t count);
};

/// Filled outlines of the turtle: the blades of leaves, each nearly flat. Blade i has the points first[i] ..
/// first[i + 1] - 1 and its own triangles. Metres.
struct Blades {
  std::vector<std::uint32_t> first{0};
  std::vector<std::int32_t> node;  ///< node that it is attached to, or Skeleton::kRoot
  std::vector<float> birth;
  std::vector<std::int32_t> color;
  std::vector<std::uint32_t> id;  ///< identifies single blades for shade
  std::vector<Vec3> foot;         ///< point from which it unfolds
  Surface surface;                ///< all of them, with positions on the leaf as `uv`

  std::size_t size() const { return node.size(); }
};

/// Where a node belongs in the branching of the plant as it grew, see pruning/address.h.
struct AxisNode {
  std::int32_t number = 0;  ///< 0: it continues its parent's axis; of the first node of one, the axis's
                            ///< number among those that leave the parent's; negative: it belongs to no axis
  float share = 0;          ///< 0..1 of its axis's length

  bool operator==(const AxisNode&) const = default;
};

/// A grown organism, branches and their organs, or a built one: bodies. Plain data; metres.
struct Model {
  Skeleton skeleton;
  std::vector<std::int32_t> color;  ///< of each node, the turtle's colour index; empty: 0 for all
  std::vector<float> girth;         ///< of each node, its final radius; empty: as it is
  std::vector<float> light;         ///< of each node, see Solid::light; empty: all
  std::vector<AxisNode> axes;       ///< of each node, if not as the skeleton alone tells; else empty
  std::vector<Prototype> prototypes;
  Organs organs;
  Blades blades;
  Solids solids;
  Surface hull;  ///< surface for creepers in place of the solids; empty: the solids themselves
  std::vector<std::string> notes;  ///< messages for the user about how it was built

  /// Checks all invariants: one line for the first violation, empty if there is none.
  std::string find_fault() const;
};

/// How far an organ reaches from its origin, metres.
float reach_of(const Prototype& organ);

/// How long it is as growth goes, metres: the longest way along branches, or of bodies the height or the
/// radius, whichever is more; 0 of nothing.
float length_of(const Model& model);

/// A box round its branches and bodies, and the places of its organs and blades; empty where there is
/// nothing.
Bounds bounds_of(const Model& model);

}  // namespace frond
