#pragma once

#include <span>

#include "export/maker.h"

namespace frond {

/// What the bodies of a model that wears such a look are made of, one part a material, where they stand;
/// `keys` are the same bodies in the shapes of the cast's keys but the last.
std::vector<ExportPart> body_parts(Maker& maker, const Look& look, const Solids& solids,
                                   std::span<const Solids> keys = {});

}  // namespace frond
