#include <algorithm>
#include <cmath>

#include "dress/picture_bounds.h"
#include "organisms/kinds.h"
#include "organisms/weber_penn/describe.h"

namespace frond {

namespace {

constexpr double kMostNodes = 8e6;

class WeberPennGrower final : public Described<WeberPennParams, LoneGrower> {
 public:
  Errors check() const override {
    if (foresee_nodes(params.tree) < kMostNodes) return check_pictures(params.dress);
    return {{"", "the tree would have more than 4000000 nodes; fewer branches, splits or segments"}};
  }
  Result<Foresight> foresee(Seed) const override {
    const WeberPenn& form = params.tree;
    Foresight tree;
    tree.nodes = foresee_nodes(form);
    tree.organs = 0.72 * tree.nodes * std::abs(form.leaves) * form.leaf_quality /
                  std::max(1, form.stem(form.levels - 1).curve_res * form.smoothing);
    tree.parts = tree.organs;
    return tree;
  }
  double tallest() const override { return 1.2 * (params.tree.scale + params.tree.scale_v); }
  Dress dress() const override {
    Dress dress = dress_of(params.dress, params.tree.leaves != 0);
    dress.look.lobes = params.tree.lobes;
    dress.look.lobe_depth = params.tree.lobe_depth;
    return dress;
  }
  bool develops(bool) const override { return params.dress.season.has_value(); }
  std::optional<Result<Grammar>> grammar() const override { return std::nullopt; }
  Result<Model> grow_alone(Seed seed) const override { return grow_weber_penn_tree(params, seed); }
  std::function<Result<Model>(double)> develop(const Motion&, Seed) const override { return {}; }
};

}  // namespace

Kind<Organism> weber_penn_kind() {
  return make_grower<WeberPennGrower>("weber_penn", "A tree by the parameters of Weber and Penn");
}

}  // namespace frond
