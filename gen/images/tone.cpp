#include "images/tone.h"

#include <algorithm>
#include <cmath>

#include "core/linear.h"
#include "images/png_samples.h"
#include "images/raster.h"

namespace frond {

namespace {

constexpr double kGrey = 0.18;  ///< that contrast turns about
constexpr double kKnee = 0.55;  ///< where highlights begin to bend

double contrasted(double light, double contrast) { return kGrey * std::pow(light / kGrey, contrast); }

}  // namespace

double toned(double light, const Tone& tone) {
  double brightest = contrasted(std::exp2(tone.highlights), tone.contrast),
         at = contrasted(std::exp2(tone.highlights) * light, tone.contrast);
  if (at <= kKnee || brightest <= 1) return at;
  double bend = 1 / (1 - kKnee) - 1 / (brightest - kKnee);
  return kKnee + (at - kKnee) / (1 + bend * (at - kKnee));
}

namespace {

/// The picture of 16 bits a channel whose samples are given as shares.
template <class Share>
Result<std::string> deep_png(const LinearRaster& like, const Share& share) {
  PngSamples samples{like.width, like.height, like.channels, 16, 45455, {}};
  samples.data.resize(2 * like.data.size());
  for (std::size_t i = 0; i < like.data.size(); ++i) samples.set16(i, share(i));
  return samples_text(samples);
}

template <class Share>
Result<std::string> plain_png(const LinearRaster& like, const Share& share) {
  Raster picture(like.width, like.height, like.channels);
  for (std::size_t i = 0; i < picture.data.size(); ++i) picture.data[i] = to_byte(share(i));
  return png_text(picture);
}

}  // namespace

Result<std::string> develop(std::span<const std::string> pngs, const Tone& tone, int depth) {
  LinearRaster light;
  std::vector<std::uint32_t> sum;
  for (const std::string& png : pngs) {
    Result<LinearRaster> read = read_linear_png(png, true);
    if (!read) return read.errors();
    if (!sum.empty() &&
        (read->width != light.width || read->height != light.height || read->channels != light.channels))
      return Error{"", "the pictures differ in size"};
    light = std::move(*read);
    sum.resize(light.data.size());
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += light.data[i];
  }
  std::vector<double> curve(1 << 16);
  for (std::size_t i = 0; i < curve.size(); ++i)
    curve[i] = encoded(toned(static_cast<double>(i) / 65535, tone));
  auto count = static_cast<std::uint32_t>(pngs.size()), all = std::uint32_t{65535} * count;
  // Colours are multiplied by their opacity.
  auto share = [&](std::size_t i) {
    if (light.channels == 3) return curve[(sum[i] + count / 2) / count];
    std::uint32_t opacity = sum[i | 3];
    if (i % 4 == 3) return static_cast<double>(opacity) / all;
    if (opacity == 0) return 0.0;
    return curve[std::min<std::uint64_t>((std::uint64_t{sum[i]} * 65535 + opacity / 2) / opacity, 65535)];
  };
  return depth == 16 ? deep_png(light, share) : plain_png(light, share);
}

}  // namespace frond
