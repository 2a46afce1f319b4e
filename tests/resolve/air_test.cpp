#include "resolve/air.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "scene_at.h"
#include "settings/settings.h"

namespace frond {
namespace {

Scene garden() {
  Scene scene = scene_at("tests/presets/tiny_garden.json");
  scene.film.size = {48, 48};
  return scene;
}

/// A picture of one light, and it behind the air of a garden at noon.
class AirOfAGarden : public testing::Test {
 protected:
  LightPicture behind(const Air& air, Vec3 light) {
    scene_.setup.air = air;
    LightPicture picture(pixels(), light);
    AirLight(scene_.setup, 0, frame_, scene_.film.size).add(picture, 0);
    return picture;
  }
  std::size_t pixels() const { return std::size_t(scene_.film.size[0]) * std::size_t(scene_.film.size[1]); }
  std::optional<PassHit> hit(std::size_t pixel, Vec2 within = Vec2(0.5f)) const {
    Vec2 size(scene_.film.size[0], scene_.film.size[1]);
    Vec2 place(pixel % std::size_t(scene_.film.size[0]), pixel / std::size_t(scene_.film.size[0]));
    return frame_.trace(frame_.eye.at, picture_ray(frame_.eye, (place + within) / size));
  }
  /// Whether a pixel shows one surface at nearly one distance.
  bool is_even(std::size_t pixel) const {
    for (Vec2 corner : {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1), Vec2(1, 1)}) {
      std::optional<PassHit> one = hit(pixel, corner), middle = hit(pixel);
      if (!one || !middle || std::abs(one->away - middle->away) > 0.02f * middle->away) return false;
    }
    return true;
  }

  Scene scene_ = garden();
  TracedFilm film_ = taken(TracedFilm::of(scene_));
  TracedFrame frame_ = taken(film_.at(0));
};

TEST_F(AirOfAGarden, TakesAFiftiethAtTheDistanceOfVisibility) {
  constexpr float kVisibility = 20;
  Air air{.visibility = kVisibility, .height = 10'000};
  LightPicture dark = behind(air, Vec3(0)), bright = behind(air, Vec3(1));
  int asked = 0;
  for (std::size_t p = 0; p < pixels(); ++p) {
    if (!is_even(p)) continue;
    float passed = std::pow(0.02f, hit(p)->away / kVisibility);
    EXPECT_NEAR(bright[p].g - dark[p].g, passed, 0.02f) << p;
    ++asked;
  }
  EXPECT_GT(asked, 100);
}

TEST_F(AirOfAGarden, ThinsUpwardByAPowerOfE) {
  // A sum of thin layers, for eyes in, below and above the mist.
  for (float level : {-3.0f, 0.5f, 4.0f}) {
    Air air{.visibility = 6, .level = level, .height = 0.8};
    LightPicture dark = behind(air, Vec3(0)), bright = behind(air, Vec3(1));
    for (std::size_t p = 0; p < pixels(); ++p) {
      if (!is_even(p)) continue;
      constexpr int kLayers = 400;
      Vec3 to = hit(p)->at - frame_.eye.at;
      double depth = 0;
      for (int k = 0; k < kLayers; ++k) {
        double height = frame_.eye.at.y + to.y * (k + 0.5) / kLayers;
        depth += std::exp(-std::max(0.0, height - level) / 0.8) * 3.912 / 6 * glm::length(to) / kLayers;
      }
      EXPECT_NEAR(bright[p].g - dark[p].g, std::exp(-depth), 0.02) << p << " level " << level;
    }
  }
}

TEST_F(AirOfAGarden, ClearAirChangesNothingAndThickAirHidesAll) {
  for (Vec3 light : behind({.visibility = 5e9}, Vec3(0.3f))) EXPECT_NEAR(light.g, 0.3f, 1e-4f);
  LightPicture dark = behind({.visibility = 0.5}, Vec3(0)), bright = behind({.visibility = 0.5}, Vec3(1));
  for (std::size_t p = 0; p < pixels(); ++p)
    if (std::optional<PassHit> there = hit(p); there && there->away > 2) {
      EXPECT_NEAR(bright[p].g, dark[p].g, 1e-4f) << p;
    }
}

TEST_F(AirOfAGarden, IsBrighterTowardTheSunUnlessItThrowsAllWaysAlike) {
  Daylight light = drawn_daylight(setup_at(scene_.setup, 0));
  Air even{.visibility = 30, .forward = 0}, mist{.visibility = 30, .forward = 0.7};
  LightPicture alike = behind(even, Vec3(0)), forward = behind(mist, Vec3(0));
  Vec2 size(scene_.film.size[0], scene_.film.size[1]);
  int asked = 0;
  for (std::size_t p = 0; p < pixels(); ++p) {
    Vec2 place(p % std::size_t(size.x), p / std::size_t(size.x));
    float cosine = glm::dot(picture_ray(frame_.eye, (place + 0.5f) / size), light.sun);
    // The function of Henyey and Greenstein is 1 where its base is its mean.
    float turned = 0.51f / std::pow(1.49f - 1.4f * cosine, 1.5f);
    if (std::abs(turned - 1) < 0.1f) continue;
    EXPECT_EQ(forward[p].g >= alike[p].g, turned > 1) << p;
    ++asked;
  }
  EXPECT_GT(asked, 100);
}

TEST_F(AirOfAGarden, IsDimmerBehindWhatHidesTheSun) {
  // The air just before the ground, in the shade of what stands there, against that of an open place.
  Air air{.visibility = 50, .height = 10'000};
  LightPicture picture = behind(air, Vec3(0));
  float least = std::numeric_limits<float>::max(), most = 0;
  for (std::size_t p = 0; p < pixels(); ++p) {
    if (!is_even(p)) continue;
    float scattered = 1 - std::pow(0.02f, hit(p)->away / 50);
    least = std::min(least, picture[p].g / scattered), most = std::max(most, picture[p].g / scattered);
  }
  EXPECT_LT(least, 0.8f * most);
}

TEST_F(AirOfAGarden, RowsAreThoseOfThePicture) {
  scene_.setup.air = Air{.visibility = 40};
  AirLight air(scene_.setup, 0, frame_, scene_.film.size);
  auto wide = std::size_t(scene_.film.size[0]);
  LightPicture whole(pixels(), Vec3(0.2f)), rows(5 * wide, Vec3(0.2f));
  air.add(whole, 0);
  air.add(rows, 7);
  for (std::size_t p = 0; p < rows.size(); ++p) EXPECT_EQ(rows[p], whole[7 * wide + p]);
}

}  // namespace
}  // namespace frond
