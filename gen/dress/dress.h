#pragma once

#include <optional>
#include <vector>

#include "dress/bark.h"
#include "dress/bark_coat.h"
#include "dress/fish_look.h"
#include "dress/leaf_look.h"
#include "dress/season.h"
#include "dress/skin.h"
#include "model/model.h"
#include "motion/motion.h"

namespace frond {

/// What the filled outlines of the turtle are made of.
struct BladeLook {
  std::vector<Color> colors{{0.27f, 0.48f, 0.15f}};  ///< the turtle's colour index picks one, round and round
  Color second{0.62f, 0.72f, 0.36f};                 ///< veins
  Tissue tissue = Tissue::leaf;                      ///< leaf or petal
};

/// What the surface of an organism looks like. Branches have a skin or a bark; bodies bring their materials.
struct Look {
  std::optional<Skin> skin;      ///< of a coral
  std::optional<Bark> bark;      ///< of a plant
  std::optional<BarkCoat> coat;  ///< where given, branches are meshes with this picture
  int lobes = 0;                 ///< of the trunk's cross-section, where there is a coat
  double lobe_depth = 0;
  BladeLook blades;
  std::optional<LeafLook> leaves;  ///< as pictures, where it bears such, with those of all seasons
  std::vector<LeafLook> organs;    ///< a plant's organs that are pictures
  std::vector<Drawing> pictures;   ///< of a fish, of a shell
};

/// All that the parameters of an organism say of its look and its motion.
struct Dress {
  Look look;
  Motion motion;
  std::optional<Seasons> season;  ///< of its leaves
  double variation = 0;           ///< how much single ones differ in brightness, as a share
};

/// What a tree with leaves as pictures wears and how it moves.
struct TreeDress {
  Bark bark;                     ///< of branches drawn as sweeps
  std::optional<BarkCoat> coat;  ///< where given, branches are meshes with this picture
  LeafLook leaves;
  std::optional<Seasons> season;
  Wave wave;
  Growth growth;
};

/// The leaves with the colours of all seasons.
LeafLook leaves_of(const TreeDress& dress);

Dress dress_of(const TreeDress& dress, bool leafy);

/// The pictures that what wears it needs.
std::vector<Drawing> drawings(const Look& look);

}  // namespace frond
