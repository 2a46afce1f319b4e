#include "organisms/kinds.h"
#include "organisms/mesh/describe.h"

namespace frond {

namespace {

class MeshGrower final : public Described<MeshParams, BodyBuilder> {
 public:
  Errors check() const override { return {}; }
  Result<Foresight> foresee(Seed) const override {
    Foresight mesh;
    mesh.triangles = static_cast<double>(params.mesh.triangle.size());
    mesh.blocks = 1;
    return mesh;
  }
  Result<Model> grow_alone(Seed) const override { return build_mesh_model(params); }
};

}  // namespace

Kind<Organism> mesh_kind() { return make_grower<MeshGrower>("mesh", "A body from an OBJ file"); }

}  // namespace frond
