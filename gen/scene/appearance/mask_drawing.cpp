#include "appearance/mask_drawing.h"

#include <algorithm>

namespace frond {

Drawing mask_drawing(const Mask& mask) {
  constexpr double kMaskSecondsAPixel = 1e-7;
  return drawing_of(mask.picture_name(), static_cast<double>(mask.grey->size()), kMaskSecondsAPixel, [mask] {
    Raster picture(mask.width, mask.height, 1);
    std::ranges::transform(*mask.grey, picture.data.begin(), [](float grey) { return to_byte(grey); });
    return picture;
  });
}

}  // namespace frond
