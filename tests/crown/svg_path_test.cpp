#include <gtest/gtest.h>

#include <cmath>

#include "crown/silhouette.h"

namespace frond {
namespace {

double area(const std::vector<Vec2>& o) {
  double sum = 0;
  for (std::size_t i = 0, j = o.size() - 1; i < o.size(); j = i++) sum += o[j].x * o[i].y - o[i].x * o[j].y;
  return std::abs(sum / 2);
}

TEST(SvgPath, DrawsEveryCommand) {
  const std::pair<const char*, double> cases[] = {
      {"M0 0 L10 0 10 10 0 10 Z", 100},
      {"m 0,0 10,0 0,10 -10,0z", 100},
      {"M0,0H10V10H0Z", 100},
      {"m0 0h10v10h-10z", 100},
      {"M0 0 Q10 0 10 10 L0 10Z", 100 - 100.0 / 6 * 1},
      {"M-5 0A5 5 0 0 1 5 0A5 5 0 0 1 -5 0Z", kPi * 25},
      {"M-5 0a5,5 0 01 10 0 5,5 0 01-10 0z", kPi * 25},
      {"M0 0C0 0 10 0 10 0L10 10L0 10Z", 100},
      {"M0 0 C2 0 8 0 10 0 S 10 8 10 10 L0 10Z", 105.4},
      {"M0 0Q5 0 10 0T 20 0L20 10L0 10Z", 200},
  };
  for (auto [path, expected] : cases) {
    Result<std::vector<std::vector<Vec2>>> read = read_svg_path(path);
    ASSERT_TRUE(read.ok()) << path << ": " << read.errors()[0].what;
    EXPECT_NEAR(area((*read)[0]), expected, 0.01 * expected) << path;
  }
}

TEST(SvgPath, SaysWhereItCannotRead) {
  for (const char* path :
       {"M0 0 L1e30 0 L0 1Z", "L 1 1", "M 1", "M 1 x", "M0 0 K 3", "M0 0 A 1 1 0 2 0 3 3", "5 5"}) {
    Result<std::vector<std::vector<Vec2>>> read = read_svg_path(path);
    ASSERT_FALSE(read.ok()) << path;
    EXPECT_NE(read.errors()[0].what.find("expected"), std::string::npos);
  }
}

TEST(SvgPath, FilesAreReadWithAllTheirPaths) {
  auto read = read_svg(
      "<svg xmlns='http://www.w3.org/2000/svg'><g><path d='M0 0L1 0L1 1Z'/></g><path d='M5 5L6 5L6 "
      "6Z'/></svg>");
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read->size() >= 2, true);
  EXPECT_FALSE(read_svg("<svg/>").ok());
}

TEST(Silhouette, HolesAreOutside) {
  auto made = Silhouette::from_outlines({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{1, 1}, {3, 1}, {3, 3}, {1, 3}}});
  ASSERT_TRUE(made.ok());
  EXPECT_TRUE(made->inside(Vec2(-0.4f, 0.5f)));
  EXPECT_FALSE(made->inside(Vec2(0, 0.5f)));
  EXPECT_FALSE(made->inside(Vec2(0.6f, 0.5f)));
  EXPECT_NEAR(made->width(), 1, 1e-6);
}

TEST(Silhouette, APictureCountsByOpacityOrDarkness) {
  Raster dark(40, 20, 1);
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 40; ++x) dark.data[dark.index(x, y)] = (x >= 10 && x < 20 && y >= 5) ? 0 : 255;
  Result<Silhouette> made = Silhouette::from_picture(dark);
  ASSERT_TRUE(made.ok());
  EXPECT_NEAR(made->width(), 10.0 / 15, 1e-6);
  EXPECT_TRUE(made->inside(Vec2(0, 0.5f)));
  EXPECT_FALSE(made->inside(Vec2(0.4f, 0.5f)));
  Raster clear(4, 4, 4);  // black, and nothing of it opaque
  EXPECT_FALSE(Silhouette::from_picture(clear).ok());
  clear.data[clear.index(2, 1, 3)] = 255;
  EXPECT_TRUE(Silhouette::from_picture(clear).ok());
}

}  // namespace
}  // namespace frond
