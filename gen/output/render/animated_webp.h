#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/result.h"

/// Animated WebP by libwebp: ffmpeg of Debian 12 writes them, but reads none, and gives them no metadata.
namespace frond {

/// Pictures (PNG, of one size up to 16383 pixels a side) as an animated WebP that is played again and again.
/// `fps`, a number of frames a second, is kept to a millisecond; title and comment are told as XMP. The
/// errors name what is wrong with a picture, or why there is no film.
Result<std::string> animated_webp(const std::vector<std::filesystem::path>& pictures, const std::string& fps,
                                  const std::string& title, const std::string& comment);

/// How long the film in the bytes of a WebP lasts, which holds pictures that are like those before them only
/// once; 0 where the bytes are not whole.
int milliseconds_in_webp(const std::string& bytes);

}  // namespace frond
