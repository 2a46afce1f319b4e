#include <algorithm>
#include <cmath>

#include "crown/weber_penn.h"

namespace frond {

namespace {

double envelope_ratio(double ratio, const Pruning& p) {
  if (ratio < 0 || ratio > 1) return 0;
  // The paper's divisor of the lower part would leave a step at the peak; its own peak does not.
  double above = 1 - p.width_peak;
  if (ratio < above) return std::pow(ratio / above, p.power_high);
  return p.width_peak > 0 ? std::pow((1 - ratio) / p.width_peak, p.power_low) : 1;
}

}  // namespace

double shape_ratio(CrownShape shape, double ratio, const Pruning& pruning, double cone_top) {
  switch (shape) {
    case CrownShape::conical:
      return cone_top + (1 - cone_top) * ratio;
    case CrownShape::spherical:
      return 0.2 + 0.8 * std::sin(kPi * ratio);
    case CrownShape::hemispherical:
      return 0.2 + 0.8 * std::sin(0.5 * kPi * ratio);
    case CrownShape::cylindrical:
      return 1;
    case CrownShape::tapered_cylindrical:
      return 0.5 + 0.5 * ratio;
    case CrownShape::flame:
      return ratio <= 0.7 ? ratio / 0.7 : (1 - ratio) / 0.3;
    case CrownShape::inverse_conical:
      return 1 - 0.8 * ratio;
    case CrownShape::tend_flame:
      return ratio <= 0.7 ? 0.5 + 0.5 * ratio / 0.7 : 0.5 + 0.5 * (1 - ratio) / 0.3;
    case CrownShape::envelope:
      return envelope_ratio(ratio, pruning);
  }
  return 0;
}

double taper_radius(double taper, double radius, double length, double z) {
  double unit = taper <= 1 ? taper : taper <= 2 ? 2 - taper : 0;
  double straight = radius * (1 - unit * z);
  if (taper <= 1) return straight;
  double left = (1 - z) * length;
  double depth = taper < 2 || left < straight ? 1 : taper - 2;
  double period = 2 * straight;
  double from_end =
      taper < 2 || period <= 0 ? left : std::abs(left - period * std::floor(left / period + 0.5));
  if (taper < 2 && from_end >= straight) return straight;
  double off = from_end - straight;
  return (1 - depth) * straight + depth * std::sqrt(std::max(straight * straight - off * off, 0.0));
}

double flare_factor(double flare, double z) {
  double y = std::max(0.0, 1 - 8 * z);
  return 1 + flare * (std::pow(100.0, y) - 1) / 100;
}

double stem_count(const WeberPenn& tree, int n, double share, double offset) {
  double most = tree.stem(n + 1).branches;
  if (n == 0) return most;
  if (n == 1) return most * (0.2 + 0.8 * share);
  return most * (1 - 0.5 * offset);
}

double estimate_nodes(const WeberPenn& tree) {
  double stems = tree.trunks, nodes = 1;
  for (int n = 0; n < tree.levels; ++n) {
    const StemLevel& level = tree.stem(n);
    if (n > 0) stems *= level.branches * (n == 1 ? 1 : 0.7);
    // Clones share what their stem bears.
    double clones = std::pow(1 + level.seg_splits, std::max(level.curve_res - 1, 0) * 0.5);
    if (n == 0) clones *= 1 + tree.base_splits;
    double borne = n + 1 < tree.levels ? tree.stem(n + 1).branches * 0.7 : 0;
    nodes += stems * (clones * level.curve_res * tree.smoothing + borne);
  }
  return nodes;
}

}  // namespace frond
