#include "render/bands.h"

#include <algorithm>
#include <string_view>

#include "images/raster.h"

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
  Raster whole;
  int band = 0;
  for (const std::string& png : pngs) {
    Result<Raster> read = read_png(png);
    if (!read) return read.errors();
    ++band;
    if (band == 1) whole = Raster(read->width, read->height, read->channels);
    if (read->width != whole.width || read->height != whole.height || read->channels != whole.channels)
      return Error{"", "the bands differ in size or kind"};
    BandRows rows = band_rows(static_cast<int>(pngs.size()), band, whole.height);
    auto from = static_cast<std::ptrdiff_t>(whole.index(0, rows.top)),
         to = static_cast<std::ptrdiff_t>(whole.index(0, rows.below));
    std::copy(read->data.begin() + from, read->data.begin() + to, whole.data.begin() + from);
  }
  Result<std::string> png = png_text(whole);
  if (!png) return png;
  return pngs[0].substr(0, pixels_at(pngs[0])) + png->substr(pixels_at(*png));
}

}  // namespace frond
