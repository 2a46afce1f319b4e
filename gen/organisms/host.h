#pragma once

#include <string>
#include <vector>

#include "core/result.h"
#include "geometry/column.h"
#include "geometry/wall.h"
#include "model/model.h"

namespace frond {

/// A wall of bricks.
struct WallParams {
  WallShape shape;
  std::vector<Color> bricks{{0.50f, 0.29f, 0.22f}, {0.44f, 0.24f, 0.18f}, {0.53f, 0.35f, 0.27f}};
  Color mortar{0.70f, 0.66f, 0.58f};
  Color stone{0.74f, 0.70f, 0.61f};  ///< of sills and lintels
  Color paint{0.80f, 0.83f, 0.79f};  ///< of windows and doors
  double weathering = 0.5;           ///< 0 clean .. 1: soot, damp and moss
};

/// A column of limestone.
struct ColumnParams {
  ColumnShape shape;
  Color stone{0.80f, 0.76f, 0.66f};
  double weathering = 0.5;
};

/// A body from an OBJ file.
struct MeshParams {
  std::string file;  ///< as seen from the preset's folder, or from where the program runs
  Surface mesh;      ///< what that file holds, standing on the origin, its longest side one unit long
  double size = 1;   ///< metres, of its longest side
  Matter matter = Matter::limestone;
  Color color{0.74f, 0.71f, 0.64f};
  Color second{0.45f, 0.42f, 0.36f};
  double scale = 0.1;  ///< metres, of the pattern
  double weathering = 0.4;
};

/// They stand with the middle of their foot at the origin; their hull is closed (a file's is as it is).
Model build_wall_model(const WallParams& params, Seed seed);
Model build_column_model(const ColumnParams& params);
Result<Model> build_mesh_model(const MeshParams& params);

}  // namespace frond
