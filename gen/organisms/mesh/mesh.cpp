#include "organisms/mesh/mesh.h"

namespace frond {

Result<Model> build_mesh_model(const MeshParams& params) {
  if (params.mesh.triangle.empty()) return Error{"", "file \"" + params.file + "\" has not been read"};
  Model model;
  Material matter{params.matter, params.color, params.second, params.scale};
  matter.moss = params.weathering;
  Vec3 size(static_cast<float>(params.size));
  model.solids.place(model.solids.add_shape({params.mesh, matter}), Vec3(0), Quat(1, 0, 0, 0), size);
  return model;
}

}  // namespace frond
