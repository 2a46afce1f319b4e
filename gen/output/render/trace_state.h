#pragma once

#include <array>
#include <filesystem>
#include <optional>

#include "core/result.h"
#include "images/raster.h"
#include "images/tone.h"

namespace frond {

/// Makes the notes that a killed POV-Ray left of the blocks it had traced fit to be taken up again. What was
/// cut off in the middle goes, as POV-Ray would write on behind it. And with radiosity it begins by drawing
/// one coarse pixel, as large as the picture, for its first block, unless that one is done: it would cover
/// all others, so these go, too, where the first is missing. Notes of another renderer are left alone.
Errors keep_traced(const std::filesystem::path& state);

/// The picture so far: the blocks that the notes hold, in a tone; what is not traced yet is as in `below`, a
/// colour picture that is enlarged to this size, or grey. None where the notes hold no block, or are not of a
/// picture of that size.
std::optional<Raster> traced_picture(const std::filesystem::path& state, std::array<int, 2> size,
                                     const Tone& tone, const Raster* below = nullptr);

}  // namespace frond
