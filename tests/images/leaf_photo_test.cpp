#include "images/leaf_photo.h"

#include <gtest/gtest.h>

#include <cmath>

namespace frond {
namespace {

LeafPhoto photo_of(const Raster& picture) {
  Result<LeafPhoto> photo = read_leaf_photo(*png_text(picture));
  EXPECT_TRUE(photo) << photo.errors().front().what;
  return photo ? *photo : LeafPhoto{};
}

/// An ellipse with a stalk, 100 x 160 pixels on 40, in the middle of a larger picture, of a colour that
/// brightens to the tip.
Raster ellipse() {
  Raster picture(160, 240, 4);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      double right = (x + 0.5 - 80) / 50, down = (y + 0.5 - 100) / 80;
      bool stalk = std::abs(x + 0.5 - 80) < 3 && y >= 178 && y < 220;
      std::uint8_t* pixel = &picture.data[picture.index(x, y)];
      pixel[0] = 90, pixel[1] = static_cast<std::uint8_t>(240 - y), pixel[2] = 30;
      pixel[3] = right * right + down * down < 1 || stalk ? 255 : 0;
    }
  return picture;
}

TEST(LeafPhoto, TheOutlineIsThatOfTheOpacity) {
  LeafPhoto photo = photo_of(ellipse());
  EXPECT_NEAR(photo.outline.stalk, 0.2, 0.02);
  EXPECT_NEAR(photo.length, 200, 2);
  for (Vec2 p : leaf_rim(photo.outline, 60)) {
    if (p.y < photo.outline.stalk + 0.02) continue;
    double right = p.x / 0.25, up = (p.y - 0.6) / 0.4;
    EXPECT_NEAR(std::hypot(right, up), 1, 0.03) << p.x << " " << p.y;
  }
}

TEST(LeafPhoto, ADrawnLeafThatIsReadAgainIsAsLarge) {
  for (std::string_view name : leaf_names()) {
    LeafImage leaf;
    leaf.outline = leaf_outline(name);
    LeafImage again;
    again.outline = photo_of(leaf_picture(leaf, 160, Seed{1})).outline;
    EXPECT_NEAR(area(leaf_mesh(again, 48, 0, 0)) / area(leaf_mesh(leaf, 48, 0, 0)), 1, 0.03) << name;
    EXPECT_NEAR(again.outline.stalk, leaf.outline.stalk, 0.05) << name;
  }
}

TEST(LeafPhoto, ThePictureShowsThePhotograph) {
  Raster picture = ellipse();
  auto photo = std::make_shared<const LeafPhoto>(photo_of(picture));
  LeafImage leaf;
  leaf.photo = photo;
  leaf.outline = photo->outline;
  leaf.color = photo->mean;
  Raster shown = leaf_picture(leaf, 200, Seed{1});
  PictureFrame frame = picture_frame(leaf);
  for (int y = 2; y < 198; ++y)
    for (int x = 0; x < shown.width; ++x) {
      // What is beyond the rim has its colour.
      double up = frame.high - (y + 0.5) / 200 * (frame.high - frame.low);
      EXPECT_NEAR(shown.at(x, y, 0), 90, 2) << x << " " << y;
      if (shown.at(x, y, 3) < 255) continue;
      EXPECT_NEAR(shown.at(x, y, 1), 240 - (220 - 200 * up), 3) << x << " " << y;
    }
  // Half as large it is the same, and another colour turns all of it.
  Raster small = leaf_picture(leaf, 50, Seed{1});
  EXPECT_NEAR(small.at(small.width / 2, 25, 1), shown.at(shown.width / 2, 100, 1), 5);
  leaf.color = {photo->mean.green, photo->mean.green, photo->mean.blue};
  EXPECT_GT(leaf_picture(leaf, 50, Seed{1}).at(small.width / 2, 25, 0), 110);
}

TEST(LeafPhoto, ALargerPictureDoesNotFlickerWithItsDots) {
  Raster picture = ellipse();
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) picture.data[picture.index(x, y, 1)] = (x + y) % 2 ? 255 : 0;
  auto photo = std::make_shared<const LeafPhoto>(photo_of(picture));
  LeafImage leaf;
  leaf.photo = photo, leaf.outline = photo->outline, leaf.color = photo->mean;
  Raster small = leaf_picture(leaf, 50, Seed{1});
  for (int y = 10; y < 35; ++y) EXPECT_NEAR(small.at(small.width / 2, y, 1), 188, 6) << y;  // half the light
}

TEST(LeafPhoto, WhatIsNoLeafIsRefused) {
  auto said = [](const Raster& picture) {
    Result<LeafPhoto> photo = read_leaf_photo(*png_text(picture));
    return photo ? std::string() : photo.errors().front().what;
  };
  EXPECT_NE(said(Raster(40, 40, 3)).find("has no transparency"), std::string::npos);
  EXPECT_NE(said(Raster(40, 40, 4)).find("has no leaf in the middle"), std::string::npos);
  EXPECT_EQ(said(Raster(15, 40, 4)), "is a picture of 15 x 40 pixels; expected 16 to 4096 pixels a side");
  EXPECT_EQ(said(Raster(16, 4097, 1)), "is a picture of 16 x 4097 pixels; expected 16 to 4096 pixels a side");
  EXPECT_FALSE(read_leaf_photo("no picture"));
}

}  // namespace
}  // namespace frond
