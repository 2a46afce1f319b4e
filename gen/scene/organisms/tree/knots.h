#pragma once

#include <span>
#include <vector>

#include "core/seed.h"
#include "grove/standing.h"
#include "model/model.h"

namespace frond {

/// The stub of a bough that fell.
struct Knot {
  std::int32_t node = 0;  ///< of the skeleton: its end
  Vec3 direction{0};      ///< its direction, of length 1
  float wound = 0;        ///< metres, radius of the bare wood at its end; 0: closed over by bark
  std::uint32_t id = 0;
};

/// Appends a stub to the skeleton for every bough that has fallen by that year. It rots back over the years
/// and the stem grows over it: first a ring of bark grows round its end, then the wound closes, then the
/// bulge disappears into the stem. `node` is that of each standing internode; `length` is a factor of how far
/// stubs stand out. Continuous in time after the fall of the bough.
std::vector<Knot> add_knots(Skeleton& skeleton, const Standing& now, const GrownTree& tree,
                            std::span<const std::int32_t> node, double length, double year, Seed seed);

/// Adds bare wood to the ends of stubs that are not closed. Its shape is added where there are none as well:
/// a model has the same shapes at all times.
void add_wounds(Model& model, std::span<const Knot> knots);

}  // namespace frond
