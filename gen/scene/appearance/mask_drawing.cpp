#include "appearance/mask_drawing.h"

#include <algorithm>
#include <utility>

#include "images/raster.h"

namespace frond {

Drawing mask_drawing(const Mask& mask) {
  auto draw = [mask]() -> Result<std::vector<Picture>> {
    Raster picture(mask.width, mask.height, 1);
    std::ranges::transform(*mask.grey, picture.data.begin(), [](float grey) { return to_byte(grey); });
    Result<std::string> bytes = png_text(picture);
    if (!bytes) return bytes.errors();
    return std::vector<Picture>{{mask.picture_name(), std::move(*bytes)}};
  };
  constexpr double kMaskSecondsAPixel = 1e-7;
  auto pixels = static_cast<double>(mask.grey->size());
  return {{mask.picture_name()}, std::move(draw), pixels, kMaskSecondsAPixel * pixels};
}

}  // namespace frond
