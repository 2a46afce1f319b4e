#pragma once

#include "scene/scene.h"

namespace frond {

/// Whether the wind moves the copies of a set.
bool sways(const CopySet& set, const Film& film);

/// The axes of copy number i at a time in seconds, turned and sheared by the wind, before its scale.
glm::mat3 copy_axes(const CopySet& set, const Film& film, std::size_t i, double time);

}  // namespace frond
