#pragma once

#include <optional>

#include "model/skeleton.h"
#include "model/solid.h"
#include "model/surface.h"

namespace frond {

/// What a part of an organ is made of.
enum class Tissue { leaf, petal, heart, fruit, skin, ivy, dew };

/// A part of an organ that has one texture.
struct OrganPart {
  Tissue tissue = Tissue::leaf;
  Surface surface;
  std::vector<std::string> pictures =
      {};  ///< PNG files, one for each colour of the prototype; empty: a plain tissue
};

/// How an organ takes light, where that is told.
struct Luster {
  double through = 0.35;  ///< share of what it throws back of light that shines through
  double gloss = 0.16;    ///< of its upper side; the lower one is matt
  double relief = 0;      ///< of veins and pleats
};

/// The shape of an organ, held once however often it occurs: its foot at the origin, growing along +y, its
/// upper side toward +z, about one unit long.
struct Prototype {
  std::string name;
  std::vector<OrganPart> parts;
  std::vector<Color> colors;  ///< the turtle's colour index picks one, round and round; at least one
  Color second;               ///< of what differs from the rest: the heart of a flower, the veins of a leaf
  std::optional<Color> bud = {};  ///< what the colours go over from while the organ unfolds; none: they stay
  std::optional<Luster> luster = {};  ///< none: as its tissue is by itself
  std::size_t summer = 0;  ///< so many colours are of summer, those that follow of other seasons; 0: all
};

/// Which of so many colours a turtle's colour index picks, round and round.
inline std::size_t color_index(std::int32_t color, std::size_t count) {
  auto n = static_cast<std::int32_t>(count);
  return static_cast<std::size_t>(((color % n) + n) % n);
}

/// Leaves, flowers, berries: one entry an organ. Metres.
struct Organs {
  std::vector<std::uint16_t> prototype;
  std::vector<Vec3> position;
  std::vector<Quat> turn;          ///< of length 1; takes the prototype's axes to the world's
  std::vector<Vec3> scale;         ///< along the prototype's axes, each > 0
  std::vector<std::int32_t> node;  ///< of the skeleton that it rides on, or Skeleton::kRoot
  std::vector<float> birth;        ///< 0..1, as that of a node
  std::vector<std::int32_t> color;
  std::vector<std::uint32_t> id;  ///< by which single ones differ in shade and flutter
  std::vector<float>
      loose;  ///< 0 rides on its node .. 1 has left it and is where `position` says; empty: all ride
  std::vector<float>
      supple;  ///< how readily each flutters, about the length of its stalk over 5 cm; empty: not

  std::size_t size() const { return position.size(); }
  void reserve(std::size_t count);
};

/// Filled outlines of the turtle: the blades of leaves, each flat or nearly so. Blade i has the points
/// first[i] .. first[i + 1] - 1 and triangles of its own. Metres.
struct Blades {
  std::vector<std::uint32_t> first{0};
  std::vector<std::int32_t> node;  ///< that it rides on, or Skeleton::kRoot
  std::vector<float> birth;
  std::vector<std::int32_t> color;
  std::vector<std::uint32_t> id;  ///< by which single ones differ in shade
  std::vector<Vec3> foot;         ///< from where it unfolds
  Surface surface;                ///< of all of them, with places on the leaf as `uv`

  std::size_t size() const { return node.size(); }
};

/// What grows, branches and what they carry, and what is built: bodies. Plain data; metres.
struct Model {
  Skeleton skeleton;
  std::vector<std::int32_t> color;  ///< of each node, the turtle's index; empty: 0 for all
  std::vector<float> girth;         ///< of each node, the radius that it will come to; empty: it has it
  std::vector<float> light;         ///< of each node, see Solid::light; empty: all
  std::vector<Prototype> prototypes;
  Organs organs;
  Blades blades;
  Solids solids;
  Surface hull;  ///< in place of the solids, what creepers hold on to; empty: the solids themselves
  std::vector<std::string> notes;  ///< what the user should know of how it was built

  /// Where it is not what it promises: one line for the first fault, empty when all is well.
  std::string check() const;
};

}  // namespace frond
