#include "preset/synonyms.h"

#include <gtest/gtest.h>

namespace frond {
namespace {

TEST(Synonyms, AWordIsNoBeginningOfAnother) {
  EXPECT_EQ(says("how the wind blows", "wind"), 3);
  EXPECT_EQ(says("in all winds", "wind"), 3);
  EXPECT_EQ(says("a windy day", "wind"), 2);
  EXPECT_EQ(says("a window", "wind"), 1);
  EXPECT_EQ(says("the rewind", "wind"), 0);
  EXPECT_EQ(says("berries and leaves", "berry"), 3);
}

TEST(Synonyms, ThePluralLeavesWordsThatEndSo) {
  EXPECT_EQ(singular("boxes"), "box");
  EXPECT_EQ(singular("berries"), "berry");
  EXPECT_EQ(singular("grass"), "grass");
  EXPECT_EQ(singular("crocus"), "crocus");
  EXPECT_EQ(singular("tulips"), "tulip");
}

TEST(Synonyms, StandForWhatPeopleAskFor) {
  EXPECT_EQ(words_like("tulips").front(), "crocus");
  EXPECT_EQ(words_like("winter").front(), "snow");
  EXPECT_TRUE(words_like("wind").empty());
}

}  // namespace
}  // namespace frond
