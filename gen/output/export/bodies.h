#pragma once

#include <span>

#include "export/maker.h"

namespace frond {

/// What such bodies of an organism that wears a look are made of, one part a material, where they stand;
/// `keys` are its bodies in the shapes of the scene's keys but the last.
std::vector<ExportPart> body_parts(Maker& maker, const Look& look, std::span<const DrawnBody> bodies,
                                   std::span<const Solids> keys = {});

}  // namespace frond
