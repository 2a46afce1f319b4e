#include "organisms/kinds.h"
#include "organisms/vase/describe.h"

namespace frond {

namespace {

class VaseGrower final : public Described<VaseParams, BodyBuilder> {
 public:
  Errors check() const override {
    Result<VesselProfile> profile = vessel_profile(params.shape);
    return profile ? Errors{} : profile.errors();
  }
  Result<Foresight> foresee(Seed) const override {
    Foresight vase;
    vase.triangles = 4.4 * params.shape.sides * params.shape.rings;
    vase.blocks = 1;
    return vase;
  }
  Result<Model> grow_alone(Seed seed) const override { return grow_vase(params, seed); }
};

}  // namespace

Kind<Organism> vase_kind() {
  return make_grower<VaseGrower>("vase", "A vase, bowl or pot turned from a Bézier curve");
}

}  // namespace frond
