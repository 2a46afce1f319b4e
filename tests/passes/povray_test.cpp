#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "draw/eyes.h"
#include "emit/texts.h"
#include "passes/frame_passes.h"
#include "traced_scene.h"

// POV-Ray as the judge of what rays meet: the same frame in black and in white fog differs by nothing but the
// fog on the way, and so tells how far away everything is that neither reflects nor lets light through.

namespace frond {
namespace {

constexpr double kFog = 4;       // metres in which it takes all but 1/e of the light
constexpr double kWhite = 0.25;  // so that bright things stay within what a file holds

LinearRaster in_fog(const Scene& scene, int frame, double white) {
  return traced_scene(text_of(scene, frame) +
                          fmt::format("fog{{fog_type 1 distance {}*Frond_Unit color rgb {}}}\n", kFog, white),
                      scene.film.size);
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
      ++inside, right += std::abs(away - ours) < 0.01 * ours;
    }
  EXPECT_GT(inside, 300);
  EXPECT_GE(right, 0.999 * inside) << right << " of " << inside;
}

INSTANTIATE_TEST_SUITE_P(All, InFog,
                         testing::Values("tests/presets/tiny_plant.json", "tests/presets/tiny_garden.json",
                                         "tests/presets/tiny_ivy.json", "tests/presets/rock.json"),
                         [](const auto& one) {
                           std::string name = one.param;
                           name = name.substr(name.rfind('/') + 1);
                           return name.substr(0, name.find('.'));
                         });

}  // namespace
}  // namespace frond
