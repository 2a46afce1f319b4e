#include <algorithm>

#include "appearance/fruiting.h"
#include "core/bounds.h"
#include "geometry/mesh_file.h"

namespace frond {

Errors load_fruit_model(const NamedFile& file, Fruiting& fruit) {
  if (Errors errors = load_unit_mesh(file, fruit.mesh); !errors.empty()) return errors;
  const Bounds box = bounds_of(fruit.mesh.position);
  const Vec3 sides = box.high - box.low;
  fruit.mesh_width = static_cast<double>(std::max(sides.x, sides.z));
  return {};
}

}  // namespace frond
