#pragma once

#include "appearance/appearance.h"
#include "core/assets.h"
#include "core/result.h"
#include "core/seed.h"
#include "cpfg/cpfg.h"
#include "foliage/floral_diagram.h"
#include "foliage/inflorescence.h"
#include "geometry/girth.h"
#include "grammar/grammar.h"
#include "model/model.h"
#include "motion/motion.h"

namespace frond {

enum class OrganShape {
  leaf,
  petal,
  flower,
  bud,
  berry,
  ball,
  obj,
  sprig,
  frond,
  picture,
  grammar,
  diagram,
  inflorescence
};

/// A picture that the mesh of an organ wears.
struct OrganSkin {
  std::shared_ptr<const std::string> picture;  ///< bytes of the file
  std::string name;                            ///< of that file, for messages
  Color tint;                                  ///< what the mesh's file multiplies it by
  std::vector<char> worn;                      ///< of each triangle, whether it wears the picture
  Color mean{};                                ///< of the picture, without the tint
  std::string id;                              ///< of the picture's content
  double pixels = 0;                           ///< of the picture
};

/// The shape of an organ that the grammar names.
struct OrganParams {
  std::string symbol;             ///< its name in the grammar
  FileName file;                  ///< of an `obj`: relative to the preset's folder
  Surface mesh;                   ///< content of the file, one unit long
  std::optional<OrganSkin> skin;  ///< the picture that the file's materials name
  std::string mesh_note;          ///< what of the file is not drawn as its maker may think
  bool own_colors = false;        ///< whether the preset gives `colors`
  OrganShape shape = OrganShape::leaf;
  double size = 0.1;  ///< metres long; multiplied by the organ's parameter in the grammar
  std::vector<Color> colors{{0.30f, 0.50f, 0.14f}};  ///< selected cyclically by the turtle's colour index
  Color second{0.95f, 0.75f, 0.15f};                 ///< heart of a flower, veins of a leaf, calyx of a bud
  double width = 0.45;           ///< of a leaf or petal, a bud or berry, as a share of its length
  std::optional<double> widest;  ///< of a leaf or petal, position along it, 0..1; none: default of the shape
  std::optional<double> round;   ///< 0 pointed .. 1 round at its end; none: default of the shape
  int detail = 3;                ///< of leaves and petals: 1, few triangles .. 3
  double fold = radians(22.0);   ///< of a leaf along its midrib
  double bend = radians(40.0);   ///< of a leaf or petal along its length
  double wave = 0.3;             ///< of a leaf's rim
  int petals = 5;
  int leaflets = 0;  ///< leaves of a sprig, pairs of leaflets of a frond, leaflets for each that a grammar
                     ///< draws; 0: default of the shape
  int lobes = 0;     ///< on each side of a frond's leaflets, as on ferns
  double droop = radians(45.0);  ///< of leaflets from foot to tip
  int variants = 3;              ///< of a sprig, frond, grammar or curled picture: number of different shapes
  double open = radians(65.0);   ///< angle between petals and heading
  double heart = 0.16;           ///< radius of a flower's heart as a share of its size
  double size_variation = 0.12;  ///< random change of the size, as a share
  double turn_variation = radians(12.0);       ///< largest random tilt
  std::optional<LeafLook> picture;             ///< of the shape `picture`, except its size and variations
  std::optional<GrammarText> grammar;          ///< what draws the shape `grammar`
  std::optional<FloralDiagram> diagram;        ///< of the shape `diagram`; its unit is the size
  std::optional<Inflorescence> inflorescence;  ///< of the shape of that name; its length is the size
  std::optional<Luster> luster;
  double dew = 0;           ///< drops per square centimetre
  bool with_plant = false;  ///< a surface of a model of cpfg: its size goes with the plant's height
};

/// The origin of a plant.
enum class PlantOrigin {
  turtle,  ///< where the turtle starts
  middle   ///< below the middle of its box, the lowest point on the ground
};

/// The rules that a plant grows by: ours, or a model of cpfg, of which only file, steps and limits count
/// here.
struct PlantGrammar : GrammarText {
  std::shared_ptr<const CpfgModel> cpfg;
  bool vary = false;  ///< each plant of a model of cpfg has chances of its own
};

/// Anything drawn by an L-system: herbs, trees, curves.
struct PlantParams {
  PlantGrammar grammar;
  double height = 0;  ///< metres; the whole is scaled to this height; 0: not scaled
  PlantOrigin origin = PlantOrigin::turtle;
  int smoothing = 3;  ///< nodes per segment; 1 keeps corners
  Girth thickness;
  Bark bark;
  std::vector<OrganParams> organs;
  BladeLook blades;
  std::optional<Seasons> season;  ///< of those organs that are leaves
  Wave wave;
  Food food;
  Growth growth;
  bool by_steps = false;  ///< growth follows the derivation steps instead of the finished branches
};

/// The grammar, ready to derive. Organs whose symbol is not in the grammar are errors, and so is `~` in a
/// rule before the name of a missing organ.
Result<Grammar> plant_grammar(const PlantParams& params);

/// Grows one plant upright, its foot at the origin. `share` of its derivation steps, 0..1, gives an
/// intermediate state: smooth in `share`, and empty if the axiom draws nothing. `environment` answers the
/// questions of its grammar.
Result<Model> grow_plant(const PlantParams& params, Seed seed, double share = 1,
                         const Environment& environment = {});

}  // namespace frond
