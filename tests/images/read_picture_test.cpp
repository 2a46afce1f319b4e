#include "images/read_picture.h"

#include <gtest/gtest.h>
#include <turbojpeg.h>
#include <webp/encode.h>

#include "images/photo.h"
#include "images/picture_turn.h"

namespace frond {
namespace {

/// 32 x 16 pixels: red at the left, blue at the right.
Raster flag(int channels = 3) {
  Raster raster(32, 16, channels);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 32; ++x) {
      raster.data[raster.index(x, y, x < 16 ? 0 : 2)] = 255;
      if (channels == 4) raster.data[raster.index(x, y, 3)] = y < 8 ? 255 : 0;
    }
  return raster;
}

std::string jpeg_of(const Raster& raster) {
  tjhandle writer = tjInitCompress();
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  tjCompress2(writer, raster.data.data(), raster.width, 0, raster.height, TJPF_RGB, &bytes, &size, TJSAMP_444,
              95, 0);
  std::string text(reinterpret_cast<char*>(bytes), size);
  tjFree(bytes);
  tjDestroy(writer);
  return text;
}

const std::string kExif("Exif\0\0", 6);

/// The data of an EXIF that says how the camera was held.
std::string tiff_of(char turn) {
  std::string tiff("MM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0", 19);
  return tiff + turn + std::string("\0\0\0\0\0\0", 6);
}

/// The same with an EXIF.
std::string held(std::string jpeg, char turn) {
  std::string data = kExif + tiff_of(turn);
  std::string segment("\xff\xe1\0", 3);
  segment += static_cast<char>(data.size() + 2);
  return jpeg.insert(2, segment + data);
}

std::string webp_of(const Raster& raster) {
  std::uint8_t* bytes = nullptr;
  std::size_t size =
      raster.channels == 4
          ? WebPEncodeLosslessRGBA(raster.data.data(), raster.width, raster.height, raster.width * 4, &bytes)
          : WebPEncodeLosslessRGB(raster.data.data(), raster.width, raster.height, raster.width * 3, &bytes);
  std::string text(reinterpret_cast<char*>(bytes), size);
  WebPFree(bytes);
  return text;
}

/// A chunk of a WebP.
std::string chunk(const char* name, const std::string& data) {
  std::string text = name;
  for (int i = 0; i < 4; ++i) text += static_cast<char>(data.size() >> 8 * i & 255);
  return text + data + std::string(data.size() % 2, '\0');
}

/// A flag as WebP with an EXIF.
std::string held_webp(const std::string& exif, int channels = 3) {
  std::string pixels = webp_of(flag(channels)).substr(12);
  if (pixels.starts_with("VP8X")) pixels.erase(0, 18);
  std::string extended("\x08\0\0\0\x1f\0\0\x0f\0\0", 10);  // 32 x 16, with EXIF
  if (channels == 4) extended[0] |= 0x10;
  std::string whole = "WEBP" + chunk("VP8X", extended) + pixels + chunk("EXIF", exif);
  return chunk("RIFF", whole);
}

bool red(const Raster& p, int x, int y) { return p.at(x, y, 0) > 200 && p.at(x, y, 2) < 50; }
bool blue(const Raster& p, int x, int y) { return p.at(x, y, 2) > 200 && p.at(x, y, 0) < 50; }

TEST(ReadPicture, PhotographsMayBeJpegAndWebp) {
  for (const std::string& bytes : {jpeg_of(flag()), webp_of(flag()), *png_text(flag())}) {
    Result<Raster> read = read_photo(bytes);
    ASSERT_TRUE(read) << read.errors()[0].text();
    EXPECT_EQ(read->channels, 3);
    EXPECT_EQ(read->width, 32);
    EXPECT_TRUE(red(*read, 3, 8));
    EXPECT_TRUE(blue(*read, 28, 8));
  }
}

TEST(ReadPicture, WebpKeepsItsOpacity) {
  Result<Raster> read = read_picture(webp_of(flag(4)));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->channels, 4);
  EXPECT_EQ(read->at(3, 3, 3), 255);
  EXPECT_EQ(read->at(3, 12, 3), 0);
}

TEST(ReadPicture, AJpegStandsAsTheCameraWasHeld) {
  Result<Raster> upright = read_picture(held(jpeg_of(flag()), 6));  // turned by a quarter, clockwise
  ASSERT_TRUE(upright);
  EXPECT_EQ(upright->width, 16);
  EXPECT_EQ(upright->height, 32);
  EXPECT_TRUE(red(*upright, 8, 3)) << "what was left is above";
  EXPECT_TRUE(blue(*upright, 8, 28));
  Result<Raster> other = read_picture(held(jpeg_of(flag()), 8));
  ASSERT_TRUE(other);
  EXPECT_TRUE(blue(*other, 8, 3));
  Result<Raster> half = read_picture(held(jpeg_of(flag()), 3));
  ASSERT_TRUE(half);
  EXPECT_TRUE(blue(*half, 3, 8));
  EXPECT_EQ(jpeg_turn(held(jpeg_of(flag()), 9)), 1) << "no such way to hold one";
}

TEST(ReadPicture, AWebpStandsAsTheCameraWasHeld) {
  for (const std::string& before : {std::string(), kExif}) {
    Result<Raster> upright = read_picture(held_webp(before + tiff_of(6)));
    ASSERT_TRUE(upright) << upright.errors()[0].text();
    EXPECT_EQ(upright->width, 16);
    EXPECT_EQ(upright->height, 32);
    EXPECT_TRUE(red(*upright, 8, 3)) << "what was left is above";
    EXPECT_TRUE(blue(*upright, 8, 28));
  }
  Result<Raster> clear = read_picture(held_webp(tiff_of(6), 4));
  ASSERT_TRUE(clear);
  EXPECT_EQ(clear->at(3, 8, 3), 0) << "what was below is left";
  EXPECT_EQ(clear->at(12, 8, 3), 255);
  EXPECT_EQ(webp_turn(webp_of(flag())), 1);
  EXPECT_EQ(webp_turn(held_webp(tiff_of(9))), 1) << "no such way to hold one";
  std::string whole = held_webp(tiff_of(6));
  for (std::size_t end = 0; end < whole.size(); ++end) EXPECT_LE(webp_turn(whole.substr(0, end)), 8);
}

TEST(ReadPicture, EveryTurnAndBackIsThePictureItself) {
  Raster picture = flag();
  picture.data[picture.index(5, 2, 1)] = 77;
  constexpr int kBack[] = {0, 1, 2, 3, 4, 5, 8, 7, 6};
  for (int turn = 1; turn <= 8; ++turn)
    EXPECT_EQ(turned(turned(picture, turn), kBack[turn]).data, picture.data) << turn;
}

TEST(ReadPicture, WhatCannotBeReadIsNamed) {
  auto said = [](std::string bytes) {
    Result<Raster> read = read_picture(bytes);
    return read ? std::string("read") : read.errors()[0].what;
  };
  EXPECT_EQ(said("GIF89a"), "is a GIF picture; expected a PNG, JPEG or WebP file");
  EXPECT_EQ(said(std::string("\0\0\0\x18"
                             "ftypheic\0\0\0\0",
                             16)),
            "is a HEIC picture; expected a PNG, JPEG or WebP file");
  EXPECT_EQ(said("hello"), "is no picture that Frond reads; expected a PNG, JPEG or WebP file");
  EXPECT_EQ(said(""), "is no picture that Frond reads; expected a PNG, JPEG or WebP file");
  std::string whole = jpeg_of(flag());
  EXPECT_TRUE(said(whole.substr(0, whole.size() / 2)).starts_with("is a damaged JPEG"));
  EXPECT_TRUE(said(whole.substr(0, 12)).starts_with("is a damaged JPEG"));
  EXPECT_TRUE(said(webp_of(flag()).substr(0, 40)).starts_with("is a damaged WebP"));
}

}  // namespace
}  // namespace frond
