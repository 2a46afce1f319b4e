#include "images/photo.h"

#include <algorithm>
#include <array>

#include "core/linear.h"
#include "images/read_picture.h"

namespace frond {

namespace {

constexpr int kLeastSide = 16, kMostSide = 4096;

}  // namespace

Result<Raster> read_photo(std::string_view bytes) {
  Result<Raster> read = read_picture(bytes);
  if (!read) return read;
  auto [least, most] = std::minmax(read->width, read->height);
  if (least >= kLeastSide && most <= kMostSide) return read;
  return error_at("", "is a picture of {} x {} pixels; expected {} to {} pixels a side", read->width,
                  read->height, kLeastSide, kMostSide);
}

float linear(std::uint8_t channel) {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> all{};
    for (std::size_t i = 0; i < all.size(); ++i)
      all[i] = static_cast<float>(linear(static_cast<double>(i) / 255));
    return all;
  }();
  return table[channel];
}

}  // namespace frond
