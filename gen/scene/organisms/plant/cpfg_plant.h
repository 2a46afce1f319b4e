#pragma once

#include "grammar/figure.h"
#include "organisms/grower.h"
#include "organisms/plant/plant.h"

// Plants that a model of cpfg draws (gen/growth/cpfg): its figure as branches, outlines, skins and organs.

namespace frond {

/// The skin of a generalized cylinder, which rides on a node as an outline does.
struct DrawnSkin {
  Surface surface;
  int color = 0;
  std::int32_t node = Skeleton::kRoot;
  Vec3 foot{0};
};

/// What a plant's grammar draws, before it is scaled.
struct DrawnPlant {
  Figure figure;
  std::vector<DrawnSkin> skins;
  Bounds box;
};

/// Reads the model that a preset names as its grammar.
Errors load_cpfg(const NamedFile& file, PlantGrammar& grammar);

/// The colours of a plant's model, as what it is made of by default.
void use_model_colors(PlantParams& params);
/// Adds the surfaces of its model, but for those that the preset gives other shapes.
void use_model_surfaces(PlantParams& params);

/// Why a model cannot be grown with these properties.
Errors cpfg_faults(const PlantParams& params);

/// What the model draws at a share of its film, 0..1: from the animation's first frame to the last step, on
/// the way from one frame to the next.
Result<DrawnPlant> draw_cpfg(const PlantParams& params, Seed seed, double share);

/// How large that is at the end.
Result<SizeEstimate> cpfg_size(const PlantParams& params);

}  // namespace frond
