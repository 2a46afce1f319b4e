#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "draw/eyes.h"
#include "emit/setting.h"
#include "emit/texts.h"
#include "passes/frame_passes.h"
#include "traced_scene.h"

// POV-Ray as the judge of what rays meet: the same frame in black and in white fog differs by nothing but the
// fog on the way, and so tells how far away everything is that neither reflects nor lets light through.

namespace frond {
namespace {

constexpr double kFog = 4;              // metres in which it takes all but 1/e of the light
constexpr double kFarthest = 6 * kFog;  // what is beyond is all fog
constexpr double kWhite = 0.25;         // so that bright things stay within what a file holds

LinearRaster in_fog(const Scene& scene, int frame, double white) {
  return traced_scene(text_of(scene, frame) +
                          fmt::format("fog{{fog_type 1 distance {}*Frond_Unit color rgb {}}}\n", kFog, white),
                      scene.film.size);
}

std::string name_of(const testing::TestParamInfo<const char*>& one) {
  std::string name = one.param;
  name = name.substr(name.rfind('/') + 1);
  return name.substr(0, name.find('.'));
}

class InFog : public testing::TestWithParam<const char*> {};

TEST_P(InFog, DepthIsThatOfPovRayInsideSurfaces) {
  Scene scene = scene_at(GetParam());
  scene.film.size = {160, 120};
  int frame = scene.film.frames;
  FramePasses passes = *frame_passes(scene, *TracedFilm::of(scene), frame, 2);
  LinearRaster white = in_fog(scene, frame, kWhite), black = in_fog(scene, frame, 0);
  Eye eye = eye_at(scene, scene.film.time(frame));
  int inside = 0, right = 0;
  for (int y = 1; y + 1 < passes.height; ++y)
    for (int x = 1; x + 1 < passes.width; ++x) {
      auto at = [&](int dx, int dy) { return static_cast<std::size_t>((y + dy) * passes.width + x + dx); };
      std::size_t i = at(0, 0);
      bool whole = passes.coverage[i] == 1 && passes.things[i].size() == 1 &&
                   passes.things[i][0].first.kind != ThingKind::water;
      for (int k = 0; whole && k < 9; ++k) {
        std::size_t beside = at(k % 3 - 1, k / 3 - 1);
        whole = passes.things[beside] == passes.things[i] &&
                std::abs(passes.depth[beside] - passes.depth[i]) < 0.05f * passes.depth[i];
      }
      if (!whole) continue;
      double fog = (white.data[3 * i + 1] - black.data[3 * i + 1]) / 65535.0 / kWhite;
      double away = -kFog * std::log(std::max(1 - fog, 1e-6));
      double ours = static_cast<double>(glm::distance(passes.position[i], eye.at));
      if (ours > kFarthest) continue;
      ++inside, right += std::abs(away - ours) < 0.01 * ours;
    }
  EXPECT_GT(inside, 300);
  EXPECT_GE(right, 0.999 * inside) << right << " of " << inside;
}

INSTANTIATE_TEST_SUITE_P(All, InFog,
                         testing::Values("tests/presets/tiny_plant.json", "tests/presets/tiny_garden.json",
                                         "tests/presets/tiny_ivy.json", "tests/presets/rock.json"),
                         name_of);

/// Light of a picture between the middles of its pixels.
Vec3 light_at(const LinearRaster& of, Vec2 place) {
  glm::ivec2 first(glm::floor(place));
  Vec2 share = place - Vec2(first);
  auto light = [&](int x, int y) {
    const std::uint16_t* at = &of.data[static_cast<std::size_t>(3 * (y * of.width + x))];
    return Vec3(at[0], at[1], at[2]) / 65535.0f;
  };
  return glm::mix(glm::mix(light(first.x, first.y), light(first.x + 1, first.y), share.x),
                  glm::mix(light(first.x, first.y + 1), light(first.x + 1, first.y + 1), share.x), share.y);
}

/// Whether all rays of the four pixels about a place meet that thing alone.
bool shows_alone(const FramePasses& of, Vec2 place, const Thing& thing) {
  glm::ivec2 first(glm::floor(place));
  if (glm::any(glm::lessThan(first, glm::ivec2(0))) || first.x + 1 >= of.width || first.y + 1 >= of.height)
    return false;
  for (int k = 0; k < 4; ++k) {
    const auto& things = of.things[static_cast<std::size_t>((first.y + k / 2) * of.width + first.x + k % 2)];
    if (things.size() != 1 || things[0].first != thing) return false;
  }
  return true;
}

class InColor : public testing::TestWithParam<const char*> {};

/// Colours without light. Textures stick to what moves, so those of the next frame, where the motion leads,
/// are the same; at the same pixel they are others.
TEST_P(InColor, MotionLeadsToTheSameSpotOfATexture) {
  Scene scene = scene_at(GetParam());
  scene.film.size = {320, 240};
  int frame = scene.film.frames / 2;
  Result<TracedFilm> film = TracedFilm::of(scene);
  FramePasses passes = *frame_passes(scene, *film, frame, 2),
              after = *frame_passes(scene, *film, frame + 1, 2);
  auto colors = [&](int number) {
    std::vector<Picture> files = *setting_pictures(scene, scene.film.time(number));
    for (const Drawing& drawing : scene.drawings)
      std::ranges::move(*drawing.draw(), std::back_inserter(files));
    return traced_scene(text_of(scene, number), scene.film.size,
                        {"+Q1", "+A0.0", "+AM1", "+R3", "-J", "Declare=Frond_Albedo=1"}, files);
  };
  LinearRaster here = colors(frame), next = colors(frame + 1);
  float moved = 0, unmoved = 0;
  int count = 0;
  for (std::size_t i = 0; i < passes.forward.size(); ++i) {
    Vec2 at(static_cast<int>(i) % passes.width, static_cast<int>(i) / passes.width), to = passes.forward[i];
    if (glm::length(to) < 1 || passes.things[i].empty()) continue;
    const Thing& thing = passes.things[i][0].first;
    if (!shows_alone(passes, at, thing) || !shows_alone(after, at + to, thing)) continue;
    ++count;
    moved += glm::distance(light_at(next, at + to), light_at(here, at));
    unmoved += glm::distance(light_at(next, at), light_at(here, at));
  }
  EXPECT_GT(count, 100);
  EXPECT_LT(moved, 0.5f * unmoved) << count << " pixels";
}

INSTANTIATE_TEST_SUITE_P(All, InColor,
                         testing::Values("tests/presets/tiny_film.json", "tests/presets/tiny_reef.json"),
                         name_of);

}  // namespace
}  // namespace frond
