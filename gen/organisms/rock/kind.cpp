#include "organisms/kinds.h"
#include "organisms/rock/describe.h"

namespace frond {

namespace {

class RockGrower final : public Described<RockParams, BodyBuilder> {
 public:
  Errors check() const override { return check_rock(params.shape); }
  bool stands_on_rock() const override { return false; }
  Result<Foresight> foresee(Seed) const override {
    Foresight rock;
    rock.triangles = params.native ? 0 : foresee_triangles(params.shape);
    rock.blocks = 1;
    return rock;
  }
  Result<Model> grow_alone(Seed seed) const override { return build_rock(params, seed); }
};

}  // namespace

Kind<Organism> rock_kind() { return make_grower<RockGrower>("rock", "A rock: blobs, weathered"); }

}  // namespace frond
