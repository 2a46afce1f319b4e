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

double luminance(const std::array<double, 3>& light) {  // Rec. 709
  return 0.2126 * light[0] + 0.7152 * light[1] + 0.0722 * light[2];
}

}  // namespace

double toned(double light, const Tone& tone) {
  double brightest = contrasted(std::exp2(tone.highlights), tone.contrast),
         at = contrasted(std::exp2(tone.highlights) * light, tone.contrast);
  if (at <= kKnee || brightest <= 1) return at;
  double bend = 1 / (1 - kKnee) - 1 / (brightest - kKnee);
  return kKnee + (at - kKnee) / (1 + bend * (at - kKnee));
}

std::array<double, 3> seen(const std::array<double, 3>& light, const Tone& tone, std::array<int, 2> pixel,
                           std::array<int, 2> size) {
  auto from_middle = [&](std::size_t axis) { return 2.0 * pixel[axis] + 1 - size[axis]; };
  double away = std::hypot(from_middle(0), from_middle(1)) / std::hypot(size[0], size[1]);  // 1: a corner
  double left = 1 - tone.vignette * away * away;
  std::array<double, 3> out{};
  for (std::size_t c = 0; c < 3; ++c) out[c] = toned(left * light[c], tone);
  if (tone.saturation != 1 || tone.warmth != 0) {
    double grey = luminance(out), bright = 2 * encoded(std::min(grey, 1.0)) - 1;  // -1 black, 1 white
    for (double& channel : out) channel = std::max(0.0, grey + tone.saturation * (channel - grey));
    out[0] *= 1 + tone.warmth * bright, out[2] *= 1 - tone.warmth * bright;
    double changed = luminance(out), factor = changed > 0 ? grey / changed : 1;
    for (double& channel : out) channel = std::min(1.0, factor * channel);
  }
  for (double& channel : out) channel = encoded(channel);
  return out;
}

namespace {

/// Brings the light of pictures, summed up, to a tone.
class Developer {
 public:
  Developer(const Tone& tone, std::array<int, 2> size) : tone_(tone), size_(size), curve_(1 << 16) {
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
    each_sample([&](std::size_t i, double value) { samples.set16(i, value); });
    return samples;
  }
  Raster plain() const {
    Raster picture(width_, height_, channels_);
    each_sample([&](std::size_t i, double value) { picture.data[i] = to_byte(value); });
    return picture;
  }

  /// Goes on with the rows below.
  void begin_anew() { first_ += height_, sum_.clear(), count_ = 0; }

 private:
  /// The mean light of a colour, in 1 / 65535; colours were multiplied by their opacity.
  std::size_t light(std::size_t i) const {
    if (channels_ == 3) return (sum_[i] + count_ / 2) / count_;
    std::uint32_t opacity = sum_[i | 3];
    if (opacity == 0) return 0;
    return std::min<std::uint64_t>((std::uint64_t{sum_[i]} * 65535 + opacity / 2) / opacity, 65535);
  }

  /// Hands each sample of the rows on: its number and its value, 0 to 1.
  template <class Use>
  void each_sample(const Use& use) const {
    auto step = static_cast<std::size_t>(channels_), row = static_cast<std::size_t>(width_);
    for (std::size_t p = 0; p < sum_.size() / step; ++p) {
      std::size_t at = p * step;
      std::array<double, 3> colors{};
      if (channels_ == 3 || sum_[at + 3] > 0) {
        for (std::size_t c = 0; c < 3; ++c)
          colors[c] = tone_.is_curve() ? curve_[light(at + c)] : static_cast<double>(light(at + c)) / 65535;
        if (!tone_.is_curve())
          colors =
              seen(colors, tone_, {static_cast<int>(p % row), first_ + static_cast<int>(p / row)}, size_);
      }
      for (std::size_t c = 0; c < 3; ++c) use(at + c, colors[c]);
      if (channels_ == 4) use(at + 3, static_cast<double>(sum_[at + 3]) / (65535.0 * count_));
    }
  }

  Tone tone_;
  std::array<int, 2> size_;  // of the whole picture
  std::vector<double> curve_;
  int first_ = 0;  // row, of those that are added
  int width_ = 0, height_ = 0, channels_ = 3;
  std::uint32_t count_ = 0;
  std::vector<std::uint32_t> sum_;
};

const char* const kSizesDiffer = "the pictures differ in size";

Result<std::string> develop_whole(std::span<const std::string> pngs, const Tone& tone, int depth,
                                  std::array<int, 2> size) {
  Developer developer(tone, size);
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
  Developer developer(tone, {pictures[0].width(), pictures[0].height()});
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
    return develop_whole(pngs, tone, depth, *size);
  int band = static_cast<int>(std::max<std::size_t>(1, held / static_cast<std::size_t>(width)));
  return develop_bands(pngs, tone, depth, band);
}

}  // namespace frond
