#pragma once

#include <vector>

#include "core/result.h"
#include "scene/scene.h"

namespace frond {

/// A part of a model that has one look.
struct CopyPart {
  enum class Kind { wood, organ, blade, solid };
  Kind kind = Kind::wood;
  std::size_t which = 0;  ///< an organ's prototype, a solid's shape
  std::size_t part = 0;   ///< of the prototype
  /// `uv` of leaves: (k + u, v), where k is a whole number of each leaf's own, k modulo the number of colours
  /// the index of its colour, and (u, v) its place on the leaf; of wood as of tube_surface().
  Surface surface;
};

/// Grows model `which` of a sown organism, its foot at the origin. A tree with `crowd` grows up among six
/// neighbours. Its leaves are in the season that the film begins in. What it is made of depends on the
/// organism and its `seeds` alone, not on the scene's seed.
Result<Model> grow_copy(const Organism& organism, int which);

/// What stands for model `which` of a sown organism in names: it differs where the model does.
std::string copy_id(const Organism& organism, int which);

/// How a model is drawn.
struct CopyDetail {
  double grain = 0.002;  ///< metres that a pixel covers where it stands: what would be finer is left out
  double leaves = 4e5;   ///< triangles of leaves at most, about: more become fewer and larger ones
};

/// A model as meshes. What is left of its leaves has the area of all of them.
std::vector<CopyPart> copy_parts(const Look& look, const Model& model, const CopyDetail& detail);

}  // namespace frond
