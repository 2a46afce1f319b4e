#pragma once

#include "core/curve.h"
#include "core/result.h"
#include "core/seed.h"
#include "dress/dress.h"
#include "geometry/girth.h"
#include "grammar/grammar.h"
#include "model/model.h"
#include "motion/motion.h"

namespace frond {

enum class OrganShape { leaf, petal, flower, bud, berry, ball, obj, sprig, frond, picture };

/// What stands where the grammar names an organ.
struct OrganParams {
  std::string symbol;  ///< its name in the grammar
  std::string file;    ///< of an `obj`: as seen from the preset's folder
  Surface mesh;        ///< what that file holds, one unit long
  OrganShape shape = OrganShape::leaf;
  double size = 0.1;  ///< metres long; the organ's parameter in the grammar multiplies it
  std::vector<Color> colors{{0.30f, 0.50f, 0.14f}};  ///< the turtle's colour index picks one, round and round
  Color second{0.95f, 0.75f, 0.15f};                 ///< heart of a flower, veins of a leaf, calyx of a bud
  double width = 0.45;           ///< of a leaf or petal, a bud or berry, as a share of its length
  std::optional<double> widest;  ///< of a leaf or petal, where along it, 0..1; none: as usual for the shape
  std::optional<double> round;   ///< 0 drawn out to a tip .. 1 round at its end; the same
  int detail = 3;                ///< of leaves and petals: 1, few triangles .. 3
  double fold = radians(22.0);   ///< of a leaf along its midrib
  double bend = radians(40.0);   ///< of a leaf or petal along its length
  double wave = 0.3;             ///< of a leaf's rim
  int petals = 5;
  int leaflets = 0;  ///< leaves of a sprig, pairs of leaflets of a frond; 0: as usual for the shape
  int lobes = 0;     ///< on either side of a frond's leaflets, as a fern has them
  double droop = radians(45.0);           ///< of a frond's leaflets from foot to tip
  int variants = 3;                       ///< of a sprig, frond or curled picture: how many shapes there are
  double open = radians(65.0);            ///< between petals and heading
  double heart = 0.16;                    ///< radius of a flower's heart as a share of its size
  double size_variation = 0.12;           ///< random change of the size, as a share
  double turn_variation = radians(12.0);  ///< random tilt, up to so much
  std::optional<LeafLook> picture;        ///< of the shape `picture`, but for its size and variations
  std::optional<Luster> luster;
  double dew = 0;  ///< drops on a square centimetre
};

/// Where a plant has its origin.
enum class Stand {
  turtle,  ///< where the turtle starts
  middle   ///< below the middle of its box, the lowest point on the ground
};

/// Anything that an L-system draws: herbs, trees, curves.
struct PlantParams {
  GrammarText grammar;
  double height = 0;  ///< metres; the whole is scaled to be so high; 0: as the turtle draws it
  Stand stand = Stand::turtle;
  int smoothing = 3;  ///< nodes for each segment; 1 leaves corners as they are
  Girth thickness;
  Bark bark;
  std::vector<OrganParams> organs;
  BladeLook blades;
  std::optional<Seasons> season;  ///< of its organs that are leaves
  Wave wave;
  Food food;
  Growth growth;
  bool by_steps = false;  ///< growth runs through the derivation steps, not along the finished branches
};

/// The grammar, ready to derive. Organs whose symbol the grammar does not have are errors, and so is each `~`
/// in a rule before the name of an organ that is not there.
Result<Grammar> plant_grammar(const PlantParams& params);

/// Grows one plant upright, its foot at the origin. `share` of its derivation steps, 0..1, gives it on its
/// way to what it will be: smooth in `share`, and nothing at all where the axiom draws nothing. `environment`
/// answers the questions of its grammar.
Result<Model> grow_plant(const PlantParams& params, Seed seed, double share = 1,
                         const Environment& environment = {});

}  // namespace frond
