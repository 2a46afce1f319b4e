#pragma once

#include <vector>

#include "scene/copies.h"

namespace frond {

bool is_fruit(const Prototype& organ);

/// The area of the organs of each prototype of a model, m2; of a round one that of the leaf which it is from
/// afar, of fruit none.
std::vector<double> organ_areas(const Model& model);

/// The share of the leaves of a model that hides what is behind its crown as all of them do: ten times its
/// silhouette (Monsi and Saeki 1953: less than a hundredth of the light goes through that). What is left of
/// leaves need not have the area of more.
double hiding_share(const Model& model, double area);

/// All organs of one prototype, each part of them as one mesh; dew is left out, which from there is not seen.
/// Organs that are small or many become fewer and larger ones with the same area, or that share of it which
/// covers. With `now`, organs of the model at some time, these are drawn.
std::vector<CopyPart> merged_organs(const Model& model, std::size_t which, const CopyDetail& detail,
                                    const ModelBlocks* blocks, const Organs* now);

}  // namespace frond
