#include "images/bark_photo.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/linear.h"
#include "images/bark.h"

namespace frond {
namespace {

/// Bark with a shadow on one side, cut so that its edges do not meet.
Raster photograph() {
  BarkImage bark;
  Raster whole = bark_colors(bark, bark_maps(bark, 160, 240, Seed{1}), Seed{1});
  Raster piece(110, 150, 3);
  for (int y = 0; y < piece.height; ++y)
    for (int x = 0; x < piece.width; ++x)
      for (int c = 0; c < 3; ++c)
        piece.data[piece.index(x, y, c)] =
            static_cast<std::uint8_t>(whole.at(x + 7, y + 31, c) * (0.4 + 0.6 * x / piece.width));
  return piece;
}

double light_at(const Raster& picture, int x, int y, int c) { return linear(picture.at(x, y, c) / 255.0); }

/// How much neighbouring columns or rows differ, in the mean.
double step(const Raster& picture, bool columns, int from, int to) {
  double sum = 0;
  int count = columns ? picture.height : picture.width;
  for (int k = 0; k < count; ++k)
    sum += std::abs(columns ? picture.at(from, k, 1) - picture.at(to, k, 1)
                            : picture.at(k, from, 1) - picture.at(k, to, 1));
  return sum / count;
}

TEST(BarkPhoto, ItsEdgesMeet) {
  Raster picture = photograph(), tile = *read_bark_photo(*png_text(picture));
  ASSERT_EQ(tile.width, picture.width);
  for (bool columns : {true, false}) {
    int last = (columns ? tile.width : tile.height) - 1;
    double most = 0;
    for (int i = 0; i < last; ++i) most = std::max(most, step(tile, columns, i, i + 1));
    EXPECT_LE(step(tile, columns, last, 0), most) << columns;
    EXPECT_GT(step(picture, columns, last, 0), 1.5 * step(tile, columns, last, 0)) << columns;
  }
}

TEST(BarkPhoto, ItsColourStaysAndTheShadowGoes) {
  Raster picture = photograph(), tile = *read_bark_photo(*png_text(picture));
  for (int c = 0; c < 3; ++c) {
    double before = 0, after = 0, left = 0, right = 0;
    for (int y = 0; y < tile.height; ++y)
      for (int x = 0; x < tile.width; ++x) {
        before += light_at(picture, x, y, c), after += light_at(tile, x, y, c);
        (x < tile.width / 2 ? left : right) += light_at(tile, x, y, c);
      }
    double count = tile.width * tile.height;
    EXPECT_NEAR(255 * encoded(after / count), 255 * encoded(before / count), 2) << c;
    EXPECT_NEAR(left / right, 1, 0.2) << c;
  }
}

TEST(BarkPhoto, AnotherSizeTilesToo) {
  Raster tile = *read_bark_photo(*png_text(photograph()));
  for (int width : {40, 300}) {
    Raster other = resized_tile(tile, width, 2 * width);
    double most = 0;
    for (int i = 0; i + 1 < width; ++i) most = std::max(most, step(other, true, i, i + 1));
    EXPECT_LE(step(other, true, width - 1, 0), most) << width;
  }
  EXPECT_EQ(resized_tile(tile, tile.width, tile.height).data, tile.data);
}

TEST(BarkPhoto, FurrowsAreDark) {
  BarkImage bark;
  bark.photo = std::make_shared<const Raster>(*read_bark_photo(*png_text(photograph())));
  BarkMaps maps = bark_maps(bark, 64, 96, Seed{1});
  Raster colors = bark_colors(bark, maps, Seed{1});
  double dark = 0, bright = 0;
  int deep = 0, high = 0;
  for (int y = 0; y < colors.height; ++y)
    for (int x = 0; x < colors.width; ++x) {
      float h = maps.height.at(x, y);
      ASSERT_TRUE(h >= 0 && h <= 1);
      if (h < 0.3f) dark += colors.at(x, y, 1), ++deep;
      if (h > 0.7f) bright += colors.at(x, y, 1), ++high;
    }
  ASSERT_GT(std::min(deep, high), 0);
  EXPECT_LT(dark / deep + 20, bright / high);
}

}  // namespace
}  // namespace frond
