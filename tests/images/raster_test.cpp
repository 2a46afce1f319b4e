#include "images/raster.h"

#include <gtest/gtest.h>

#include "images/png_rows.h"

namespace frond {
namespace {

TEST(Png, IsReadBackAsItWasWritten) {
  for (int channels : {1, 3, 4}) {
    Raster raster(13, 7, channels);
    for (std::size_t i = 0; i < raster.data.size(); ++i) raster.data[i] = static_cast<std::uint8_t>(i * 37);
    Result<std::string> text = png_text(raster);
    ASSERT_TRUE(text.ok());
    Result<Raster> back = read_png(*text);
    ASSERT_TRUE(back.ok());
    EXPECT_EQ(back->channels, channels);
    EXPECT_EQ(back->width, 13);
    EXPECT_EQ(back->data, raster.data);
    EXPECT_EQ(*png_text(raster), *text);
  }
}

TEST(Png, WhatIsNoneIsRefused) {
  EXPECT_FALSE(read_png("this is no picture").ok());
  EXPECT_FALSE(read_png("").ok());
  std::string cut = *png_text(Raster(64, 64, 3));
  EXPECT_FALSE(read_png(cut.substr(0, cut.size() / 2)).ok());
}

TEST(Bytes, AreHeldToTheirRange) {
  EXPECT_EQ(to_byte(-1), 0);
  EXPECT_EQ(to_byte(0.5), 128);
  EXPECT_EQ(to_byte(7), 255);
}

TEST(PngRows, AStillOfSixteenThousandPixelsASideIsReadAndWrittenInBands) {
  constexpr int kWide = 16384, kHigh = 16384, kBand = 512;
  PngSamples band{kWide, kBand, 1, 8, 45455, {}};
  band.data.assign(band.row() * kBand, 100);
  PngWriter writer({kWide, kHigh, 1, 8, 45455, {}});
  for (int y = 0; y < kHigh; y += kBand) {
    band.data[0] = static_cast<std::uint8_t>(y / kBand);
    writer.add(band);
  }
  Result<std::string> png = writer.finish();
  ASSERT_TRUE(png);
  EXPECT_EQ(*png_size(*png), (std::array{kWide, kHigh}));
  EXPECT_FALSE(read_png(*png)) << "268 million pixels are not held";
  Result<PngRows> rows = PngRows::open(*png);
  ASSERT_TRUE(rows);
  while (rows->done() < kHigh) {
    auto number = static_cast<std::uint8_t>(rows->done() / kBand);
    Result<PngSamples> read = rows->next(kBand);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->data[0], number);
    EXPECT_EQ(read->data.back(), 100);
  }
}

TEST(Raster, PlacesOfLargePicturesAreCountedBeyond31Bits) {
  Raster picture;
  picture.width = picture.height = 60'000, picture.channels = 3;
  EXPECT_EQ(picture.index(59'999, 59'999, 2), 10'799'999'999u);
  Grid grid;
  grid.width = grid.height = 60'000;
  EXPECT_EQ(grid.index(59'999, 59'999), 3'599'999'999u);
}

}  // namespace
}  // namespace frond
