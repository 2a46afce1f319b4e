#include "organisms/column/column.h"

#include "geometry/crease.h"
#include "masonry/tone.h"

namespace frond {

Model build_column_model(const ColumnParams& params) {
  Model model;
  model.hull = column_surface(params.shape);
  Material stone{Matter::limestone, params.stone, toned(params.stone, 0.55, 0.03)};
  stone.scale = 0.25, stone.moss = params.weathering;
  model.solids.place(model.solids.add_shape({creased(model.hull, radians(32.0)), stone}));
  return model;
}

}  // namespace frond
