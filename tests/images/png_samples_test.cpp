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

/// A file whose head says another size.
std::string resized(std::string png, std::uint32_t width, std::uint32_t height) {
  constexpr std::size_t kType = 12, kLength = 17;  // of what the sum of IHDR is of
  auto put = [&png](std::size_t at, std::uint32_t value) {
    for (std::size_t i = 0; i < 4; ++i) png[at + i] = static_cast<char>(value >> (24 - 8 * i) & 0xff);
  };
  put(16, width), put(20, height);
  std::uint32_t sum = ~0u;
  for (std::size_t i = kType; i < kType + kLength; ++i) {
    sum ^= static_cast<unsigned char>(png[i]);
    for (int bit = 0; bit < 8; ++bit) sum = sum >> 1 ^ (sum & 1 ? 0xedb88320u : 0);
  }
  put(kType + kLength, ~sum);
  return png;
}

TEST(PngSamples, AFileThatPromisesMoreThanItCanHoldIsRefusedBeforeThereIsRoomForIt) {
  std::string png = *samples_text(some(4, 16));
  EXPECT_TRUE(read_samples(resized(png, 13, 7)).ok());
  for (auto [width, height] :
       {std::pair(60'000u, 60'000u), std::pair(65'537u, 1u), std::pair(2'000'000'000u, 7u)}) {
    Result<PngSamples> read = read_samples(resized(png, width, height));
    ASSERT_FALSE(read.ok()) << width;
    EXPECT_TRUE(read.errors()[0].what.starts_with("no PNG: ")) << read.errors()[0].what;
    EXPECT_GT(read.errors()[0].what.size(), 12u);
  }
  EXPECT_FALSE(read_samples(resized(png, 13, 70)).ok()) << "cut short";
}

}  // namespace
}  // namespace frond
