#pragma once

#include <optional>
#include <span>
#include <vector>

#include "appearance/bark_coat.h"
#include "appearance/leaf_look.h"
#include "appearance/season.h"
#include "appearance/skin.h"
#include "geometry/tubes.h"
#include "model/bark.h"
#include "model/model.h"
#include "motion/motion.h"

namespace frond {

/// Material of the filled outlines of the turtle.
struct BladeLook {
  std::vector<Color> colors{{0.27f, 0.48f, 0.15f}};  ///< selected cyclically by the turtle's colour index
  Color second{0.62f, 0.72f, 0.36f};                 ///< veins
  Tissue tissue = Tissue::leaf;                      ///< leaf or petal
};

/// Whether branches are drawn as they are or as cubes, whose tips are paler.
enum class Built { branches, cubes };

/// What single branches wear in place of a plant's bark: of one colour.
struct OtherBark {
  Bark bark;
  std::optional<BarkCoat> coat =
      {};  ///< its picture, where the plant wears one, which lies as the plant's does
};

/// What branches are made of: nothing, the skin of a coral, or the bark of a plant.
struct BranchLook {
  std::optional<Skin> skin = {};
  std::optional<Bark> bark = {};
  std::optional<BarkCoat> coat = {};   ///< where given, thick branches are meshes with this picture
  std::vector<OtherBark> others = {};  ///< of branches that edits changed: colours that follow the bark's own
  int lobes = 0;                       ///< of the trunk's cross-section, where there is a coat
  double lobe_depth = 0;               ///< share of the radius

  bool drawn() const { return skin || bark; }
  bool coral() const { return skin.has_value(); }
  bool plant() const { return bark.has_value(); }
  /// Whether light and shade tell on this coral; sea fans take their food from the water alone.
  bool living() const { return skin && skin->kind != SkinKind::fan; }
  /// The polyps of the skin; null where there are none.
  const Polyps* polyps() const;
  /// How many colours the turtle chooses from, how many there are with those of other barks, and which of
  /// them a number means.
  std::size_t own_colors() const { return bark ? bark->colors.size() : 1; }
  std::size_t colors() const { return own_colors() + others.size(); }
  std::size_t color_at(const Model& model, std::int32_t node) const;
  /// Which of the other barks a colour is, counted from 1; 0: it is the plant's own.
  std::size_t other(std::size_t color) const { return color < own_colors() ? 0 : color - own_colors() + 1; }
  /// The first colour of another bark so counted.
  std::size_t color_of(std::size_t which) const { return which == 0 ? 0 : own_colors() + which - 1; }
  /// The bark and the picture of a colour; null where there is none.
  const Bark* bark_of(std::size_t color) const;
  const BarkCoat* coat_of(std::size_t color) const;
  /// Metres below a tip in which branches are young; 0: tips are as the rest.
  double young_length() const;
  /// Whether any has a pattern, which moves with the branch, or one colour has; `ringed`: one that goes round
  /// it.
  bool patterned() const;
  bool patterned(std::size_t color) const;
  bool ringed(std::size_t color = 0) const;
  /// Metres of what the pattern repeats; 0: there is none.
  double pattern_size() const;
  double bark_scale() const { return bark ? bark->scale : 0; }
  double gloss(std::size_t color = 0) const;  ///< 0 matt .. 1 polished
  bool metal(std::size_t color = 0) const;
  /// sRGB, as branches look from afar, by the turtle's colour: of old skin and of young.
  Color plain(std::size_t color, double brightness) const;
  Color young(std::size_t color, double brightness, Built built) const;
  /// By how much more light growing tips give back than old skin, channel by channel. 1 where tips are as the
  /// rest.
  Vec3 young_light(std::size_t color, Built built) const;
  /// Linear, of a cube: `age` 0 old .. 1 young; `shade`, 0..1, tells cubes apart.
  Vec3 cube(std::size_t color, float age, float shade) const;
  /// Linear, what they throw back of white light, about: the plant's own, and that of one of its nodes.
  Vec3 albedo() const;
  Vec3 albedo_at(const Model& model, std::int32_t node) const;
  /// Tubes for the picture, of branches as thick as they will come to be by `girth`. Without `twigs` those
  /// that are too thin for a picture are left out.
  TubeShape tube_shape(std::span<const float> girth = {}) const;
};

/// The tubes of a model's branches, each vertex with its node, by what they wear: those of the plant's own
/// bark, then those of each of the others.
std::vector<Surface> by_bark(const BranchLook& look, const Model& model, const TubeMesh& tubes);

/// A colour times a factor, clamped.
Color scaled(Color color, double factor);

/// The mean of some colours, linear.
Vec3 mean(const std::vector<Color>& colors);

/// Appearance of an organism's surface. Bodies have their own materials.
struct Look {
  BranchLook branches;
  BladeLook blades;
  std::optional<LeafLook> leaves;  ///< as pictures, where it has any, including all seasons
  std::vector<LeafLook> organs;    ///< a plant's organs that are pictures
  std::vector<Drawing> pictures;   ///< of a fish, of a shell
};

/// Everything that an organism's parameters say about its appearance and motion.
struct Appearance {
  Look look;
  Motion motion;
  std::optional<Seasons> season;  ///< of its leaves
  double variation = 0;           ///< variation of brightness between individuals, as a share
};

/// Gives it the course of the year, with the pictures that its fruit wears.
void set_season(Appearance& appearance, const std::optional<Seasons>& season);

/// Appearance and motion of a tree whose leaves are pictures.
struct TreeAppearance {
  Bark bark;                     ///< of branches drawn as sweeps
  std::optional<BarkCoat> coat;  ///< where given, branches are meshes with this picture
  LeafLook leaves;
  std::optional<Seasons> season;
  Wave wave;
  Growth growth;
};

/// The leaves with the colours of all seasons.
LeafLook leaves_of(const TreeAppearance& appearance);

Appearance tree_appearance(const TreeAppearance& appearance, bool leafy);

/// The pictures that an organism of this look needs.
std::vector<Drawing> drawings(const Look& look);

}  // namespace frond
