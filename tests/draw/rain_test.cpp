#include "draw/rain.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "motion/rain.h"

namespace frond {
namespace {

/// One meadow for all tests, in the rain that is asked for.
const Scene& rainy_meadow(double rate, double wind = 0) {
  static Scene scene = [] {
    Result<Preset> preset = read_preset(
        R"({"film": {"frames": 48, "fps": 24, "size": [640, 360]}, "scene": {"setting": "meadow", "camera":
        {"location": [0, 1.6, 6], "look_at": [0, 1, 0]}, "meadow": {"blade": 0}, "rain": {}},
        "organisms": [{"kind": "vase", "name": "vase"}]})",
        "test.json", {});
    if (!preset) ADD_FAILURE() << preset.errors().front().text();
    return *build_scene(*preset);
  }();
  scene.setup.rain->rate = rate;
  scene.setup.wind = wind > 0 ? std::optional(Wind{.speed = wind, .direction = {1, 0, 0}}) : std::nullopt;
  return scene;
}

bool same(const Streak& a, const Streak& b) {
  return glm::distance(a.top, b.top) < 1e-3f && glm::distance(a.bottom, b.bottom) < 1e-3f;
}

TEST(RainStreaks, FallOnRoofsAndNotBelow) {
  Scene scene = rainy_meadow(50);
  auto below = [&] {
    return std::ranges::count_if(rain_streaks(scene, 0.3), [](const Streak& s) {
      return s.top.y < 1.9f && std::abs(s.top.x) < 1.9f && std::abs(s.top.z - 3) < 1.9f;
    });
  };
  ASSERT_GT(below(), 30);
  Surface roof;
  roof.position = {{-2, 2, 1}, {2, 2, 1}, {2, 2, 5}, {-2, 2, 5}};
  roof.triangle = {{0, 1, 2}, {0, 2, 3}};
  CoverGrid bodies({0, 3}, 20, 0.1f);
  bodies.add(roof);
  scene.overhead = std::make_shared<const CoverGrid>(std::move(bodies));
  EXPECT_EQ(below(), 0);
}

TEST(RainStreaks, AreAsLongAsADropFallsWhileTheShutterIsOpen) {
  const Scene& scene = rainy_meadow(20);
  std::vector<Streak> streaks = rain_streaks(scene, 0.3);
  ASSERT_GT(streaks.size(), 300u);
  EXPECT_LE(streaks.size(), 4000u);
  for (const Streak& s : streaks) {
    EXPECT_EQ(s.top.x, s.bottom.x) << "there is no wind";
    EXPECT_GT(s.top.y - s.bottom.y, terminal_speed(0.5) / 60 * 0.99);
    EXPECT_LT(s.top.y - s.bottom.y, 9.65 / 60);
    EXPECT_GT(s.share, 0);
    EXPECT_LT(s.share, 0.2f) << "hardly seen";
  }
}

TEST(RainStreaks, AreMoreInHarderRainAndNoneInDryAir) {
  EXPECT_TRUE(rain_streaks(rainy_meadow(0), 0).empty());
  std::size_t little = rain_streaks(rainy_meadow(1), 0).size();
  EXPECT_GT(little, 0u);
  EXPECT_GT(rain_streaks(rainy_meadow(10), 0).size(), 2 * little);
}

TEST(RainStreaks, FallSlantedByTheWindAndRepeatWithTheFilm) {
  const Scene& scene = rainy_meadow(10, 8);
  std::vector<Streak> first = rain_streaks(scene, 0), last = rain_streaks(scene, scene.film.length());
  ASSERT_EQ(first.size(), last.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_TRUE(same(first[i], last[i]));
    EXPECT_GT(first[i].bottom.x, first[i].top.x);
  }
}

TEST(RainStreaks, GoOnWhereTheyWere) {
  const Scene& scene = rainy_meadow(10);
  constexpr double kMoment = 1e-4;
  std::vector<Streak> before = rain_streaks(scene, 0.5), after = rain_streaks(scene, 0.5 + kMoment);
  std::size_t found = 0;
  for (const Streak& a : before)
    found += std::ranges::any_of(after, [&](const Streak& b) {
      Vec3 moved = b.top - a.top;
      return std::abs(moved.x) + std::abs(moved.z) < 1e-5f && moved.y < 0 && moved.y > -10 * kMoment;
    });
  EXPECT_GT(found, before.size() * 98 / 100) << "but for those that leave the picture";
}

TEST(RingField, IsBoundedAndRepeats) {
  Film film{.frames = 101, .fps = 24};
  EXPECT_EQ(ring_field(0, film).layers, 0);
  double last = 0;
  for (double rate : {0.05, 0.5, 2.0, 10.0, 100.0}) {
    RingField rings = ring_field(rate, film);
    double lives = film.length() / rings.life;
    EXPECT_NEAR(lives, std::round(lives), 1e-9);
    double there = rings.layers * rings.share;
    EXPECT_GE(there, last);
    EXPECT_LE(there / (rings.cell * rings.cell), 9);
    last = there;
  }
}

}  // namespace
}  // namespace frond
