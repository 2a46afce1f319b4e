#include "scene/shading.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "scene/scene.h"

namespace frond {
namespace {

/// A disc that lies over whatever is below it, and a dome.
Specimen body(Vec3 at, Vec3 size, Matter matter) {
  Specimen s;
  Surface ball;
  constexpr int kRings = 24, kSides = 48;
  for (int r = 0; r <= kRings; ++r)
    for (int k = 0; k < kSides; ++k) {
      double down = kPi * r / kRings, turn = 2 * kPi * k / kSides;
      Vec3 n(std::sin(down) * std::cos(turn), std::cos(down), std::sin(down) * std::sin(turn));
      ball.position.push_back(n), ball.normal.push_back(n), ball.uv.push_back({0, 0});
    }
  for (std::uint32_t r = 0; r < kRings; ++r)
    for (std::uint32_t k = 0; k < kSides; ++k) {
      std::uint32_t a = r * kSides + k, b = r * kSides + (k + 1) % kSides;
      if (r > 0) ball.triangle.push_back({a, b, b + kSides});
      if (r + 1 < kRings) ball.triangle.push_back({a, b + kSides, a + kSides});
    }
  s.model.solids.place(s.model.solids.add_shape({std::move(ball), {.matter = matter}}), at, Quat(1, 0, 0, 0),
                       size);
  return s;
}

Specimen dome(float x) { return body({x, 0, 0}, {0.1f, 0.1f, 0.1f}, Matter::polyps); }
Specimen table(float x) { return body({x, 0.18f, 0}, {0.35f, 0.01f, 0.35f}, Matter::sponge); }

/// The least light of a vertex that looks upward.
float top_light(const Specimen& s) {
  const Solid& solid = s.model.solids.shapes[0];
  return solid.light.empty() ? 1 : solid.light[0];
}

TEST(Shading, TakesTheLightFromWhatIsBelowAndFromNothingElse) {
  std::vector<Specimen> reef{dome(0), table(0), dome(1.3f)};
  shade(reef);
  EXPECT_LT(top_light(reef[0]), 0.25f);
  EXPECT_TRUE(reef[1].model.solids.shapes[0].light.empty()) << "a sponge needs none";
  EXPECT_TRUE(reef[2].model.solids.shapes[0].light.empty()) << "too far away";
}

TEST(Shading, IsThatOfNeighboursNotItsOwn) {
  std::vector<Specimen> alone{dome(0), dome(0.9f)};
  shade(alone);
  for (const Specimen& s : alone) EXPECT_TRUE(s.model.solids.shapes[0].light.empty());
}

TEST(Shading, GrowsWithTheShareOfTheSkyThatIsCovered) {
  float last = 0;
  for (float away : {0.0f, 0.2f, 0.35f, 0.5f, 1.2f}) {
    std::vector<Specimen> reef{dome(0), table(away)};
    shade(reef);
    EXPECT_GE(top_light(reef[0]), last) << away;
    last = top_light(reef[0]);
  }
  EXPECT_GT(last, 0.9f);
}

TEST(Shading, ACoralUnderATableDiesWhereNoneStandsThereItLives) {
  const char* brain =
      R"({"name": "brain", "species": "presets/species/corals/honeycomb.json", "place": {"at": [[0.22, 0]]}})";
  const char* over = R"({"species": "presets/species/corals/table_coral.json", "place": {"at": [[0, 0]]}})";
  auto starved = [&](bool table) {
    std::string text = std::string(R"({"seed": 2, "scene": {"setting": "underwater"}, "organisms": [)") +
                       brain + (table ? std::string(",") + over : "") + "]}";
    Scene scene = *build_scene(*read_preset(text, "shade", {}));
    const Solid& solid = scene.specimens[0].model.solids.shapes[0];
    EXPECT_EQ(scene.specimens[0].name, "brain");
    return std::ranges::count_if(solid.light, [](float light) { return light < 0.28f; });
  };
  EXPECT_EQ(starved(false), 0);
  EXPECT_GT(starved(true), 20);
}

TEST(Shading, FallsOnBranchesToo) {
  auto staghorn = [](float x) {
    Specimen s;
    s.look.branches.skin.emplace();
    Skeleton& bones = s.model.skeleton;
    std::int32_t below = Skeleton::kRoot;
    for (int i = 0; i < 12; ++i) below = bones.add({x, 0.01f * static_cast<float>(i), 0}, 0.005f, below, 0);
    return s;
  };
  std::vector<Specimen> reef{staghorn(0), table(0), staghorn(1.3f), staghorn(0.1f)};
  reef[3].look.branches.skin->kind = SkinKind::fan;
  shade(reef);
  ASSERT_EQ(reef[0].model.light.size(), 12u);
  EXPECT_LT(std::ranges::max(reef[0].model.light), 0.3f);
  EXPECT_TRUE(reef[2].model.light.empty()) << "too far away";
  EXPECT_TRUE(reef[3].model.light.empty()) << "a fan lives by what it catches";
}

}  // namespace
}  // namespace frond
