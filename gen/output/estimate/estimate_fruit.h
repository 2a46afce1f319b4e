#pragma once

#include <optional>

#include "appearance/season.h"
#include "organisms/grower.h"

namespace frond {

/// Adds the fruit to the organs of an organism in full leaf: that of all crops that may be there at once.
void count_fruit(SizeEstimate& size, const std::optional<Seasons>& seasons);

}  // namespace frond
