#include "images/tone.h"

#include <gtest/gtest.h>
#include <png.h>

#include <cmath>
#include <vector>

#include "core/linear.h"
#include "core/seed.h"
#include "images/png_samples.h"
#include "images/raster.h"

namespace frond {
namespace {

TEST(Tone, WithoutAnythingLightStaysAsItIs) {
  for (double light : {0.0, 0.01, 0.18, 0.7, 1.0}) EXPECT_NEAR(toned(light, {}), light, 1e-12);
}

TEST(Tone, BrightestIsWhiteAndMiddleGreyStays) {
  for (double stops : {0.5, 2.0, 4.0})
    for (double contrast : {1.0, 1.2, 1.5}) {
      Tone tone{stops, contrast};
      EXPECT_NEAR(toned(1, tone), 1, 1e-9);
      EXPECT_NEAR(toned(0.18 / std::exp2(stops), tone), 0.18, 1e-9);
    }
}

TEST(Tone, MoreLightIsNeverDarkerAndNothingJumps) {
  for (Tone tone : {Tone{2, 1}, Tone{3, 1.3}, Tone{0, 0.7}, Tone{0, 1.4}}) {
    double before = toned(0, tone);
    for (int i = 1; i <= 4000; ++i) {
      double now = toned(i / 4000.0, tone);
      EXPECT_GT(now, before);
      EXPECT_LT(now - before, 0.02);
      before = now;
    }
  }
}

TEST(Tone, ContrastTurnsAboutMiddleGrey) {
  Tone steep{0, 1.4};
  EXPECT_LT(toned(0.05, steep), 0.05);
  EXPECT_GT(toned(0.4, steep), 0.4);
}

/// Linear again, of what is seen in the middle of a picture.
std::array<double, 3> seen_light(const std::array<double, 3>& light, const Tone& tone) {
  std::array<double, 3> color = seen(light, tone, {50, 50}, {101, 101});
  for (double& channel : color) channel = linear(channel);
  return color;
}

double luminance_of(const std::array<double, 3>& light) {
  return 0.2126 * light[0] + 0.7152 * light[1] + 0.0722 * light[2];
}

TEST(Tone, SaturationAndWarmthKeepTheLuminance) {
  const std::array<double, 3> green{0.1, 0.3, 0.05}, grey{0.2, 0.2, 0.2};
  for (Tone tone : {Tone{.saturation = 0.5}, Tone{.saturation = 1.2}, Tone{.warmth = 0.2},
                    Tone{.highlights = 1, .saturation = 0.8, .warmth = -0.1}})
    for (const auto& light : {green, grey}) {
      double plain = luminance_of(seen_light(light, {tone.highlights, tone.contrast}));
      EXPECT_NEAR(luminance_of(seen_light(light, tone)), plain, 1e-9);
    }
  std::array<double, 3> without = seen_light(green, {.saturation = 0});
  EXPECT_NEAR(without[0], without[1], 1e-9);
  EXPECT_NEAR(without[2], without[1], 1e-9);
  std::array<double, 3> less = seen_light(green, {.saturation = 0.75});
  EXPECT_NEAR((less[1] - less[2]) / (green[1] - green[2]), 0.75, 1e-9);
}

TEST(Tone, WarmthIsOfLightAndNotOfShade) {
  Tone warm{.warmth = 0.2};
  std::array<double, 3> bright = seen_light({0.8, 0.8, 0.8}, warm),
                        dark = seen_light({0.02, 0.02, 0.02}, warm);
  EXPECT_GT(bright[0], 1.1 * bright[2]);
  EXPECT_GT(dark[2], 1.1 * dark[0]);
  double middle = linear(0.5);
  std::array<double, 3> between = seen_light({middle, middle, middle}, warm);
  EXPECT_NEAR(between[0], between[2], 1e-9);
}

TEST(Tone, CornersLoseTheirShareOfLightAndTheMiddleNone) {
  Tone tone{.vignette = 0.3};
  auto left = [&](int x, int y) { return linear(seen({0.5, 0.5, 0.5}, tone, {x, y}, {2001, 1001})[0]); };
  EXPECT_NEAR(left(1000, 500), 0.5, 1e-9);
  for (int x : {0, 2000})
    for (int y : {0, 1000}) EXPECT_NEAR(left(x, y), 0.35, 0.001);
  EXPECT_NEAR(left(0, 500), left(2000, 500), 1e-12);
  EXPECT_GT(left(0, 500), left(0, 0));
}

/// A row of pixels of 16 bits, as POV-Ray writes it: sRGB.
std::string fine_png(const std::vector<double>& lights) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(lights.size()), image.height = 1;
  image.format = PNG_FORMAT_LINEAR_RGB;
  std::vector<png_uint_16> data;
  for (double light : lights)
    data.insert(data.end(), 3, static_cast<png_uint_16>(std::lround(light * 65535)));
  png_alloc_size_t size = 1 << 16;
  std::string text(size, '\0');
  EXPECT_TRUE(png_image_write_to_memory(&image, text.data(), &size, 0, data.data(), 0, nullptr));
  text.resize(size);
  return text;
}

TEST(Tone, ADevelopedPictureHasEightBits) {
  Tone tone{2, 1.2};
  std::vector<double> lights{0, 0.01, 0.045, 0.2, 0.6, 1};
  Result<std::string> picture = develop(std::vector{fine_png(lights)}, tone);
  ASSERT_TRUE(picture);
  EXPECT_EQ((*picture)[24], 8);  // of the file's head, bits a channel
  Result<Raster> raster = read_png(*picture);
  ASSERT_TRUE(raster);
  for (int i = 0; i < static_cast<int>(lights.size()); ++i)
    EXPECT_NEAR(raster->at(i, 0, 1), 255 * encoded(toned(lights[static_cast<std::size_t>(i)], tone)), 1.5);
}

TEST(Tone, WhatIsNoPictureIsAnError) {
  EXPECT_FALSE(develop(std::vector<std::string>{"no picture"}, {}));
  EXPECT_FALSE(develop(std::vector{fine_png({0.5}), fine_png({0.5, 0.5})}, {})) << "they differ in size";
}

TEST(Tone, OfSeveralExposuresTheLightIsTheMean) {
  auto bytes = [](const std::vector<std::vector<double>>& exposures, const Tone& tone) {
    std::vector<std::string> pngs;
    for (const auto& lights : exposures) pngs.push_back(fine_png(lights));
    return read_png(*develop(pngs, tone))->data;
  };
  const std::vector<double> some{0, 0.001, 0.18, 0.5, 0.73, 1};
  for (Tone tone : {Tone{}, Tone{2, 1.2}}) {
    EXPECT_EQ(bytes({some, some, some}, tone), bytes({some}, tone)) << "of like ones it is any of them";
    EXPECT_EQ(bytes({some, {1, 1, 1, 1, 1, 1}}, tone), bytes({{1, 1, 1, 1, 1, 1}, some}, tone));
  }
  EXPECT_EQ(bytes({{0}, {1}}, {})[0], 188) << "half the light is sRGB 188";
  EXPECT_EQ(bytes({{0}, {0}, {0}, {1}}, {})[0], 137) << "a quarter";
}

/// A picture of many rows, with noise in all of it.
std::string noisy_png(int width, int height, int channels, std::uint64_t seed) {
  PngSamples samples{width, height, channels, 16, 45455, {}};
  samples.data.resize(samples.row() * static_cast<std::size_t>(height));
  for (std::size_t i = 0; i < samples.data.size(); ++i)
    samples.data[i] = static_cast<std::uint8_t>(Seed{seed}.child(i).bits());
  return *samples_text(samples);
}

TEST(Develop, PicturesThatAreTooLargeToBeHeldAreMadeInBandsAndTheSame) {
  constexpr int kWide = 37, kHigh = 53;
  for (int channels : {3, 4})
    for (int depth : {8, 16})
      for (std::size_t held : {std::size_t{1}, std::size_t{4 * kWide}, std::size_t{kWide * (kHigh - 1)}}) {
        std::vector<std::string> pngs{noisy_png(kWide, kHigh, channels, 1),
                                      noisy_png(kWide, kHigh, channels, 2)};
        for (Tone tone : {Tone{1.5, 1.1}, Tone{1.5, 1.1, 0.8, 0.1, 0.4}}) {
          Result<std::string> whole = develop(pngs, tone, depth), bands = develop(pngs, tone, depth, held);
          ASSERT_TRUE(whole && bands);
          PngSamples a = *read_samples(*whole), b = *read_samples(*bands);
          EXPECT_EQ(b.width, kWide);
          EXPECT_EQ(b.height, kHigh);
          EXPECT_EQ(b.bits, depth);
          EXPECT_EQ(a.channels, b.channels);
          EXPECT_TRUE(a.data == b.data) << channels << " channels of " << depth << " bits, held " << held;
        }
      }
}

TEST(Develop, WhatIsWrongWithALargePictureIsTold) {
  std::string png = noisy_png(20, 30, 3, 1), cut = png.substr(0, png.size() / 2);
  EXPECT_FALSE(develop(std::vector{cut}, {}, 8, 40)) << "it is cut short";
  EXPECT_FALSE(develop(std::vector{png, noisy_png(20, 29, 3, 1)}, {}, 8, 40)) << "they differ in size";
  EXPECT_FALSE(develop(std::vector{png, noisy_png(20, 30, 4, 1)}, {}, 8, 40)) << "one is transparent";
  EXPECT_FALSE(develop(std::vector{std::string("no picture")}, {}, 8, 1));
  EXPECT_FALSE(develop(std::vector<std::string>{}, {}));
}

TEST(Develop, KeepsOpacityAndTheColourOfWhatIsSeenThrough) {
  // One pixel, half transparent, of a grey; and the same, opaque, beside nothing at all.
  auto png = [](std::uint8_t grey, std::uint8_t opacity) {
    PngSamples one{1, 1, 4, 16, 45455, {grey, 0, grey, 0, grey, 0, opacity, 0}};
    return *samples_text(one);
  };
  std::string half = png(120, 128), full = png(120, 255), none = png(0, 0);
  Result<std::string> developed = develop(std::vector{half}, {});
  ASSERT_TRUE(developed);
  Raster picture = *read_png(*developed);
  ASSERT_EQ(picture.channels, 4);
  EXPECT_NEAR(picture.data[0], 120, 1);
  EXPECT_NEAR(picture.data[3], 128, 1);
  picture = *read_png(*develop(std::vector{full, none}, {}));
  EXPECT_NEAR(picture.data[0], 120, 1) << "not darkened by what is not there";
  EXPECT_NEAR(picture.data[3], 127, 1);
  PngSamples deep = *read_samples(*develop(std::vector{half}, {}, 16));
  EXPECT_EQ(deep.bits, 16);
  EXPECT_NEAR(deep.data[0], 120, 1);
}

}  // namespace
}  // namespace frond
