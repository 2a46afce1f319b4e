#include "scene/scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace frond {
namespace {

/// Two years in twenty seconds.
Copies copies_with(const std::string& present, const std::string& year = R"("year": [[0, 0], [20, 2]],)") {
  Result<Preset> preset =
      read_preset(R"({"film": {"frames": 200, "fps": 10}, "scene": {"setting": "forest", )" + year +
                      R"( "camera": {"location": [0, 3, 20]}, "forest": {"terrain": {"size": 40}}},
          "organisms": [{"kind": "vase", "count": 60, "sown": {"models": 1, )" +
                      present + R"( "where": {"layer": "herbs", "radius": 0.2}}}]})",
                  "test.json", {});
  if (!preset) ADD_FAILURE() << preset.errors().front().text();
  return build_scene(*preset)->copy_sets.at(0).copies;
}

/// Seconds of the film at a year, which passes slowly at its ends.
double at(double year) {
  Animated<double> course({{0, 0}, {20, 2}});
  double early = 0, late = 20;
  for (int i = 0; i < 50; ++i) (course.at((early + late) / 2) < year ? early : late) = (early + late) / 2;
  return early;
}

int there_at(const Copies& copies, double time) {
  int count = 0;
  for (std::size_t i = 0; i < copies.size(); ++i) count += copies.there(i, time);
  return count;
}

/// Sum of the sizes of all copies.
double sum_at(const Copies& copies, double time) {
  double sum = 0;
  for (std::size_t i = 0; i < copies.size(); ++i)
    if (copies.there(i, time)) sum += copies.scale_at(i, time).y;
  return sum;
}

TEST(Season, CopiesComeUpAndGoInTheirPartOfEachYear) {
  Copies all = copies_with(""), autumn = copies_with(R"("present": [0.6, 0.9],)");
  EXPECT_EQ(all.size(), 60u);
  for (double year : {0.0, 1.0}) {
    EXPECT_EQ(there_at(autumn, at(year + 0.3)), 0);
    EXPECT_EQ(there_at(autumn, at(year + 0.59)), 0);
    int some = there_at(autumn, at(year + 0.67));
    EXPECT_TRUE(some > 5 && some < 55) << some;
    EXPECT_NEAR(sum_at(autumn, at(year + 0.75)), sum_at(all, 0), 0.1);
    EXPECT_EQ(there_at(autumn, at(year + 0.92)), 0);
  }
}

TEST(Season, APartOfTheYearMayRunPastItsEnd) {
  Copies winter = copies_with(R"("present": [0.9, 0.2],)");
  EXPECT_EQ(there_at(winter, at(0.5)), 0);
  EXPECT_EQ(there_at(winter, at(1.06)), 60);
  EXPECT_EQ(there_at(winter, at(1.21)), 0);
}

TEST(Season, NothingPops) {
  Copies autumn = copies_with(R"("present": [0.6, 0.9],)");
  for (std::size_t i = 0; i < autumn.size(); ++i) {
    const CopySpan& span = autumn.span[i];
    auto meets = [&](double time, float size) {
      for (std::size_t k = 0; k < autumn.size(); ++k)
        if (k != i && autumn.foot[k] == autumn.foot[i] && autumn.there(k, time))
          return std::abs(autumn.span[k].size(time).y - size) < 1e-3f;
      return size < 0.03f;
    };
    EXPECT_TRUE(meets(span.begin - 1e-7, span.first.y)) << i;
    EXPECT_TRUE(meets(span.end, span.last.y)) << i;
  }
}

TEST(Season, WithoutAYearTheyStandThereAlways) {
  EXPECT_EQ(there_at(copies_with(R"("present": [0.6, 0.9],)", ""), 3), 60);
}

}  // namespace
}  // namespace frond
