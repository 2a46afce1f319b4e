#include "organisms/column/describe.h"
#include "organisms/kinds.h"

namespace frond {

namespace {

class ColumnGrower final : public Described<ColumnParams, BodyBuilder> {
 public:
  Errors check() const override { return {}; }
  Result<Foresight> foresee(Seed) const override {
    Foresight column;
    column.triangles = params.shape.broken > 0 ? 23e3 : 39e3;
    return column;
  }
  Result<Model> grow_alone(Seed) const override { return build_column_model(params); }
};

}  // namespace

Kind<Organism> column_kind() {
  return make_grower<ColumnGrower>("column", "A column of stone, whole or broken");
}

}  // namespace frond
