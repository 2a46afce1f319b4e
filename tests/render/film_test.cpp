#include "render/film.h"

#include <gtest/gtest.h>

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

}  // namespace frond
