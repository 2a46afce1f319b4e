#pragma once

#include <span>

#include "world/specimen.h"

namespace frond {

/// Finds when food is reached by a tip of one that eats it (Food::eaten), through a film of so many seconds:
/// the specimens are posed at steps of 0.1 s, what is eaten pulls no more from then on. Food at the same
/// place, or on the same way, is the same food for all.
void feed(std::span<Specimen> specimens, double film);

}  // namespace frond
