#include "organisms/tree_parts.h"

namespace frond {

void put_leaves(Model& model, const std::vector<LeafSite>& sites, const TreeAppearance& appearance, Vec3 size,
                Seed seed) {
  if (sites.empty()) return;
  const LeafLook& look = appearance.leaves;
  model.prototypes = leaf_prototypes(leaves_of(appearance));
  bool both = model.prototypes.size() > 1;
  if (appearance.season) add_seasonal(model.prototypes, *appearance.season);
  Organs& o = model.organs;
  o.reserve(sites.size());
  for (std::size_t i = 0; i < sites.size(); ++i) {
    const LeafSite& site = sites[i];
    Seed own = seed.child(i);
    auto tilt = [&](std::uint64_t k, Vec3 axis) {
      return glm::angleAxis(static_cast<float>(look.turn_variation * own.child(k).range(-1, 1)), axis);
    };
    auto vary = static_cast<float>(1 + look.size_variation * own.child(3).range(-1, 1));
    o.prototype.push_back(both && model.skeleton.to_tip[site.node] > 0 ? 1 : 0);
    o.position.push_back(site.position);
    o.turn.push_back(
        glm::normalize(site.turn * tilt(0, Vec3(1, 0, 0)) * tilt(1, Vec3(0, 1, 0)) * tilt(2, Vec3(0, 0, 1))));
    o.scale.push_back(glm::max(size * (site.size * vary), Vec3(1e-5f)));
    o.node.push_back(site.node);
    o.birth.push_back(model.skeleton.birth[site.node]);
    o.color.push_back(static_cast<std::int32_t>(own.child(4).bits() % look.colors.size()));
    o.id.push_back(static_cast<std::uint32_t>(i));
  }
}

}  // namespace frond
