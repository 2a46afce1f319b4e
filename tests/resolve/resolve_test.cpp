#include "resolve/resolve.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/parallel.h"
#include "draw/eyes.h"
#include "scene_at.h"

namespace frond {
namespace {

Scene raw_scene() {
  Scene scene = scene_at("tests/presets/tiny_film.json");
  scene.film.raw = true;
  return scene;
}

/// Raw frames painted by what their rays meet: each thing in a grey of its own.
class Painted {
 public:
  enum class Paint { grey, matt, speckled };

  /// `matt`: what is lit is the brighter the more it faces the light; `speckled`: black and white by 2 cm.
  explicit Painted(const Scene& scene, Paint paint = Paint::grey)
      : scene_(scene), film_(taken(TracedFilm::of(scene))), paint_(paint) {}

  Vec3 seen(const TracedFrame& frame, Vec2 place) const {
    return color(frame.trace(frame.eye.at, picture_ray(frame.eye, place)), frame);
  }
  Vec3 color(const std::optional<PassHit>& hit, const TracedFrame& frame) const {
    if (!hit) return {0, 0, 1};
    float shade = hit->spot.thing.kind == ThingKind::branches ? 0.8f : 0.2f;
    if (paint_ == Paint::matt) return Vec3(frame.lit(*hit) ? 0.1f + hit->spot.facing : 0.1f);
    if (paint_ == Paint::speckled) {
      glm::ivec3 cell(glm::floor(50.0f * hit->at));
      return Vec3((cell.x + cell.y + cell.z) % 2 != 0 ? 1.0f : 0.0f);
    }
    return Vec3(shade, frame.lit(*hit) ? 1 : 0.5f, 0);
  }

  /// The mean of side * side rays a pixel.
  LightPicture picture(int number, int side, Vec2 shift) const {
    TracedFrame frame = taken(film_.at(scene_.film.time(number)));
    Vec2 size(scene_.film.size[0], scene_.film.size[1]);
    LightPicture light;
    for (int y = 0; y < scene_.film.size[1]; ++y)
      for (int x = 0; x < scene_.film.size[0]; ++x) {
        Vec3 sum(0);
        for (int ray = 0; ray < side * side; ++ray)
          sum += seen(
              frame,
              (Vec2(x, y) + shift + (Vec2(ray % side, ray / side) + 0.5f) / static_cast<float>(side)) / size);
        light.push_back(sum / static_cast<float>(side * side));
      }
    return light;
  }
  LightPicture raw(int number) const { return picture(number, 1, sample_shift(scene_.film, number)); }

  /// The mean of side * side rays a pixel through the lens, at moments while the shutter is open.
  LightPicture exposed(int number, int side, int moments) const {
    LightPicture light(scene_.film.size[0] * std::size_t(scene_.film.size[1]), Vec3(0));
    Vec2 size(scene_.film.size[0], scene_.film.size[1]);
    for (int moment = 0; moment < moments; ++moment) {
      double open = scene_.setup.camera.shutter / scene_.film.fps * (moment + 0.5) / moments;
      TracedFrame frame = taken(film_.at(scene_.film.time(number) + open));
      for (std::size_t i = 0; i < light.size(); ++i)
        for (int ray = 0; ray < side * side; ++ray) {
          Vec2 pixel(i % static_cast<std::size_t>(size.x), i / static_cast<std::size_t>(size.x));
          auto [from, along] = frame.ray((pixel + place_in_pixel(ray, side)) / size, ray, 0.3f);
          std::optional<PassHit> hit = frame.trace(from, along);
          light[i] += color(hit, frame) / static_cast<float>(side * side * moments);
        }
    }
    return light;
  }

  const TracedFilm& film() const { return film_; }

 private:
  const Scene& scene_;
  TracedFilm film_;
  Paint paint_;
};

double error(const LightPicture& a, const LightPicture& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += static_cast<double>(glm::dot(a[i] - b[i], a[i] - b[i]));
  return std::sqrt(sum / static_cast<double>(a.size()));
}

TEST(Resolve, OneColourStaysOneColour) {
  Scene scene = raw_scene();
  TracedFilm film = taken(TracedFilm::of(scene));
  std::size_t count =
      static_cast<std::size_t>(scene.film.size[0]) * static_cast<std::size_t>(scene.film.size[1]);
  Resolver resolver(scene, film, [&](int) { return LightPicture(count, Vec3(0.25f, 0.5f, 0.75f)); });
  LightPicture made = taken(resolver.frame(3));
  for (const Vec3& light : made) EXPECT_LT(glm::distance(light, Vec3(0.25f, 0.5f, 0.75f)), 1e-4f);
}

TEST(Resolve, IsFarNearerToManySamplesThanItsRawFrames) {
  Scene scene = raw_scene();
  Painted painted(scene);
  Resolver resolver(scene, painted.film(), [&](int number) { return painted.raw(number); });
  for (int number : {3, 5, 6}) {
    LightPicture many = painted.picture(number, 8, Vec2(0));
    EXPECT_LT(error(*resolver.frame(number), many), 0.5 * error(painted.raw(number), many)) << number;
  }
}

TEST(Resolve, ThinBranchesAreShadedAsManySamplesHaveIt) {
  Scene scene = raw_scene();
  Painted painted(scene, Painted::Paint::matt);
  Resolver resolver(scene, painted.film(), [&](int number) { return painted.raw(number); });
  double made = 0, raw = 0;
  for (int number : {3, 5, 6}) {
    LightPicture many = painted.picture(number, 8, Vec2(0));
    made += error(*resolver.frame(number), many), raw += error(painted.raw(number), many);
  }
  EXPECT_LT(made, 0.19 * raw) << made << ' ' << raw;
}

TEST(Resolve, BlursWhatMovesAndWhatIsOutOfFocus) {
  for (bool lens : {false, true}) {
    Scene scene = raw_scene();
    if (lens)
      scene.setup.camera.aperture = 0.4;
    else
      scene.setup.camera.shutter = 1, scene.setup.camera.shutter_samples = 4;
    Painted painted(scene);
    Resolver resolver(scene, painted.film(), [&](int number) { return painted.raw(number); });
    LightPicture many = painted.exposed(4, 8, lens ? 1 : 4), sharp = painted.picture(4, 8, Vec2(0));
    EXPECT_GT(error(sharp, many), 0.01) << lens;
    EXPECT_LT(error(*resolver.frame(4), many), 0.7 * error(sharp, many)) << lens;
  }
}

TEST(Resolve, WhatIsOutOfFocusIsNotGrainy) {
  Scene scene = raw_scene();
  scene.setup.camera.aperture = 0.4;
  scene.setup.camera.focus = Focus{Animated<Vec3>(Vec3(0, 0.6, 1.6)), ""};
  Painted painted(scene, Painted::Paint::speckled);
  Resolver resolver(scene, painted.film(), [&](int number) { return painted.raw(number); });
  auto grain = [&](const LightPicture& picture) {  // from pixel to pixel
    double sum = 0;
    for (std::size_t i = 0; i + 1 < picture.size(); ++i) sum += std::abs(picture[i + 1].x - picture[i].x);
    return sum;
  };
  EXPECT_LT(grain(*resolver.frame(4)), 0.5 * grain(painted.exposed(4, 24, 1))) << "and that has 576 rays";
}

TEST(Resolve, AStillHasFourRawSamplesAPixel) {
  Scene scene = raw_scene();
  scene.film.frames = 1;
  EXPECT_EQ(scene.film.drawn_size(), (std::array{2 * scene.film.size[0], 2 * scene.film.size[1]}));
  Scene fine = scene;
  fine.film.size = scene.film.drawn_size();
  Painted painted(scene), raws(fine);
  EXPECT_EQ(sample_shift(scene.film, 1), Vec2(0));
  LightPicture raw = raws.raw(1), many = painted.picture(1, 8, Vec2(0)),
               four = painted.picture(1, 2, Vec2(0));
  Resolver resolver(scene, painted.film(), [&](int) { return raw; });
  EXPECT_LT(error(*resolver.frame(1), many), error(four, many));
}

TEST(Resolve, AStillInBandsIsTheSameAsAWholeOne) {
  Scene scene = raw_scene();
  scene.film.frames = 1;
  Scene fine = scene;
  fine.film.size = scene.film.drawn_size();
  Painted painted(scene), raws(fine);
  LightPicture raw = raws.raw(1);
  Resolver whole(scene, painted.film(), [&](int) { return raw; });
  LightPicture wanted = *whole.frame(1);
  auto wide = static_cast<std::size_t>(fine.film.size[0]);
  for (int band : {1, 5, 1000}) {
    Resolver resolver(scene, painted.film(), [](int) { return Error{"", "not as a whole"}; });
    LightPicture made;
    int last = 0;
    std::size_t most = 0;
    auto rows = [&](int first, int count) -> Result<LightPicture> {
      EXPECT_GE(first, last);
      last = first, most = std::max(most, static_cast<std::size_t>(count));
      auto begin = raw.begin() + static_cast<std::ptrdiff_t>(wide * static_cast<std::size_t>(first));
      return LightPicture(begin, begin + static_cast<std::ptrdiff_t>(wide * static_cast<std::size_t>(count)));
    };
    Errors errors = resolver.still_in_bands(rows, band, [&](const LightPicture& more) {
      made.insert(made.end(), more.begin(), more.end());
      return Errors{};
    });
    EXPECT_TRUE(errors.empty());
    EXPECT_EQ(made, wanted) << band;
    EXPECT_LE(most, 2 * static_cast<std::size_t>(band) + 32) << "no more than it needs";
  }
}

TEST(Resolve, DependsNeitherOnThreadsNorOnOtherFrames) {
  Scene scene = raw_scene();
  Painted painted(scene);
  auto raw = [&](int number) { return painted.raw(number); };
  Resolver in_order(scene, painted.film(), raw), alone(scene, painted.film(), raw);
  for (int number = 1; number < 4; ++number) (void)in_order.frame(number);
  LightPicture one = *in_order.frame(4);
  limit_threads(1);
  LightPicture other = *alone.frame(4);
  limit_threads(0);
  EXPECT_EQ(one, other);
}

TEST(Resolve, TellsWhichRawFrameIsMissing) {
  Scene scene = raw_scene();
  TracedFilm film = taken(TracedFilm::of(scene));
  Resolver resolver(scene, film, [&](int number) -> Result<LightPicture> {
    return Error{"frame " + std::to_string(number), "is gone"};
  });
  Result<LightPicture> made = resolver.frame(2);
  ASSERT_FALSE(made);
  EXPECT_EQ(made.errors()[0].where, "frame 1");
}

TEST(SampleShift, SpreadsOverThePixelAndStaysInIt) {
  Film film;
  film.raw = true;
  Vec2 sum(0);
  for (int frame = 1; frame <= 36; ++frame) {
    Vec2 shift = sample_shift(film, frame);
    EXPECT_TRUE(glm::all(glm::lessThanEqual(glm::abs(shift), Vec2(0.5f))));
    sum += shift;
  }
  EXPECT_LT(glm::length(sum / 36.0f), 0.03f);
  film.raw = false;
  EXPECT_EQ(sample_shift(film, 5), Vec2(0));
}

}  // namespace
}  // namespace frond
