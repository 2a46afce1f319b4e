#include "scene/furnish.h"

#include <gtest/gtest.h>

#include "plan/layout.h"
#include "scene/scene.h"
#include "settings/garden.h"
#include "settings/lawn.h"

namespace frond {
namespace {

/// Two beds of earth across a way, with lots for more of them.
Preset garden_of(const std::string& organisms, const std::string& setting = "garden", int seed = 1) {
  std::string text = R"({"film": {"frames": 1}, "seed": )" + std::to_string(seed) + R"(,
    "scene": {"setting": ")" +
                     setting + R"(", "meadow": {"blade": 0}, "floor": {"relief": 0.3}},
    "plan": {"size": [7, 7], "grammar": {"axiom": "F[+B][-B]FFW", "steps": 3,
               "rules": ["W ->(0.5) [+B(1,2)]FW", "W ->(0.5) [-B(2,1)]FW"]},
             "rooms": [{"symbol": "B", "name": "bed", "ground": "earth"}]},
    "organisms": [)" +
                     organisms + "]}";
  Result<Preset> preset = read_preset(text, "garden.json", {});
  EXPECT_TRUE(preset.ok()) << (preset ? "" : preset.errors()[0].text());
  return *preset;
}

std::vector<PlanSite> beds_of(const Preset& preset) {
  return sites_in(*preset.plan, *plan_of(*preset.plan), "bed");
}

bool holds(const PlanSite& site, Vec2 at) {
  auto c = static_cast<float>(std::cos(site.turn)), s = static_cast<float>(std::sin(site.turn));
  Vec2 away = at - site.at, own(c * away.x - s * away.y, s * away.x + c * away.y);
  return std::abs(own.x) <= site.size.x / 2 && std::abs(own.y) <= site.size.y / 2;
}

TEST(Furnish, RoomsHoldAsManyAsWereAskedForApart) {
  Preset preset = garden_of(
      R"({"kind": "vase", "count": 5, "place": {"in": "bed", "at": [[0.5, 0.25]], "spacing": 0.2}})");
  const Organism& vases = preset.organisms[0];
  std::vector<PlanSite> beds = beds_of(preset);
  ASSERT_EQ(vases.count, 5 * std::ssize(beds));
  for (std::size_t i = 0; i < vases.place.at.size(); ++i) {
    EXPECT_TRUE(holds(beds[i / 5], vases.place.at[i])) << i;
    EXPECT_EQ(vases.place.each[i].turn, beds[i / 5].turn);
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_GE(glm::distance(vases.place.at[k], vases.place.at[i]), 0.399f);
  }
  // The given place counts from the middle, z out of the room.
  const PlanSite& bed = beds[0];
  Vec2 out(static_cast<float>(std::sin(bed.turn)), static_cast<float>(std::cos(bed.turn)));
  EXPECT_NEAR(glm::dot(vases.place.at[0] - bed.at, out), 0.25, 1e-5);
}

TEST(Furnish, SownCopiesStandInTheirRoomsInAnySetting) {
  for (const char* setting : {"garden", "meadow"}) {
    Preset preset = garden_of(R"({"kind": "vase", "count": 9, "place": {"in": "bed"},
                                  "sown": {"models": 2, "where": {"radius": 0.15}}})",
                              setting);
    Scene scene = *build_scene(preset);
    std::vector<PlanSite> beds = beds_of(preset);
    const Copies& copies = scene.copy_sets.at(0).copies;
    ASSERT_EQ(std::ssize(copies.foot), 9 * std::ssize(beds)) << setting;
    for (std::size_t i = 0; i < copies.size(); ++i)
      EXPECT_TRUE(holds(beds[i / 9], {copies.foot[i].x, copies.foot[i].z})) << setting << " " << i;
  }
}

TEST(Furnish, WaysAreGravelAndBedsAreEarth) {
  Preset preset = garden_of(R"({"kind": "vase"})");
  Scene scene = *build_scene(preset);
  const auto& lawn = ground_as<Lawn>(*scene.ground);
  GroundPlan plan = *plan_of(*preset.plan);
  for (const PlanSite& way : way_sites(*preset.plan, plan))
    EXPECT_LT(lawn.plot().path_distance(way.at), -0.4);
  for (const PlanSite& bed : beds_of(preset)) EXPECT_LT(lawn.plot().earth_distance(bed.at), -0.4);
  EXPECT_GT(lawn.gravel_patches.size(), 20u);
  EXPECT_GT(lawn.earth_patches.size(), 20u);
  for (const Patch& patch : lawn.earth_patches)
    EXPECT_LT(lawn.plot().earth_distance({patch.at.x, patch.at.z}), 0);
}

/// One body of all walls, which follows the ground and is open at the gate.
TEST(Furnish, WallsRunAlongTheirLines) {
  Preset preset = garden_of(R"({"kind": "wall", "name": "wall", "height": 1, "place": {"along": "walls"}},
                               {"kind": "vase", "name": "pots", "place": {"along": "bed", "spacing": 0.3}})");
  Scene scene = *build_scene(preset);
  ASSERT_EQ(preset.organisms[0].count, 1);
  EXPECT_EQ(preset.organisms[0].place.lines.size(), 5u);
  const Surface& hull = scene.specimens.at(0).model.hull;
  Vec2 low(1e9f), high(-1e9f);
  for (const Vec3& p : hull.position) {
    low = glm::min(low, Vec2(p.x, p.z)), high = glm::max(high, Vec2(p.x, p.z));
    double over = static_cast<double>(p.y) - static_cast<double>(scene.ground->height({p.x, p.z}));
    EXPECT_LT(std::abs(over - 0.55), 1.1);
    EXPECT_FALSE(std::abs(p.x) < 0.6f && p.z > 0) << "in the gate";
  }
  // Seven cells of two metres, and half the thickness around, in the corners, too.
  EXPECT_NEAR(low.x, -7.12, 0.03);
  EXPECT_NEAR(high.y, 7.12, 0.03);
  // Others stand in rows, turned as the edges are.
  const Place& pots = preset.organisms[1].place;
  EXPECT_GT(pots.at.size(), 20u);
  EXPECT_EQ(pots.each.size(), pots.at.size());
}

TEST(Furnish, AnotherSeedIsAnotherPlan) {
  auto cells = [](int seed) {
    return plan_of(*garden_of(R"({"kind": "vase"})", "garden", seed).plan)->cells;
  };
  EXPECT_EQ(cells(5), cells(5));
  int others = 0;
  for (int seed = 1; seed < 9; ++seed) others += cells(seed) != cells(seed + 1);
  EXPECT_GE(others, 4);
}

}  // namespace
}  // namespace frond
