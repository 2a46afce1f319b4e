#include "core/figures.h"

#include <gtest/gtest.h>

namespace frond {
namespace {

TEST(Figures, ReadAsAPersonWritesThem) {
  EXPECT_EQ(bytes_text(12), "12 bytes");
  EXPECT_EQ(bytes_text(100e6), "100 MB");
  EXPECT_EQ(bytes_text(999.7e6), "1 GB");
  EXPECT_EQ(bytes_text(3.456e6), "3.46 MB");
  EXPECT_EQ(bytes_text(1.62e11), "162 GB");
  EXPECT_EQ(bytes_text(1.15e18), "1.15 EB");
  EXPECT_EQ(bytes_text(1e40), "more than 1000 EB");
  EXPECT_EQ(seconds_text(0.42), "0.42 s");
  EXPECT_EQ(seconds_text(99.7), "2 min");
  EXPECT_EQ(seconds_text(1600), "27 min");
  EXPECT_EQ(seconds_text(5990), "1.7 h");
  EXPECT_EQ(seconds_text(1e6), "12 days");
  EXPECT_EQ(count_text(12345), "12345");
  EXPECT_EQ(count_text(2.684e8), "268 million");
  EXPECT_EQ(count_text(1.2e9), "1.2 billion");
  EXPECT_EQ(count_text(3e300), "10^300");
}

TEST(Figures, HaveNoExponentOfE) {
  for (double x = 1e-6; x < 1e300; x *= 1.7)
    for (const std::string& text : {bytes_text(x), seconds_text(x), count_text(x)}) {
      EXPECT_EQ(text.find("e+"), std::string::npos) << text;
      EXPECT_EQ(text.find("e-"), std::string::npos) << text;
    }
}

}  // namespace
}  // namespace frond
