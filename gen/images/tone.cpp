#include "images/tone.h"

#include <cmath>

#include "core/linear.h"
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

Result<std::string> develop(std::span<const std::string> pngs, const Tone& tone) {
  LinearRaster light;
  std::vector<std::uint32_t> sum;
  for (const std::string& png : pngs) {
    Result<LinearRaster> read = read_linear_png(png);
    if (!read) return read.errors();
    if (!sum.empty() && (read->width != light.width || read->height != light.height))
      return Error{"", "the pictures differ in size"};
    light = std::move(*read);
    sum.resize(light.data.size());
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += light.data[i];
  }
  std::vector<std::uint8_t> curve(1 << 16);
  for (std::size_t i = 0; i < curve.size(); ++i)
    curve[i] = to_byte(encoded(toned(static_cast<double>(i) / 65535, tone)));
  Raster picture(light.width, light.height, 3);
  auto count = static_cast<std::uint32_t>(pngs.size());
  for (std::size_t i = 0; i < picture.data.size(); ++i) picture.data[i] = curve[(sum[i] + count / 2) / count];
  return png_text(picture);
}

}  // namespace frond
