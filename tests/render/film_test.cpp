#include "render/film.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "core/files.h"
#include "core/work_folder.h"
#include "images/raster.h"
#include "render/animated_webp.h"

namespace frond {

TEST(Gif, CommentStandsBehindTheTableOfColours) {
  std::string head = "GIF89a", screen("\4\0\4\0", 4), flags("\x91\0\0", 3);  // a table of 4 colours
  std::string table(12, 'c'), rest = "the pictures";
  std::string gif = head + screen + flags + table + rest;
  EXPECT_EQ(gif_with_comment(gif, "reef"),
            head + screen + flags + table + std::string("\x21\xfe\4reef\0", 8) + rest);
}

TEST(Gif, LongCommentsAreCutIntoBlocks) {
  std::string gif = std::string("GIF89a\4\0\4\0\0\0\0", 13) + "rest";  // without a table
  std::string made = gif_with_comment(gif, std::string(300, 'x'));
  EXPECT_EQ(made.size(), gif.size() + 2 + 1 + 255 + 1 + 45 + 1);
  EXPECT_EQ(static_cast<unsigned char>(made[15]), 255);
  EXPECT_EQ(made[15 + 256], 45);
  EXPECT_TRUE(made.ends_with(std::string("\0rest", 5)));
}

TEST(Gif, WhatIsNoneIsLeftAlone) { EXPECT_EQ(gif_with_comment("GIF", "reef"), "GIF"); }

/// Pictures of 32x16 that are of one colour each, and may let through.
std::vector<std::filesystem::path> pictures_of(const WorkFolder& work, const std::vector<int>& reds,
                                               int channels) {
  std::vector<std::filesystem::path> files;
  for (int red : reds) {
    Raster picture(32, 16, channels);
    for (std::size_t i = 0; i < picture.data.size(); i += static_cast<std::size_t>(channels))
      picture.data[i] = static_cast<std::uint8_t>(red);
    files.push_back(work.path() / ("f" + std::to_string(files.size()) + ".png"));
    EXPECT_TRUE(write_file(files.back(), *png_text(picture)));
  }
  return files;
}

TEST(AnimatedWebp, HoldsPicturesThatAreAlikeAsLongAsAllOfThem) {
  WorkFolder work;
  // What lets all through is alike, too.
  for (int channels : {3, 4}) {
    FilmJob job;
    job.pictures = pictures_of(work, {200, 200, 200, 20, 200}, channels);
    job.film = work.path() / "film.webp";
    ASSERT_TRUE(encode_film(job).empty());
    EXPECT_EQ(frames_in(job.film, "no_program", 24), 5) << channels;
    std::string bytes = *read_file(job.film);
    EXPECT_EQ(milliseconds_in_webp(bytes), 208);
    EXPECT_EQ(milliseconds_in_webp(bytes.substr(0, bytes.size() - 9)), 0) << "cut off";
  }
}

TEST(AnimatedWebp, NamesThePictureThatIsWrong) {
  WorkFolder work;
  FilmJob job;
  job.pictures = pictures_of(work, {200, 20}, 3), job.film = work.path() / "film.webp";
  ASSERT_TRUE(write_file(job.pictures[1], *png_text(Raster(16, 16, 3))));
  Errors errors = encode_film(job);
  ASSERT_EQ(errors.size(), 2u);
  EXPECT_EQ(errors[0].where, job.pictures[1].string());
  ASSERT_TRUE(write_file(job.pictures[1], "half of one"));
  EXPECT_EQ(encode_film(job).size(), 2u);
  EXPECT_FALSE(std::filesystem::exists(job.film));
}

TEST(Sheet, WhatIsTransparentIsNotBlack) {
  WorkFolder work;
  Raster picture(64, 64, 4);  // nothing, but for a red square in its middle
  for (int y = 24; y < 40; ++y)
    for (int x = 24; x < 40; ++x)
      picture.data[picture.index(x, y)] = picture.data[picture.index(x, y, 3)] = 255;
  std::filesystem::path file = work.path() / "a.png", sheet = work.path() / "sheet.png";
  ASSERT_TRUE(write_file(file, *png_text(picture)));
  ASSERT_TRUE(tile_sheet({{file, file}, sheet, 2, 64}).empty());
  Result<Raster> made = read_png(*read_file(sheet));
  ASSERT_TRUE(made);
  EXPECT_EQ(made->width, 2 * 64 + 3 * 4);
  for (int left : {4, 4 + 64 + 4}) {
    EXPECT_NEAR(made->at(left + 3, 4 + 3, 1), 153, 2);
    EXPECT_NEAR(made->at(left + 11, 4 + 3, 1), 204, 2);
    EXPECT_GT(made->at(left + 32, 4 + 32, 0), 250);
    EXPECT_LT(made->at(left + 32, 4 + 32, 1), 5);
  }
}

}  // namespace frond
