#pragma once

#include "accretion/margin.h"
#include "core/result.h"
#include "model/model.h"
#include "motion/motion.h"
#include "organisms/body_colony.h"

namespace frond {

/// Arrangement of the sheets of a leafy coral.
enum class FolioseForm {
  whorl,  ///< one round another, rising, like a lettuce
  plate   ///< horizontal, one above another
};

/// A leafy coral: ruffled sheets that grow at their rims.
struct FolioseParams {
  FolioseForm form = FolioseForm::whorl;
  double across = 0.32;  ///< metres
  double height = 0.2;   ///< metres
  int sheets = 9;
  double excess = 1.9;       ///< see Margin
  double ruffle = 0.05;      ///< metres
  double lobes = 0.35;       ///< see Margin
  double thickness = 0.006;  ///< metres, old parts
  double rim = 0.0025;       ///< metres, young parts
  double lines = 0.0008;     ///< metres, height of growth lines
  double edge = 0.0045;      ///< metres, of triangles
  TissueLook tissue;
  Growth growth;
};

/// Its sheets, before they get a thickness.
Sheet foliose_sheets(const FolioseParams& params, const Surroundings& around, Seed seed);

Result<Model> grow_foliose(const FolioseParams& params, const Surroundings& around, Seed seed);

}  // namespace frond
