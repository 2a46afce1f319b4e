#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/assets.h"
#include "core/result.h"
#include "images/leaf.h"
#include "model/model.h"

namespace frond {

/// A PNG file that frames use; its name identifies its content.
struct Picture {
  std::string name;
  std::string bytes;
};

/// Pictures that are drawn together. Not drawn again where files of their names exist.
struct Drawing {
  std::vector<std::string> names;
  std::function<Result<std::vector<Picture>>()> draw;  ///< in the same order
  double pixels = 0;                                   ///< total of all of them, about
  double seconds = 0;                                  ///< processor time to draw them, on a machine as ours
};

/// The drawing of one picture; `seconds_a_pixel`: as Drawing::seconds.
Drawing drawing_of(std::string name, double pixels, double seconds_a_pixel, std::function<Raster()> draw);

enum class LeafShape { birch, beech, oak, maple, ivy, aspen, willow, linden, cherry, ginkgo, own };

/// The colours of one leaf.
struct LeafTint {
  Color color, veins, rim;
};

/// Leaves of a tree: a picture, and a mesh cut along its outline.
struct LeafLook {
  LeafShape shape = LeafShape::birch;
  std::vector<double> outline;  ///< of the shape `own`: radii from the tip to the stalk, as in LeafOutline
  double width = 1;             ///< factor
  FileName photo;               ///< a photograph of a leaf that was cut out, instead of the shape
  std::shared_ptr<const LeafPhoto> photographed;  ///< what that file holds
  std::optional<double> stalk;          ///< length as a share of the whole leaf; none: that of its shape
  std::optional<double> teeth, tooth;   ///< as in LeafOutline; none: as of its shape
  std::optional<bool> palmate;          ///< likewise
  std::optional<VeinPattern> venation;  ///< none: as palmate says or is usual for its shape
  std::optional<int> secondaries;       ///< as in Venation; none: as of its shape
  double vein_density = 1;              ///< Venation::density
  bool loops = true;                    ///< Venation::loops
  double size = 0.08;                   ///< metres, of a leaf or a sprig
  bool sprig = false;                   ///< sprigs rather than leaves
  Sprig sprigs;
  bool end_sprigs = false;  ///< sprigs along branches have no leaf at their tip, those at ends do
  std::vector<Color> colors{{0.26f, 0.44f, 0.11f}, {0.31f, 0.48f, 0.13f}, {0.38f, 0.50f, 0.14f}};
  Color veins{0.56f, 0.66f, 0.30f};
  Color rim{0.42f, 0.50f, 0.15f};
  double spots = 0.2;           ///< how much the colour varies over a leaf
  double fold = radians(14.0);  ///< of each half
  double bend = radians(30.0);  ///< from foot to tip
  double pleat = 0;             ///< depth of the folds along its secondaries, 0..1
  double curl = 0;              ///< as it dries, 0..1
  double age = 0;               ///< brown at the rim and in blotches, 0..1
  int detail = 10;              ///< points of the mesh along half a rim
  int pixels = 256;             ///< height of the picture
  double size_variation = 0.2;
  double turn_variation = radians(14.0);  ///< random tilt, plus or minus
  std::optional<Luster> luster;           ///< none: the default of leaves
  std::vector<LeafTint> turned;           ///< other colours of the leaf, after those of `colors`

  std::size_t looks() const { return colors.size() + turned.size(); }
};

/// Takes a photograph that a preset names, and its colour unless the preset gives `colors`.
Errors load_leaf_photo(const NamedFile& file, bool colored, LeafLook& look);

/// The leaf in one of its colours.
LeafImage leaf_image(const LeafLook& look, std::size_t color);

/// A leaf as an organ of a model, with the names of its pictures; `phase`, radians, varies the curl.
Prototype leaf_prototype(const LeafLook& look, double phase = 0);

/// The look itself and, behind it, that of the sprigs along branches, where they are others than those at
/// their ends.
std::vector<LeafLook> variants(const LeafLook& look);

/// The name of a look's picture in one of its colours: of all that it shows, the leaf in that colour alone.
std::string picture_name(LeafLook look, std::size_t color);

/// Its prototype and, behind it, that of the sprigs along branches, where they are others than those at their
/// ends.
std::vector<Prototype> leaf_prototypes(const LeafLook& look);

/// The look that a picture of a prototype shows: itself, or that of the sprigs along branches.
LeafLook shown_in(const LeafLook& look, const std::string& picture);

/// The pictures of its prototypes in the same order, each drawn separately.
std::vector<Drawing> leaf_drawings(const LeafLook& look);

}  // namespace frond
