#pragma once

#include <optional>

#include "core/result.h"
#include "dress/dress.h"

namespace frond {

/// Pictures of bark and leaves of more pixels than one file is to have. Errors stand at the pointer within
/// the organism; `leaves_pointer` is that of the leaves' pixels.
Errors check_pictures(const std::optional<BarkCoat>& coat, const std::optional<LeafLook>& leaves,
                      const char* leaves_pointer);
Errors check_pictures(const TreeDress& dress);

}  // namespace frond
