#pragma once

#include <filesystem>

#include "core/result.h"

namespace frond {

/// Makes the notes that a killed POV-Ray left of the blocks it had traced fit to be taken up again. What was
/// cut off in the middle goes, as POV-Ray would write on behind it. And with radiosity it begins by drawing
/// one coarse pixel, as large as the picture, for its first block, unless that one is done: it would cover
/// all others, so these go, too, where the first is missing. Notes of another renderer are left alone.
Errors keep_traced(const std::filesystem::path& state);

}  // namespace frond
