#include "organisms/kinds.h"
#include "organisms/pebbles/describe.h"

namespace frond {

namespace {

class PebblesGrower final : public Described<PebblesParams, BodyBuilder> {
 public:
  Errors check() const override { return check_pebbles(params); }
  bool stands_on_rock() const override { return false; }
  Result<Foresight> foresee(Seed) const override {
    Foresight field;
    field.triangles = params.shapes * foresee_triangles(params.shape);
    field.blocks = params.number;
    return field;
  }
  Result<Model> grow_alone(Seed seed) const override { return build_pebbles(params, seed); }
};

}  // namespace

Kind<Organism> pebbles_kind() {
  return make_grower<PebblesGrower>("pebbles", "Many small rocks that lie about");
}

}  // namespace frond
