#include "appearance/picture_bounds.h"

#include <fmt/format.h>

namespace frond {

namespace {

constexpr double kMostPixels = 1 << 26;  // as many as a square of 8192

void check_pixels(Errors& errors, const char* pointer, double wide, double high, const char* narrower) {
  if (wide * high <= kMostPixels) return;
  errors.push_back(
      {pointer, fmt::format("makes a picture of {:.6g} x {:.6g} pixels; expected {:.2g} pixels at "
                            "most, by a smaller number or a smaller {}",
                            wide, high, kMostPixels, narrower)});
}

}  // namespace

Errors check_pictures(const std::optional<BarkCoat>& coat, const std::optional<LeafLook>& leaves,
                      const char* leaves_pointer) {
  Errors errors;
  if (coat) check_pixels(errors, "/coat/pixels", coat->pixels, coat->pixels * coat->aspect, "aspect");
  if (!leaves) return errors;
  PictureFrame frame = picture_frame(leaf_image(*leaves, 0));
  double wide = 2 * frame.half / (frame.high - frame.low);
  check_pixels(errors, leaves_pointer, wide * leaves->pixels, leaves->pixels, "width");
  return errors;
}

Errors check_pictures(const TreeAppearance& appearance) {
  return check_pictures(appearance.coat, appearance.leaves, "/leaves/pixels");
}

}  // namespace frond
