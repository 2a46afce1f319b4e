#include "images/whole.h"

#include <gtest/gtest.h>

#include "images/raster.h"

namespace frond {
namespace {

std::string picture() {
  Raster raster(40, 30, 3);
  for (std::size_t i = 0; i < raster.data.size(); ++i)
    raster.data[i] = static_cast<std::uint8_t>(i * i % 251);
  return *png_text(raster);
}

TEST(WholePng, ToldByItsSize) { EXPECT_EQ(whole_png(picture()), (std::array<int, 2>{40, 30})); }

TEST(WholePng, CutOffAnywhereIsNoneThatCounts) {
  std::string whole = picture();
  for (std::size_t length = 0; length < whole.size(); ++length)
    EXPECT_FALSE(whole_png(std::string_view(whole).substr(0, length))) << length;
  EXPECT_FALSE(whole_png(whole + "x"));
}

TEST(WholePng, OneWrongByteAnywhereIsFound) {
  std::string whole = picture();
  for (std::size_t at = 0; at < whole.size(); ++at) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
    EXPECT_FALSE(whole_png(damaged)) << at;
  }
}

}  // namespace
}  // namespace frond
