#pragma once

#include <string>

namespace frond {

/// What the names of all files of a frame begin with, wherever one is written or named: "frame_0001"; more
/// digits from 10000 on.
std::string frame_name(int frame);

/// That of an exposure of it: "frame_0001_s2"; the first, and 0, bear the frame's own name.
std::string exposure_name(int frame, int exposure);

}  // namespace frond
