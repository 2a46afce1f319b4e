#pragma once

#include <string>

#include "emit/pov.h"
#include "light/light.h"
#include "world/specimen.h"

namespace frond {

/// The polyps of living bodies at a time, each on a place of its own, which the skin carries along as it
/// grows. Those that face away, or that are too small to be seen from `eye`, are left out.
std::string polyps_text(const PovSpace& space, const Solids& solids, const Growth& growth, double time,
                        const Eye& eye);

/// The same of branches: all round them by the golden angle, and one on each tip.
std::string branch_polyps_text(const PovSpace& space, const Specimen& b, const Pose& pose, double time,
                               const Eye& eye);

}  // namespace frond
