#include "images/png_samples.h"

#include <gtest/gtest.h>

#include "images/raster.h"
#include "images/whole.h"

namespace frond {
namespace {

PngSamples some(int channels, int bits) {
  PngSamples samples{13, 7, channels, bits, 45455, {}};
  samples.data.resize(samples.row() * 7);
  for (std::size_t i = 0; i < samples.data.size(); ++i)
    samples.data[i] = static_cast<std::uint8_t>(i * 37 % 251);
  return samples;
}

TEST(PngSamples, AreReadAsTheyWereWritten) {
  for (int channels = 1; channels <= 4; ++channels)
    for (int bits : {8, 16}) {
      PngSamples samples = some(channels, bits);
      std::string png = *samples_text(samples);
      EXPECT_EQ(whole_png(png), (std::array{13, 7}));
      Result<PngSamples> read = read_samples(png);
      ASSERT_TRUE(read);
      EXPECT_EQ(read->data, samples.data);
      EXPECT_EQ(read->bits, bits);
      EXPECT_EQ(read->channels, channels);
      EXPECT_EQ(read->gamma, 45455);
    }
}

TEST(PngSamples, AreCut) {
  PngSamples whole = some(4, 16), part = cut(whole, 3, 2, 5, 4);
  ASSERT_EQ(part.data.size(), 5u * 4 * 8);
  for (std::size_t y = 0; y < 4; ++y)
    for (std::size_t i = 0; i < 40; ++i)
      EXPECT_EQ(part.data[y * 40 + i], whole.data[(y + 2) * whole.row() + 24 + i]);
}

TEST(PngSamples, WhatIsNoneIsAnError) {
  std::string png = *samples_text(some(3, 8));
  EXPECT_FALSE(read_samples(""));
  EXPECT_FALSE(read_samples("no PNG"));
  EXPECT_FALSE(read_samples(png.substr(0, png.size() / 2)));
}

TEST(PngSamples, SayHowManyAnInchThereAre) {
  std::string png = *samples_text(some(3, 8)), dense = with_density(png, 300);
  EXPECT_TRUE(whole_png(dense));
  std::size_t at = dense.find("pHYs");
  ASSERT_NE(at, dense.npos);
  EXPECT_EQ(dense.substr(at + 4, 4), std::string("\x00\x00\x2e\x23", 4));  // 11811 a metre
  EXPECT_EQ(read_samples(dense)->data, read_samples(png)->data);
}

}  // namespace
}  // namespace frond
