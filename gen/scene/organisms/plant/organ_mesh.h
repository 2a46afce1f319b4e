#pragma once

#include "organisms/plant/plant.h"

namespace frond {

/// Reads the mesh of an organ of the shape `obj`, one unit long, and the picture that its materials name.
Errors load_organ_mesh(const NamedFile& file, OrganParams& organ);

/// Appends the parts of such an organ: what wears the picture, and the rest.
void add_organ_mesh(Prototype& to, const OrganParams& organ);

/// The pictures that it wears, one for each colour; none without a picture.
std::vector<Drawing> organ_mesh_drawings(const OrganParams& organ);

}  // namespace frond
