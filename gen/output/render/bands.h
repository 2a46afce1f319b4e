#pragma once

#include <span>
#include <string>

#include "core/result.h"

/// A still in bands of rows, each a picture of the whole size of which only they are drawn.
namespace frond {

/// Rows `top` up to before `below`, counted from 0.
struct BandRows {
  int top = 0, below = 0;
};

/// Those of the band of that number, from 1 on, of so many. Anti-aliasing looks at neighbours within
/// POV-Ray's blocks of 32 rows and not beyond, so bands that end where blocks do have the pixels of the whole
/// picture.
BandRows band_rows(int bands, int band, int height);

/// The PNG files of all bands as one, with the colours and bits of the first.
Result<std::string> join_bands(std::span<const std::string> pngs);

}  // namespace frond
