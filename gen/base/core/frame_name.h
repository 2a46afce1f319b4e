#pragma once

#include <string>

namespace frond {

/// The common beginning of the names of all files of a frame: "frame_0001"; more digits from 10000 on.
std::string frame_name(int frame);

/// The common beginning of the names of all files of one exposure of a frame: "frame_0001_s2"; exposures 0
/// and 1 have the frame's own name.
std::string exposure_name(int frame, int exposure);

}  // namespace frond
