#include "appearance/fruiting.h"
#include "geometry/mesh_file.h"

namespace frond {

Errors load_fruit_model(const NamedFile& file, Fruiting& fruit) { return load_unit_mesh(file, fruit.mesh); }

}  // namespace frond
