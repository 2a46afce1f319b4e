#pragma once

#include <vector>

#include "core/result.h"
#include "masonry/vessel.h"
#include "model/model.h"

namespace frond {

enum class VaseMaterial { ceramic, terracotta, glass };

/// How a vessel is handed to the renderer.
enum class VaseForm {
  either,  ///< turned where that is exact, a mesh elsewhere
  mesh,
  turned  ///< as Bézier curves that the renderer turns
};

/// A vase, a bowl or a pot.
struct VaseParams {
  VesselShape shape;
  VaseMaterial material = VaseMaterial::ceramic;
  Color color{0.62f, 0.72f, 0.64f};   ///< of glaze, clay or glass
  Color second{0.52f, 0.40f, 0.30f};  ///< of the bare clay, of what the clay sweats out
  double crackle = 0.5;     ///< 0 an even glaze .. 1 one with cracks, spots and runs; roughness of clay
  double moss = 0;          ///< 0 none .. 1: green at the foot of clay
  double gloss = 0.8;       ///< 0 matt .. 1
  double variation = 0.06;  ///< how much the brightness of single ones differs
  std::vector<Band> bands;  ///< painted round it
  double soil = 0;          ///< share of its height up to which it is filled with earth; 0: empty
  VaseForm form = VaseForm::either;
};

/// Makes one that stands on the origin. Curves that make no vessel are errors.
Result<Model> grow_vase(const VaseParams& params, Seed seed);

}  // namespace frond
