#include "draw/septa.h"

#include <gtest/gtest.h>

#include <cmath>

#include "emit/solid.h"

namespace frond {
namespace {

constexpr double kValley = 0.01, kDepth = 0.003, kApart = 0.001;

/// A skin of 0.1 m in valleys along z, ten of them.
Solids valleys() {
  constexpr std::uint32_t kAlong = 21, kAcross = 201;
  Solid skin;
  for (std::uint32_t j = 0; j < kAlong; ++j)
    for (std::uint32_t i = 0; i < kAcross; ++i) {
      double x = 0.1 * i / (kAcross - 1), tone = 0.5 - 0.5 * std::cos(2 * kPi * x / kValley);
      skin.surface.position.push_back(
          {x, kDepth * (tone - 0.5), -0.1 * static_cast<double>(j) / (kAlong - 1)});
      skin.surface.uv.push_back({tone, 0});
    }
  stitch_rows(skin.surface, 0, kAlong, kAcross);
  set_normals(skin.surface);
  skin.material.matter = Matter::meander;
  skin.material.septa = {kApart, kValley, kDepth};
  Solids solids;
  solids.place(solids.add_shape(skin));
  return solids;
}

std::vector<DrawnSepta> seen_from(const Solids& solids, Vec3 eye) {
  return drawn_septa(solids, septum_places(solids), {.start = -1, .duration = 0}, 1,
                     eye_toward(eye, {0.05f, 0, -0.05f}, 1, 1, 0.001));
}

TEST(Septa, RunUpEachWallAcrossIt) {
  Solids solids = valleys();
  std::vector<DrawnSepta> drawn = seen_from(solids, {0.05f, 0.2f, -0.05f});
  ASSERT_EQ(drawn.size(), 1u);
  // Ten valleys have twenty walls, 0.1 m long each.
  double all = 20 * 0.1 / kApart;
  EXPECT_NEAR(static_cast<double>(drawn[0].frames.size()), all, 0.03 * all);
  for (std::size_t i = 0; i < drawn[0].frames.size(); ++i) {
    const glm::mat3& frame = drawn[0].frames[i];
    EXPECT_GT(std::abs(glm::normalize(frame[0]).x), 0.97f) << "across the valley";
    EXPECT_GT(glm::normalize(frame[1]).y, 0.97f) << "away from the colony";
    EXPECT_NEAR(glm::length(frame[0]), kValley / 2, 0.2 * kValley) << "as wide as the wall";
    EXPECT_NEAR(glm::length(frame[1]), kDepth, 0.3 * kDepth) << "as high as the wall";
    // Up the wall: toward the ridge that is nearest, half a valley from each valley's floor.
    double in_valley = std::fmod(drawn[0].positions[i].x, kValley) / kValley;
    EXPECT_GT((in_valley < 0.5 ? 1 : -1) * frame[0].x, 0) << "toward its ridge";
  }
}

TEST(Septa, AreLeftOutWhereNobodySeesThem) {
  Solids solids = valleys();
  EXPECT_TRUE(seen_from(solids, {0.05f, 2, -0.05f}).empty()) << "smaller than a pixel";
  EXPECT_TRUE(seen_from(solids, {0.05f, -0.2f, -0.05f}).empty()) << "from behind";
  solids.shapes[0].material.septa.apart = 0;
  EXPECT_TRUE(seen_from(solids, {0.05f, 0.2f, -0.05f}).empty()) << "none are asked for";
}

TEST(Septa, StandOnTheirBody) {
  Solids solids = valleys();
  solids.position[0] = {1, 2, 3};
  std::vector<DrawnSepta> drawn = seen_from(solids, {1.05f, 2.2f, 2.95f});
  ASSERT_EQ(drawn.size(), 1u);
  std::string text = septa_text({}, drawn[0]).text;
  EXPECT_NE(text.find("#declare Septum"), text.npos);
  EXPECT_NE(text.find("Reef_Meander("), text.npos) << "they have the texture of the wall";
  EXPECT_NE(text.rfind("matrix"), text.find("matrix"));
  EXPECT_EQ(text.find("Reef_Dead"), text.npos);
  solids.shapes[0].material.dead = {{{0.05f, 0, 0}, 0.02f}};
  EXPECT_NE(septa_text({}, seen_from(solids, {1.05f, 2.2f, 2.95f})[0]).text.find("Reef_Dead(array[1]{"),
            text.npos);
}

}  // namespace
}  // namespace frond
