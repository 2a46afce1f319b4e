#pragma once

#include <vector>

#include "core/result.h"
#include "masonry/vessel.h"
#include "model/model.h"

namespace frond {

/// How a vessel is passed to the renderer.
enum class VaseForm {
  either,  ///< as a surface of revolution if exact, otherwise a mesh
  mesh,
  turned  ///< as Bézier curves that the renderer turns
};

/// A vase, a bowl or a pot.
struct VaseParams {
  VesselShape shape;
  Matter material = Matter::ceramic;  ///< ceramic, terracotta or glass
  Color color{0.62f, 0.72f, 0.64f};   ///< of glaze, clay or glass
  Color second{0.52f, 0.40f, 0.30f};  ///< of the bare clay, and of efflorescence on it
  double crackle = 0.5;               ///< 0 an even glaze .. 1 with cracks, spots and runs; roughness of clay
  double moss = 0;                    ///< 0 none .. 1: green at the foot of clay vessels
  double gloss = 0.8;                 ///< 0 matt .. 1
  double variation = 0.06;            ///< variation of brightness between individuals
  std::vector<Band> bands;            ///< painted round it
  double soil = 0;                    ///< share of its height filled with earth; 0: empty
  VaseForm form = VaseForm::either;
};

/// Makes one that stands on the origin. Invalid curves are errors.
Result<Model> grow_vase(const VaseParams& params, Seed seed);

}  // namespace frond
