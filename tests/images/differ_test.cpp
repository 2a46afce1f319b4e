#include "images/differ.h"

#include <gtest/gtest.h>
#include <png.h>

#include <cmath>

#include "core/linear.h"

namespace frond {
namespace {

/// A picture of one colour.
SeenPicture even(float value, int width = 8, int height = 6) {
  return {width, height, std::vector<float>(static_cast<std::size_t>(3 * width * height), value)};
}

SeenPicture rising(float offset) {
  SeenPicture picture = even(0);
  for (std::size_t i = 0; i < picture.values.size(); ++i) picture.values[i] = static_cast<float>(i) + offset;
  return picture;
}

TEST(Differ, OfEqualPicturesIsNothing) {
  Differ differ;
  for (int frame = 0; frame < 3; ++frame) {
    Difference difference = differ.add(rising(0), rising(0));
    EXPECT_EQ(difference.error, 0);
    EXPECT_EQ(difference.maximum, 0);
    EXPECT_EQ(difference.share, 0);
  }
  EXPECT_EQ(differ.frames(), 3);
  EXPECT_EQ(differ.differing(), 0);
  EXPECT_EQ(differ.worst(), 0);
  EXPECT_EQ(differ.total().error, 0);
  EXPECT_EQ(differ.flicker(), 0);
}

TEST(Differ, AConstantOffsetIsThatErrorAndDoesNotFlicker) {
  for (float offset : {5.0f, 0.1f, -20.0f}) {
    Differ differ;
    for (float frame = 0; frame < 7; ++frame) differ.add(rising(frame + offset), rising(frame));
    EXPECT_NEAR(differ.total().error, std::abs(offset), 1e-5);
    EXPECT_NEAR(differ.total().maximum, std::abs(offset), 2e-5);
    EXPECT_EQ(differ.total().share, std::abs(offset) > 8 ? 1 : 0);
    EXPECT_NEAR(differ.flicker(), 0, 1e-5);
    EXPECT_EQ(differ.differing(), 7);
  }
}

TEST(Differ, AnAlternatingOffsetFlickersByIt) {
  Differ differ;
  for (int frame = 0; frame < 300; ++frame) differ.add(even(100), even(frame % 2 ? 104.0f : 96.0f));
  EXPECT_NEAR(differ.flicker(), 4, 1e-4);
  EXPECT_NEAR(differ.total().error, 4, 1e-9);
  Differ about;  // the same about an offset that stays
  for (int frame = 0; frame < 300; ++frame) about.add(even(100), even(frame % 2 ? 124.0f : 116.0f));
  EXPECT_NEAR(about.flicker(), 4, 1e-4);
  EXPECT_NEAR(about.total().error, std::sqrt(400 + 16), 1e-6);
}

TEST(Differ, CountsPixelsThatAreFarOffOnceWhateverTheirChannels) {
  SeenPicture a = even(100), b = a;
  b.values[0] += 9;
  b.values[1] -= 200;
  b.values[3] += 8;  // not more than 8
  Differ differ;
  Difference difference = differ.add(a, b);
  EXPECT_DOUBLE_EQ(difference.share, 1.0 / 48);
  EXPECT_EQ(difference.maximum, 200);
  EXPECT_DOUBLE_EQ(difference.error, std::sqrt((81.0 + 40000 + 64) / 144));
}

TEST(Differ, TellsWhichFrameDiffersMost) {
  Differ differ;
  for (float offset : {0.0f, 3.0f, 7.0f, 0.0f, 7.0f}) differ.add(even(50), even(50 + offset));
  EXPECT_EQ(differ.worst(), 3);
  EXPECT_EQ(differ.worst_error(), 7);
  EXPECT_EQ(differ.differing(), 3);
  EXPECT_DOUBLE_EQ(differ.total().error, std::sqrt((9.0 + 49 + 49) / 5));
}

TEST(SeenPicture, IsReadFromEightBitsOfAnyKind) {
  Raster grey(2, 1, 1), color(2, 1, 3), clear(2, 1, 4);
  grey.data = {10, 200};
  color.data = {10, 10, 10, 200, 200, 200};
  clear.data = {10, 10, 10, 255, 200, 200, 200, 255};
  for (const Raster& raster : {grey, color, clear}) {
    Result<SeenPicture> picture = read_seen_png(*png_text(raster));
    ASSERT_TRUE(picture);
    EXPECT_EQ(picture->width, 2);
    EXPECT_EQ(picture->height, 1);
    EXPECT_EQ(picture->values, (std::vector<float>{10, 10, 10, 200, 200, 200}));
  }
  clear.data[7] = 0;
  EXPECT_EQ(seen(clear).values[3], 0) << "what is not there is black";
}

TEST(SeenPicture, HasFractionsWhereItIsOfSixteenBits) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = 2, image.height = 1;
  image.format = PNG_FORMAT_LINEAR_RGB;
  const png_uint_16 data[] = {0, 0, 0, 14100, 14100, 14100};
  png_alloc_size_t size = 4096;
  std::string text(size, '\0');
  ASSERT_TRUE(png_image_write_to_memory(&image, text.data(), &size, 0, data, 0, nullptr));
  text.resize(size);
  Result<SeenPicture> picture = read_seen_png(text);
  ASSERT_TRUE(picture);
  EXPECT_EQ(picture->values[0], 0);
  EXPECT_NEAR(picture->values[3], 255 * encoded(14100 / 65535.0), 0.01);
}

TEST(SeenPicture, IsNoneWhereTheFileIsNone) {
  EXPECT_FALSE(read_seen_png("this is no picture, and longer than a head"));
  EXPECT_FALSE(read_seen_png(""));
}

}  // namespace
}  // namespace frond
