#include "dynamics/growth.h"

#include <algorithm>
#include <utility>

namespace frond {

namespace {

constexpr double kOpenCrown = 0.85;   // share of the height that is crown in the open
constexpr double kLeastCrown = 0.15;  // the same of the most crowded tree
constexpr double kSlender = 110;      // height over diameter from which height lags, up to 140

/// cm of girth that a tree in the open adds, as metres of diameter: less as a sapling, and as it comes to its
/// greatest diameter.
double open_gain(const TreeSpecies& species, double diameter) {
  double full = diameter / species.diameter;
  return species.girth_gain / (100 * kPi) * (diameter + 0.01) / (diameter + 0.02) *
         std::max(1 - full * full, 0.0);
}

void raise_crown(StandTree& tree, const TreeSpecies& species, const Canopy& canopy) {
  const StandGrid& grid = canopy.grid;
  // The light among the lowest branches, in the tree's own shade.
  double out = 0.7 * tree.crown_radius, light = 0;
  for (auto [dx, dz] : {std::pair(-out, 0.0), {out, 0.0}, {0.0, -out}, {0.0, out}})
    light += canopy.light_above(grid.at(tree.x + dx, tree.z + dz), tree.crown_base) / 4;
  double needed = 0.9 * std::exp(-kExtinction * species.leaf_area);
  double rise = light < needed ? 0.6 * (1 - light / needed) : 0;
  double least = (1 - kOpenCrown) * tree.height, most = (1 - kLeastCrown) * tree.height;
  tree.crown_base = std::clamp(std::max(tree.crown_base + rise, least), 0.0, most);
}

}  // namespace

double light_response(const TreeSpecies& species, double light) {
  double tolerance = std::clamp((species.tolerance - 1) / 4, 0.0, 1.0);
  double bears = 1 - std::exp(-4.64 * (light - 0.03)), needs = 2.24 * (1 - std::exp(-1.136 * (light - 0.08)));
  return std::clamp(needs + (bears - needs) * tolerance, 0.0, 1.0);
}

double site_response(const TreeSpecies& species, double temperature, double moisture) {
  double warm = std::clamp((temperature - species.coldest) / 4, 0.0, 1.0);
  double off = (moisture - species.moisture) / species.moisture_span;
  return std::sqrt(warm) * std::exp(-0.5 * off * off);
}

double crown_radius_at(const TreeSpecies& species, double diameter) {
  return species.crown_foot + species.crown_gain * diameter;
}

void grow_year(StandTree& tree, const TreeSpecies& species, const Canopy& canopy) {
  CrownLight light = light_on(canopy, tree, species);
  double bright = light_response(species, light.top),
         crown = tree.crown_length() / (kOpenCrown * tree.height);
  double gain = bright * std::min(light.mean / light.top, 1.0) * std::sqrt(std::min(crown, 1.0)) * tree.site;
  tree.vigour += 0.3 * (gain - tree.vigour);

  // Poor places have lower trees: the curve of heights is lower there.
  double lower = 0.2 + 0.8 * tree.site, height = tree.height / lower;
  double rise = (height_at(species, age_at(species, height) + 0.5 + 0.5 * tree.talent) - height) * lower;
  double slender = std::clamp((kSlender + 30 - tree.height / tree.diameter) / 30, 0.0, 1.0);
  if (height < species.height) tree.height += std::max(rise, 0.0) * std::min(1.5 * bright, 1.0) * slender;
  tree.diameter += open_gain(species, tree.diameter) * gain * tree.talent;
  tree.crown_radius = crown_radius_at(species, tree.diameter);
  raise_crown(tree, species, canopy);
}

}  // namespace frond
