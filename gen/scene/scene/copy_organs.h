#pragma once

#include <vector>

#include "scene/copies.h"

namespace frond {

/// All organs of one prototype, each part of them as one mesh; dew is left out, which from there is not seen.
/// Organs that are small or many become fewer and larger ones with the same area. With `now`, organs of the
/// model at some time, these are drawn.
std::vector<CopyPart> merged_organs(const Model& model, std::size_t which, const CopyDetail& detail,
                                    const ModelBlocks* blocks, const Organs* now);

}  // namespace frond
