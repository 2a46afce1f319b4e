#pragma once

#include "core/assets.h"
#include "core/result.h"
#include "model/model.h"

namespace frond {

/// A body from an OBJ file.
struct MeshParams {
  FileName file;    ///< relative to the preset's folder, or to the working folder
  Surface mesh;     ///< content of the file, standing on the origin, its longest side one unit long
  double size = 1;  ///< metres, of its longest side
  Matter matter = Matter::limestone;
  Color color{0.74f, 0.71f, 0.64f};
  Color second{0.45f, 0.42f, 0.36f};
  double scale = 0.1;  ///< metres, of the pattern
  double weathering = 0.4;
};

/// Stands with the middle of its foot at the origin; its hull is the mesh of the file.
Result<Model> build_mesh_model(const MeshParams& params);

}  // namespace frond
