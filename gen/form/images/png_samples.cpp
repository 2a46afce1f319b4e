#include "images/png_samples.h"

#include <zlib.h>

#include <algorithm>
#include <cmath>

#include "images/png_rows.h"

namespace frond {

void PngSamples::set16(std::size_t i, double share) {
  auto value = static_cast<unsigned>(std::lround(std::clamp(share, 0.0, 1.0) * 65535));
  data[2 * i] = static_cast<std::uint8_t>(value >> 8);
  data[2 * i + 1] = static_cast<std::uint8_t>(value & 0xff);
}

Result<PngSamples> read_samples(std::string_view png) {
  Result<PngRows> rows = PngRows::open(png);
  if (!rows) return rows.errors();
  return rows->next(rows->height());
}

Result<std::string> samples_text(const PngSamples& samples) {
  PngWriter writer(samples, Z_DEFAULT_COMPRESSION);
  writer.add(samples);
  return writer.finish();
}

PngSamples cut(const PngSamples& whole, int x, int y, int width, int height) {
  PngSamples part = whole;
  part.width = width, part.height = height;
  part.data.clear();
  for (int row = y; row < y + height; ++row) {
    auto from = whole.data.begin() + static_cast<std::ptrdiff_t>(whole.row() * static_cast<std::size_t>(row) +
                                                                 whole.pixel() * static_cast<std::size_t>(x));
    part.data.insert(part.data.end(), from, from + static_cast<std::ptrdiff_t>(part.row()));
  }
  return part;
}

std::string with_density(std::string_view png, double dpi) {
  constexpr std::size_t kHead = 8 + 25;  // signature and IHDR
  constexpr double kInch = 0.0254;       // metres
  auto number = [](std::uint32_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xff);
    return bytes;
  };
  std::string dots = number(static_cast<std::uint32_t>(std::lround(dpi / kInch)));
  std::string named = "pHYs" + dots + dots + '\1';  // a metre
  auto sum = crc32(0, reinterpret_cast<const Bytef*>(named.data()), static_cast<uInt>(named.size()));
  std::string chunk = number(9) + named + number(static_cast<std::uint32_t>(sum));
  return std::string(png.substr(0, kHead)) + chunk + std::string(png.substr(std::min(kHead, png.size())));
}

}  // namespace frond
