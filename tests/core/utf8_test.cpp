#include "core/utf8.h"

#include <gtest/gtest.h>

namespace frond {
namespace {

TEST(Utf8, CharactersHaveASize) {
  EXPECT_EQ(character_size(""), 0u);
  EXPECT_EQ(character_size("ab"), 1u);
  EXPECT_EQ(character_size("éa"), 2u);
  EXPECT_EQ(character_size("€"), 3u);
  EXPECT_EQ(character_size("😀"), 4u);
}

TEST(Utf8, FindsTheFirstWrongByte) {
  EXPECT_EQ(invalid_utf8("aé€😀"), std::nullopt);
  for (std::string_view wrong : {"\x80", "\xc0\xaf", "\xc3", "\xe0\x80\x80", "\xed\xa0\x80", "\xe2\x82",
                                 "\xf0\x80\x80\x80", "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\xff"}) {
    EXPECT_EQ(invalid_utf8("é" + std::string(wrong)), 2u) << wrong;
    EXPECT_EQ(character_size(wrong), 0u) << wrong;
  }
}

}  // namespace
}  // namespace frond
