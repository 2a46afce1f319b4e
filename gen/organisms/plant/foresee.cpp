#include "organisms/plant/foresee.h"

#include <algorithm>

#include "grammar/figure.h"
#include "organisms/plant/organ_prototypes.h"

namespace frond {

void count_organs(const PlantParams& params, Seed seed, Foresight& plant) {
  constexpr double kCounted = 1e5;  // modules or segments
  Result<Grammar> grammar = plant_grammar(params);
  if (!grammar) return;
  int steps = grammar->text.steps;
  auto large = [&](int n) {
    Forecast word = forecast(*grammar, n, seed);
    return std::max(word.modules, word.segments) > kCounted;
  };
  while (steps > 1 && large(steps)) --steps;
  std::vector<std::string> names;
  for (const OrganParams& organ : params.organs) names.push_back(organ.symbol);
  Limits limits{2'000'000, std::size_t{64} << 20};
  Result<Figure> figure = figure_of(*grammar, steps, seed, limits, names, params.by_steps);
  if (!figure) return;
  auto segments = static_cast<double>(figure->skeleton.size());
  std::vector<bool> goes_on(figure->skeleton.size());
  for (std::int32_t below : figure->skeleton.parent)
    if (below != Skeleton::kRoot) goes_on[static_cast<std::size_t>(below)] = true;
  auto tips = static_cast<double>(std::count(goes_on.begin(), goes_on.end(), false));
  plant.chains = tips / std::max(1.0, segments * params.smoothing);
  double scale = 1;
  if (steps == grammar->text.steps)
    plant.nodes = segments * params.smoothing;
  else
    scale = std::max(1.0, plant.word.segments / std::max(segments, 1.0));
  std::vector<Prototype> prototypes = organ_prototypes(params);
  std::vector<bool> used(prototypes.size());
  for (const Site& site : figure->sites) {
    Variants kinds = variants_of(params, site.name);
    if (kinds.first < 0) continue;
    plant.organs += scale;
    plant.parts +=
        scale * static_cast<double>(prototypes[static_cast<std::size_t>(kinds.first)].parts.size());
    for (int k = 0; k < kinds.count; ++k) used[static_cast<std::size_t>(kinds.first + k)] = true;
  }
  for (const Outline& outline : figure->outlines)
    plant.corners += scale * static_cast<double>(outline.points.size());
  for (std::size_t p = 0; p < prototypes.size(); ++p)
    for (const OrganPart& part : prototypes[p].parts)
      if (used[p]) plant.shapes += static_cast<double>(part.surface.triangle.size());
}

}  // namespace frond
