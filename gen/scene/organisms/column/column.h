#pragma once

#include "masonry/column.h"
#include "model/model.h"

namespace frond {

/// A column of limestone.
struct ColumnParams {
  ColumnShape shape;
  Color stone{0.80f, 0.76f, 0.66f};
  double weathering = 0.5;
};

/// It stands with the middle of its foot at the origin; its hull is closed.
Model build_column_model(const ColumnParams& params);

}  // namespace frond
