#include "organisms/weber_penn/weber_penn.h"

#include <algorithm>

#include "crown/arbaro.h"
#include "organisms/crown_leaves.h"

namespace frond {

Result<Model> grow_weber_penn_tree(const WeberPennParams& params, Seed seed) {
  Result<Crown> crown = grow_weber_penn(params.tree, seed.child("tree"));
  if (!crown) return crown.errors();
  Model model;
  model.skeleton = std::move(crown->skeleton);
  // What the stalk takes is not part of the blade, whose length LeafScale is.
  const WeberPenn& tree = params.tree;
  LeafLook look = params.dress.leaves;
  auto length = static_cast<float>(tree.leaf_scale * (1 + std::max(tree.leaf_stem_length, 0.0)));
  double share = 0;
  LeafImage image = leaf_image(look, 0);
  std::vector<Vec2> rim = leaf_rim(image.outline, 40);
  for (Vec2 p : rim) share = std::max<double>(share, 2 * p.x);
  // As wide as LeafScaleX asks, unless it is a sprig, which has its own shape.
  float wide =
      look.sprig ? length : static_cast<float>(tree.leaf_scale_x * tree.leaf_scale / std::max(share, 0.05));
  put_leaves(model, crown->leaves, params.dress, Vec3(wide, length, length), seed.child("leaf"));
  return model;
}

Errors load_species(const NamedFile& file, WeberPenn& tree) {
  Result<ArbaroSpecies> species = read_arbaro(file.text, file.path.string());
  if (!species) return species.errors();
  tree = species->tree;
  return {};
}

}  // namespace frond
