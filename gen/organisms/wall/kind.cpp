#include "organisms/kinds.h"
#include "organisms/wall/describe.h"

namespace frond {

namespace {

class WallGrower final : public Described<WallParams, BodyBuilder> {
 public:
  Errors check() const override { return {}; }
  Result<Foresight> foresee(Seed) const override {
    const WallShape& w = params.shape;
    Foresight wall;
    wall.blocks = w.width * w.height / ((w.brick.x + w.joint) * (w.brick.y + w.joint));
    wall.triangles = 18'000;
    return wall;
  }
  Result<Model> grow_alone(Seed seed) const override { return build_wall_model(params, seed); }
};

}  // namespace

Kind<Organism> wall_kind() {
  return make_grower<WallGrower>("wall", "A wall of bricks with windows and doors, or its ruin");
}

}  // namespace frond
