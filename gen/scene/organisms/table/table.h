#pragma once

#include "accretion/margin.h"
#include "core/result.h"
#include "model/model.h"
#include "motion/motion.h"
#include "organisms/body_colony.h"

namespace frond {

/// A table coral: a level disc on a short stalk, covered with short branches.
struct TableParams {
  double across = 0.7;       ///< metres
  double height = 0.24;      ///< metres
  double stalk = 0.16;       ///< metres, width of its stalk
  double lobes = 0.55;       ///< see Margin
  double thickness = 0.010;  ///< metres, of the table at its rim
  double branchlet = 0.03;   ///< metres, length of branchlets
  double spacing = 0.012;    ///< metres from one branchlet to the next
  double edge = 0.012;       ///< metres, of triangles
  TissueLook tissue;
  Growth growth;
};

/// Its disc, before it gets a thickness.
Sheet table_sheet(const TableParams& params, const Surroundings& around, Seed seed);

Result<Model> grow_table(const TableParams& params, const Surroundings& around, Seed seed);

}  // namespace frond
