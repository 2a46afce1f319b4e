#include "images/tone.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "core/linear.h"
#include "images/png_rows.h"
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

/// Brings the light of pictures, summed up, to the curve of a tone.
class Developer {
 public:
  explicit Developer(const Tone& tone) : curve_(1 << 16) {
    for (std::size_t i = 0; i < curve_.size(); ++i)
      curve_[i] = encoded(toned(static_cast<double>(i) / 65535, tone));
  }

  /// Adds rows of a further picture to those before; false where they differ in size.
  bool add(const LinearRaster& light) {
    if (count_ > 0 && (light.width != width_ || light.channels != channels_ || light.height != height_))
      return false;
    width_ = light.width, height_ = light.height, channels_ = light.channels;
    sum_.resize(light.data.size());
    for (std::size_t i = 0; i < sum_.size(); ++i) sum_[i] += light.data[i];
    ++count_;
    return true;
  }

  PngSamples deep() const {
    PngSamples samples{width_, height_, channels_, 16, 45455, {}};
    samples.data.resize(2 * sum_.size());
    for (std::size_t i = 0; i < sum_.size(); ++i) samples.set16(i, share(i));
    return samples;
  }
  Raster plain() const {
    Raster picture(width_, height_, channels_);
    for (std::size_t i = 0; i < picture.data.size(); ++i) picture.data[i] = to_byte(share(i));
    return picture;
  }

  void begin_anew() { sum_.clear(), count_ = 0; }

 private:
  /// Colours are multiplied by their opacity.
  double share(std::size_t i) const {
    if (channels_ == 3) return curve_[(sum_[i] + count_ / 2) / count_];
    std::uint32_t opacity = sum_[i | 3];
    if (i % 4 == 3) return static_cast<double>(opacity) / (65535.0 * count_);
    if (opacity == 0) return 0.0;
    return curve_[std::min<std::uint64_t>((std::uint64_t{sum_[i]} * 65535 + opacity / 2) / opacity, 65535)];
  }

  std::vector<double> curve_;
  int width_ = 0, height_ = 0, channels_ = 3;
  std::uint32_t count_ = 0;
  std::vector<std::uint32_t> sum_;
};

const char* const kSizesDiffer = "the pictures differ in size";

Result<std::string> develop_whole(std::span<const std::string> pngs, const Tone& tone, int depth) {
  Developer developer(tone);
  for (const std::string& png : pngs) {
    Result<LinearRaster> read = read_linear_png(png, true);
    if (!read) return read.errors();
    if (!developer.add(*read)) return Error{"", kSizesDiffer};
  }
  return depth == 16 ? samples_text(developer.deep()) : png_text(developer.plain());
}

/// Develops pictures as develop_whole() does, but `band` rows at a time.
Result<std::string> develop_bands(std::span<const std::string> pngs, const Tone& tone, int depth, int band) {
  std::vector<PngRows> pictures;
  for (const std::string& png : pngs) {
    Result<PngRows> rows = PngRows::open(png);
    if (!rows) return rows.errors();
    if (!pictures.empty() && (rows->width() != pictures[0].width() || rows->height() != pictures[0].height()))
      return Error{"", kSizesDiffer};
    pictures.push_back(std::move(*rows));
  }
  Developer developer(tone);
  std::optional<PngWriter> writer;
  for (int height = pictures[0].height(); pictures[0].done() < height; developer.begin_anew()) {
    int rows = std::min(band, height - pictures[0].done());
    for (PngRows& picture : pictures) {
      Result<LinearRaster> read = picture.next_linear(rows, true);
      if (!read) return read.errors();
      if (!developer.add(*read)) return Error{"", kSizesDiffer};
    }
    PngSamples made;
    if (depth == 16) {
      made = developer.deep();
    } else {
      Raster plain = developer.plain();
      made = {plain.width, plain.height, plain.channels, 8, 45455, std::move(plain.data)};
    }
    if (!writer) {
      PngSamples whole{made.width, height, made.channels, made.bits, made.gamma, {}};
      writer.emplace(whole);
    }
    writer->add(made);
  }
  return writer->finish();
}

}  // namespace

Result<std::string> develop(std::span<const std::string> pngs, const Tone& tone, int depth,
                            std::size_t held) {
  if (pngs.empty()) return Error{"", "there is no picture"};
  Result<std::array<int, 2>> size = png_size(pngs[0]);
  if (!size) return size.errors();
  auto [width, height] = *size;
  if (static_cast<std::size_t>(width) * static_cast<std::size_t>(height) <= held)
    return develop_whole(pngs, tone, depth);
  int band = static_cast<int>(std::max<std::size_t>(1, held / static_cast<std::size_t>(width)));
  return develop_bands(pngs, tone, depth, band);
}

}  // namespace frond
