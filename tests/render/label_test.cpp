#include "render/label.h"

#include <gtest/gtest.h>

namespace frond {

using Lines = std::vector<std::string>;

TEST(Label, IsOneLineWhereThereIsRoom) {
  EXPECT_EQ(label_lines("seed 1   pitch 20", 320), Lines{"seed 1   pitch 20"});
  EXPECT_EQ(label_lines("a\tb\n", 320), Lines{"a b "});
}

TEST(Label, IsPartedAtThreeBlanksAndThenBetweenWords) {
  EXPECT_EQ(label_lines("seed 1   pitch 20", 80), (Lines{"seed 1", "pitch 20"}));
  EXPECT_EQ(label_lines("angle_jitter 10.125", 80), (Lines{"angle_jitter ", "10.125"}));
  EXPECT_EQ(label_lines("abcdefghijklmnopqrstuvwxyz", 80), (Lines{"abcdefghijklmno", "pqrstuvwxyz"}));
}

TEST(Label, CutsNoCharacterOfSeveralBytes) { EXPECT_EQ(label_lines("ääääää", 16), (Lines{"äää", "äää"})); }

}  // namespace frond
