#include "images/differ.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/linear.h"

namespace frond {

namespace {

constexpr float kFarOff = 8;  ///< steps of 255

bool of_16_bits(std::string_view png) {
  constexpr std::size_t kBitDepth = 24;  // where the first chunk holds it
  return png.size() > kBitDepth && png[kBitDepth] == 16;
}

/// A channel, 0 to 255, before black.
float before_black(std::uint8_t value, std::uint8_t opacity) {
  if (opacity == 255) return value;
  return static_cast<float>(255 * encoded(linear(value / 255.0) * opacity / 255));
}

}  // namespace

SeenPicture seen(const Raster& raster) {
  SeenPicture picture{raster.width, raster.height, {}};
  auto channels = static_cast<std::size_t>(raster.channels);
  std::size_t pixels = raster.data.size() / channels;
  picture.values.reserve(3 * pixels);
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
    const std::uint8_t* from = &raster.data[pixel * channels];
    std::uint8_t opacity = channels == 4 ? from[3] : 255;
    for (std::size_t c = 0; c < 3; ++c)
      picture.values.push_back(before_black(from[channels == 1 ? 0 : c], opacity));
  }
  return picture;
}

SeenPicture seen(const LinearRaster& raster) {
  std::vector<float> curve(1 << 16);
  for (std::size_t i = 0; i < curve.size(); ++i)
    curve[i] = static_cast<float>(255 * encoded(static_cast<double>(i) / 65535));
  SeenPicture picture{raster.width, raster.height, {}};
  picture.values.reserve(raster.data.size());
  for (std::uint16_t light : raster.data) picture.values.push_back(curve[light]);
  return picture;
}

Result<SeenPicture> read_seen_png(std::string_view bytes) {
  auto seen_of = [](const auto& raster) -> Result<SeenPicture> {
    if (!raster) return raster.errors();
    return seen(*raster);
  };
  return of_16_bits(bytes) ? seen_of(read_linear_png(bytes)) : seen_of(read_png(bytes));
}

Difference Differ::add(const SeenPicture& a, const SeenPicture& b) {
  assert(a.width == b.width && a.height == b.height);
  assert(frames_ == 0 || a.values.size() == means_.size());
  means_.resize(a.values.size());
  spreads_.resize(a.values.size());
  ++frames_;
  double squares = 0;
  float maximum = 0;
  std::size_t far_off = 0;
  for (std::size_t i = 0; i < a.values.size(); i += 3) {
    float most = 0;
    for (std::size_t at = i; at < i + 3; ++at) {
      float off = a.values[at] - b.values[at];
      squares += double{off} * off;
      most = std::max(most, std::abs(off));
      // Mean and spread as they grow by one value (Welford, 1962): exact where nothing changes.
      float before = off - means_[at];
      means_[at] += before / static_cast<float>(frames_);
      spreads_[at] += before * (off - means_[at]);
    }
    maximum = std::max(maximum, most);
    if (most > kFarOff) ++far_off;
  }
  auto count = static_cast<double>(std::max<std::size_t>(a.values.size(), 1));
  Difference difference{std::sqrt(squares / count), maximum, 3 * static_cast<double>(far_off) / count};
  if (maximum > 0) ++differing_;
  if (difference.error > worst_error_) worst_ = frames_, worst_error_ = difference.error;
  squares_ += squares / count;
  maximum_ = std::max(maximum_, difference.maximum);
  shares_ += difference.share;
  return difference;
}

Difference Differ::total() const {
  double count = std::max(frames_, 1);
  return {std::sqrt(squares_ / count), maximum_, shares_ / count};
}

double Differ::flicker() const {
  double sum = 0;
  for (float spread : spreads_) sum += std::max(spread, 0.0f);
  auto count = static_cast<double>(std::max<std::size_t>(spreads_.size(), 1));
  return std::sqrt(sum / count / std::max(frames_, 1));
}

}  // namespace frond
