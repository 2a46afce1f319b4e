#include <algorithm>
#include <cmath>

#include "dress/picture_bounds.h"
#include "organisms/colonized/describe.h"
#include "organisms/kinds.h"

namespace frond {

namespace {

class ColonizedGrower final : public Described<ColonizedParams, LoneGrower> {
 public:
  Errors check() const override {
    Errors errors = check_colonized(params);
    return errors.empty() ? check_pictures(params.dress) : errors;
  }
  Result<Foresight> foresee(Seed) const override {
    // Of the points no more count than have room beside each other, and many are taken by the way.
    const Colonization& how = params.growth_into;
    const EnvelopeParams& e = params.envelope;
    double room = e.width * e.height * (e.depth > 0 ? e.depth : e.width) / std::pow(how.kill, 3);
    double nodes = std::min({0.8 * how.attractors, 0.8 * room, static_cast<double>(how.most_nodes)});
    Foresight tree;
    tree.nodes = (nodes + e.base / how.step) * params.smoothing;
    double length = tree.nodes * how.step / params.smoothing;
    if (params.leaf_reach > 0) tree.organs = tree.parts = 0.5 * length / params.leaf_spacing;
    tree.nodes_a_second = kTreeNodesASecond;
    return tree;
  }
  double tallest() const override { return params.envelope.base + params.envelope.height; }
  Dress dress() const override { return dress_of(params.dress, params.leaf_reach > 0); }
  bool develops(bool) const override { return params.dress.season.has_value(); }
  std::optional<Result<Grammar>> grammar() const override { return std::nullopt; }
  Result<Model> grow_alone(Seed seed) const override { return grow_colonized_tree(params, seed); }
  std::function<Result<Model>(double)> develop(const Motion&, Seed) const override { return {}; }
};

}  // namespace

Kind<Organism> colonized_kind() {
  return make_grower<ColonizedGrower>("colonized", "A tree that fills an envelope");
}

}  // namespace frond
