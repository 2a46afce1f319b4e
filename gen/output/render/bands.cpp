#include "render/bands.h"

#include <algorithm>
#include <string_view>

#include "images/png_samples.h"

namespace frond {

namespace {

constexpr int kBlock = 32;  // rows

/// Where the pixels of a PNG begin: the length of the first chunk of them.
std::size_t pixels_at(std::string_view png) {
  std::size_t name = png.find("IDAT");
  return name == png.npos || name < 4 ? png.size() : name - 4;
}

}  // namespace

BandRows band_rows(int bands, int band, int height) {
  int blocks = (height + kBlock - 1) / kBlock;
  return {(band - 1) * blocks / bands * kBlock, std::min(band * blocks / bands * kBlock, height)};
}

Result<std::string> join_bands(std::span<const std::string> pngs) {
  PngSamples whole;
  int band = 0;
  for (const std::string& png : pngs) {
    Result<PngSamples> read = read_samples(png);
    if (!read) return read.errors();
    if (++band == 1) whole = *read;
    if (read->width != whole.width || read->height != whole.height || read->pixel() != whole.pixel())
      return Error{"", "the bands differ in size or kind"};
    BandRows rows = band_rows(static_cast<int>(pngs.size()), band, whole.height);
    auto at = [&](int row) { return static_cast<std::ptrdiff_t>(whole.row()) * row; };
    std::copy(read->data.begin() + at(rows.top), read->data.begin() + at(rows.below),
              whole.data.begin() + at(rows.top));
  }
  Result<std::string> png = samples_text(whole);
  if (!png) return png;
  // What the renderer says of its picture, as of its colours, stays.
  return pngs[0].substr(0, pixels_at(pngs[0])) + png->substr(pixels_at(*png));
}

}  // namespace frond
