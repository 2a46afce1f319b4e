#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

#include "appearance/describe.h"
#include "core/files.h"
#include "images/leaf_photo.h"
#include "preset/reader.h"

namespace frond {
namespace {

class Photographs : public testing::Test {
 protected:
  void SetUp() override {
    top_ = std::filesystem::path(testing::TempDir()) / ("frond_photographs_" + std::to_string(getpid()));
    std::filesystem::create_directories(top_);
    put("leaf.png", leaf(90));
    put("red.png", leaf(160));
    put("bark.png", Raster(40, 60, 3));
    put("strip.png", Raster(400, 20, 3));
  }
  void TearDown() override { std::filesystem::remove_all(top_); }

  void put(const char* name, const Raster& picture) {
    ASSERT_TRUE(write_file(top_ / name, *png_text(picture)));
  }

  /// A disc that fills its picture.
  static Raster leaf(std::uint8_t red) {
    Raster picture(64, 64, 4);
    for (int y = 0; y < 64; ++y)
      for (int x = 0; x < 64; ++x) {
        std::uint8_t* pixel = &picture.data[picture.index(x, y)];
        pixel[0] = red, pixel[1] = 120, pixel[2] = 40;
        pixel[3] = std::hypot(x - 31.5, y - 31.5) < 32 ? 255 : 0;
      }
    return picture;
  }

  template <class T>
  Result<T> read(std::string_view text) const {
    Assets assets(top_ / "p.json");
    Result<Document> document = parse_json(text, (top_ / "p.json").string());
    return document ? read_preset<T>(*document, nullptr, &assets) : Result<T>(document.errors());
  }
  template <class T>
  std::string said(std::string_view text) const {
    Result<T> wrong = read<T>(text);
    return wrong ? "" : wrong.errors().front().text();
  }

  std::filesystem::path top_;
};

TEST_F(Photographs, ALeafHasItsOwnColoursUnlessThePresetGivesSome) {
  LeafLook own = *read<LeafLook>(R"({"photo": "leaf.png"})");
  ASSERT_EQ(own.colors.size(), 1u);
  EXPECT_NEAR(own.colors[0].red, 90 / 255.0, 0.01);
  LeafLook given = *read<LeafLook>(R"({"photo": "leaf.png", "colors": ["#ff8000", "#804000"]})");
  EXPECT_EQ(given.colors.size(), 2u);
  EXPECT_FALSE(read<LeafLook>("{}")->photographed);

  // A disc without a stalk, and turned to the colour that is given.
  LeafImage image = leaf_image(own, 0);
  EXPECT_NEAR(area(leaf_mesh(image, 60, 0, 0)), kPi / 4, 0.03);
  Raster picture = leaf_picture(leaf_image(given, 0), 64, Seed{0});
  EXPECT_NEAR(picture.at(picture.width / 2, 32, 0), 255, 4);
  EXPECT_NEAR(picture.at(picture.width / 2, 32, 1), 128, 4);
}

TEST_F(Photographs, WhatTheFileHoldsNamesThePicture) {
  auto picture = [&](const char* text) { return leaf_prototype(*read<LeafLook>(text)).parts[0].pictures[0]; };
  std::string one = picture(R"({"photo": "leaf.png", "colors": ["#ff8000"]})");
  EXPECT_NE(one, picture(R"({"photo": "red.png", "colors": ["#ff8000"]})"));
  put("red.png", leaf(90));
  EXPECT_EQ(one, picture(R"({"photo": "red.png", "colors": ["#ff8000"]})"));
}

TEST_F(Photographs, WidthAndStalkChangeAPhotographedLeafAsADrawnOne) {
  LeafLook look = *read<LeafLook>(R"({"photo": "leaf.png", "width": 0.5, "stalk": 0.5})");
  LeafImage image = leaf_image(look, 0);
  EXPECT_NEAR(area(leaf_mesh(image, 60, 0, 0)), kPi / 4 * 0.5 * 0.5 * 0.5 + 0.036 * 0.52, 0.02);
  for (Vec2 p : leaf_rim(image.outline, 30)) EXPECT_LE(p.x, 0.135);
}

TEST_F(Photographs, BarkIsAsTallAsIsSaid) {
  BarkCoat coat = *read<BarkCoat>(R"({"photo": "bark.png", "tall": 0.6, "wrap": 7})");
  EXPECT_NEAR(coat.wrap, 0.4, 1e-9);
  EXPECT_NEAR(coat.aspect, 1.5, 1e-9);
  ASSERT_TRUE(coat.image.photo);
  BarkCoat drawn = *read<BarkCoat>(R"({"wrap": 0.4, "aspect": 1.5})");
  EXPECT_NE(bark_color_name(coat), bark_color_name(drawn));
}

TEST_F(Photographs, AWrongOneIsSaidWithItsFile) {
  std::string file = (top_ / "p.json").string(), bark = (top_ / "bark.png").string(),
              strip = (top_ / "strip.png").string();
  EXPECT_EQ(said<LeafLook>(R"({"photo": "bark.png"})"),
            file + ":1:11: /photo: " + bark +
                ": has no transparency; expected a leaf that was cut out, with nothing but transparency "
                "around it, as a PNG or WebP");
  EXPECT_EQ(said<BarkCoat>(R"({"photo": "strip.png"})"),
            file + ":1:11: /photo: " + strip +
                ": is 400 x 20 pixels; expected a picture 0.25 to 16 times as tall as wide");
  EXPECT_NE(said<LeafLook>(R"({"photo": "p.png"})").find("/photo: there is no file \"p.png\""),
            std::string::npos);
}

}  // namespace
}  // namespace frond
