#include "core/text.h"

#include <gtest/gtest.h>

#include <array>

namespace frond {
namespace {

std::string number(double value, int decimals = 5) {
  std::string text;
  append(text, value, decimals);
  return text;
}

TEST(Append, WritesNumbersTheShortWay) {
  EXPECT_EQ(number(0), "0");
  EXPECT_EQ(number(-0.0), "0");
  EXPECT_EQ(number(-0.000001), "0");
  EXPECT_EQ(number(1.5), "1.5");
  EXPECT_EQ(number(-12.0625), "-12.0625");
  EXPECT_EQ(number(0.00001), "0.00001");
  EXPECT_EQ(number(0.000005), "0.00001");
  EXPECT_EQ(number(100), "100");
  EXPECT_EQ(number(-0.5, 0), "-1");
  EXPECT_EQ(number(1e12), "1000000000000");
  EXPECT_EQ(number(0.123456789, 9), "0.123456789");
}

TEST(AppendList, PutsCommasBetween) {
  std::string text;
  append_list(text, 3, 1, 2.5, -3);
  EXPECT_EQ(text, "1,2.5,-3");
}

TEST(Fill, FillsNamedHoles) {
  auto filled = [](std::string_view layout) {
    std::string text;
    auto out = [&](std::string_view piece) { text += piece; };
    fill(layout, out, [&](std::string_view name) { out(name), out(name); });
    return text;
  };
  EXPECT_EQ(filled("a{{b}}c{{d}}"), "abbcdd");
  EXPECT_EQ(filled("no hole"), "no hole");
  EXPECT_EQ(filled("open {{ only"), "open {{ only");
}

TEST(NearestName, FindsWhatWasMeant) {
  std::array<std::string_view, 4> names{"amplitude", "speed", "direction", "loop"};
  EXPECT_EQ(nearest_name("ampltiude", names), "amplitude");
  EXPECT_EQ(nearest_name("Speed", names), "speed");
  EXPECT_EQ(nearest_name("dierction", names), "direction");
  EXPECT_EQ(nearest_name("colour", names), "");
}

TEST(EditDistance, CountsSwapsOnce) {
  EXPECT_EQ(edit_distance("abcd", "abdc"), 1u);
  EXPECT_EQ(edit_distance("", "abc"), 3u);
  EXPECT_EQ(edit_distance("Same", "same"), 0u);
}

}  // namespace
}  // namespace frond
