#pragma once

#include "scene/scene.h"

namespace frond {

/// Lets copies of what is sown with a `present` come up and go in each year that the scene's `year` passes
/// through: each at a time of its own in the first half of that part of the year and in the second. Without a
/// `year` they stand over the whole film.
void set_copy_lifetimes(Scene& scene, const Preset& preset);

}  // namespace frond
