#pragma once

#include <optional>

#include "appearance/appearance.h"
#include "core/result.h"

namespace frond {

/// Errors for pictures of bark and leaves that have too many pixels for one file. Pointers are relative to
/// the organism; `leaves_pointer` is that of the leaves' pixels.
Errors check_pictures(const std::optional<BarkCoat>& coat, const std::optional<LeafLook>& leaves,
                      const char* leaves_pointer);
Errors check_pictures(const TreeAppearance& appearance);

}  // namespace frond
