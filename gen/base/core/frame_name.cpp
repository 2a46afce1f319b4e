#include "core/frame_name.h"

#include <fmt/format.h>

namespace frond {

std::string frame_name(int frame) { return fmt::format("frame_{:04}", frame); }

std::string exposure_name(int frame, int exposure) {
  return frame_name(frame) + (exposure > 1 ? fmt::format("_s{}", exposure) : "");
}

}  // namespace frond
