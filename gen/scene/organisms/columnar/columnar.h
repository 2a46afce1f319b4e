#pragma once

#include "accretion/accretion.h"
#include "core/result.h"
#include "model/model.h"
#include "motion/motion.h"
#include "organisms/colony.h"
#include "organisms/tissue_look.h"

namespace frond {

/// A coral that grows by layers where light and food arrive, so that fingers, knobs or pillars form without a
/// rule.
struct ColumnarParams {
  Accretion accretion;
  TissueLook tissue;
  Growth growth;
};

Result<Model> grow_columnar(const ColumnarParams& params, const Surroundings& around, Seed seed);

}  // namespace frond
