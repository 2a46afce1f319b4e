#include "organisms/bridge/describe.h"
#include "organisms/kinds.h"

namespace frond {

namespace {

class BridgeGrower final : public Described<BridgeParams, BodyBuilder> {
 public:
  Errors check() const override { return {}; }
  Result<Foresight> foresee(Seed) const override {
    const BridgeShape& b = params.shape;
    Foresight bridge;
    bridge.blocks = b.length / (b.plank + b.gap) + 4.0 * b.posts * (2 + b.balusters);
    bridge.triangles = b.style == BridgeStyle::stone ? 2.2e5 : 260 * bridge.blocks;
    return bridge;
  }
  Result<Model> grow_alone(Seed seed) const override { return grow_bridge(params, seed); }
};

}  // namespace

Kind<Organism> bridge_kind() {
  return make_grower<BridgeGrower>("bridge", "A humped garden bridge of wood or stone");
}

}  // namespace frond
