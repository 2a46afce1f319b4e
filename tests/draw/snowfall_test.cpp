#include "draw/snowfall.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "draw/bough_snow.h"
#include "foliage/sprig.h"

namespace frond {
namespace {

/// One meadow for all tests, with a small bare tree and a plate on four posts, in the snowfall that is asked
/// for.
Scene& snowy_meadow(double falling, double wind = 0) {
  static Scene scene = [] {
    Result<Preset> preset = read_preset(
        R"({"film": {"frames": 49, "fps": 24, "size": [640, 360], "quality": "draft"}, "scene": {"setting": "meadow", "camera":
        {"location": [0, 1.6, 6], "look_at": [0, 1, 0]}, "meadow": {"blade": 0},
        "snow": {"depth": 0.1, "falling": 1, "shed": 1000}, "wind": {"speed": 3, "direction": [1, 0, 0]}},
        "organisms": [{"kind": "bridge", "name": "bridge", "length": 2.5, "width": 1, "height": 0.6, "place": {"at": [[2, 1]], "turn": 90}},
          {"kind": "colonized", "name": "tree", "envelope": {"shape": "ball", "base": 1, "height": 1.5, "width": 2},
           "colonize": {"attractors": 200, "kill": 0.25, "step": 0.1}, "season": {"at": 0.03}}]})",
        "test.json", {});
    if (!preset) ADD_FAILURE() << preset.errors().front().text();
    return *build_scene(*preset);
  }();
  scene.setup.snow.falling = falling;
  scene.setup.wind = wind > 0 ? std::optional(Wind{.speed = wind, .direction = {1, 0, 0}}) : std::nullopt;
  return scene;
}

Vec3 middle(const Streak& s) { return 0.5f * (s.top + s.bottom); }

bool same_flake(const Streak& a, const Streak& b) { return glm::distance(middle(a), middle(b)) < 1e-3f; }

TEST(SnowFlakes, AreMoreInHeavierSnowAndNoneInClearAir) {
  EXPECT_TRUE(snow_flakes(snowy_meadow(0), 0).empty());
  std::size_t few = snow_flakes(snowy_meadow(0.2), 0).size(), many = snow_flakes(snowy_meadow(2), 0).size();
  EXPECT_GT(few, 100u);
  EXPECT_GT(many, few);
  EXPECT_LT(many, 8000u);
}

TEST(SnowFlakes, ComeToWhereOthersWereWhenTheFilmRepeats) {
  const Scene& scene = snowy_meadow(1, 3);
  std::vector<Streak> first = snow_flakes(scene, 0), last = snow_flakes(scene, scene.film.length());
  ASSERT_GT(first.size(), 500u);
  EXPECT_NEAR(static_cast<double>(first.size()), static_cast<double>(last.size()), 5);
  std::size_t found = 0;
  for (const Streak& a : first)
    found += std::ranges::any_of(last, [&](const Streak& b) { return same_flake(a, b); });
  EXPECT_GT(found, first.size() * 99 / 100);
}

TEST(SnowFlakes, GoOnWhereTheyWereAndFallWithTheWind) {
  const Scene& scene = snowy_meadow(1, 3);
  constexpr double kMoment = 1e-4;
  std::vector<Streak> before = snow_flakes(scene, 0.5), after = snow_flakes(scene, 0.5 + kMoment);
  std::size_t found = 0;
  Vec3 moved(0);
  for (const Streak& a : before)
    for (const Streak& b : after)
      if (glm::distance(middle(a), middle(b)) < 6 * kMoment && std::abs(a.share - b.share) < 0.01f) {
        ++found, moved += middle(b) - middle(a);
        break;
      }
  EXPECT_GT(found, before.size() * 98 / 100);
  moved /= static_cast<float>(kMoment) * static_cast<float>(found);
  EXPECT_NEAR(moved.y, -1, 0.4);
  EXPECT_GT(moved.x, 0.8f);
}

TEST(SnowFlakes, KeepOutOfTheGroundAndOfBodies) {
  const Scene& scene = snowy_meadow(3);
  for (const Streak& s : snow_flakes(scene, 1)) {
    Vec3 at = middle(s);
    EXPECT_GT(static_cast<double>(at.y), scene.ground->heights()(at.x, at.z));
    EXPECT_FALSE(scene.overhead->shelters(at, {0, -1, 0}));
  }
}

const Specimen& tree_of(const Scene& scene) {
  return *std::ranges::find_if(scene.specimens, [](const Specimen& s) { return s.load != nullptr; });
}

double heaped(const Specimen& tree, double time) {
  DrawList drawn(tree, time);
  BoughSnow snow = bough_snow(drawn, time, 0.002);
  return area(snow.heaps) + area(snow.ridges);
}

TEST(SnowPowder, FallsWhereABoughHasDroppedItsSnowWhichIsThenBare) {
  const Scene& scene = snowy_meadow(1);
  const SnowLoad& load = *tree_of(scene).load;
  auto first = static_cast<double>(*std::ranges::min_element(load.drops));
  ASSERT_LT(first, 1.2) << "of so many boughs";
  EXPECT_TRUE(snow_powder(scene, first).empty());
  std::vector<Streak> powder = snow_powder(scene, first + 0.3);
  EXPECT_GT(powder.size(), 10u);
  for (std::size_t i = 0; i < load.bough.size(); ++i) {
    if (load.drops[static_cast<std::size_t>(load.bough[i])] > static_cast<float>(first)) continue;
    EXPECT_EQ(load.left(i, first), 1);
    EXPECT_NEAR(load.left(i, first + 0.01), 1, 0.01) << "it does not pop";
    EXPECT_EQ(load.left(i, first + 1), 0);
  }
  EXPECT_LT(heaped(tree_of(scene), 2), heaped(tree_of(scene), 0));
}

/// A branch of two metres that rises by so many degrees, and its load.
Specimen branch(double rises, float radius) {
  Specimen s;
  auto up = static_cast<float>(std::sin(radians(rises))), out = static_cast<float>(std::cos(radians(rises)));
  auto load = std::make_shared<SnowLoad>(SnowLoad{Animated<double>({{0, 0.1}, {1, 0}}), {}, {}, {1e9f}});
  for (int i = 0; i <= 20; ++i) {
    auto at = static_cast<float>(0.1 * i);
    s.model.skeleton.add({out * at, 2 + up * at, 0}, radius, i - 1, 0);
    load->share.push_back(1), load->bough.push_back(0);
  }
  set_tip_distances(s.model.skeleton);
  s.load = std::move(load);
  s.look.branches.bark.emplace();
  s.style.voxel = 0.01;
  return s;
}

double height_on(double rises, float radius, double time = 0) {
  Specimen s = branch(rises, radius);
  DrawList drawn(s, time);
  BoughSnow snow = bough_snow(drawn, time, 0.001);
  EXPECT_EQ(snow.heaps.find_fault(), "");
  double most = -1;
  for (Vec3 p : snow.heaps.position) most = std::max<double>(most, p.y - 2 - radius);
  return most;
}

TEST(BoughSnow, LiesOnWhatIsLevelAndNotOnWhatIsSteep) {
  EXPECT_GT(height_on(0, 0.03f), 0.04);
  EXPECT_LT(height_on(0, 0.03f), 0.1) << "less than on the ground";
  EXPECT_GT(height_on(0, 0.03f), height_on(0, 0.01f)) << "more on thicker ones";
  EXPECT_LT(heaped(branch(80, 0.03f), 0), 0.3 * heaped(branch(10, 0.03f), 0) + 1e-3);
}

TEST(BoughSnow, VanishesInTheWoodAsItMelts) {
  EXPECT_GT(height_on(0, 0.03f, 0.5), 0);
  EXPECT_LT(height_on(0, 0.03f, 0.99), 0);
}

/// Tufts on a level branch that bears twenty sprigs.
std::size_t tufts_on(SprigKind kind) {
  Specimen s = branch(0, 0.03f);
  OrganPart part;
  part.surface = sprig_surface({.kind = kind});
  s.model.prototypes = {{"sprig", {part}, {Color{0, 1, 0}}, Color{0, 1, 0}}};
  Organs& o = s.model.organs;
  for (std::int32_t i = 1; i <= 20; ++i) {
    auto node = static_cast<std::size_t>(i);
    o.prototype.push_back(0), o.position.push_back(s.model.skeleton.position[node]);
    o.turn.push_back(glm::angleAxis(1.2f, Vec3(1, 0, 0))), o.scale.push_back(Vec3(0.3f));
    o.node.push_back(i), o.birth.push_back(0), o.color.push_back(0), o.id.push_back(static_cast<unsigned>(i));
  }
  return bough_snow(DrawList(s, 0), 0, 0.001).tufts.size();
}

TEST(BoughSnow, TuftsLieOnNeedlesAndNotOnAFlatLeaf) {
  EXPECT_GE(tufts_on(SprigKind::needles), 10u);
  EXPECT_EQ(tufts_on(SprigKind::feather), 0u);
}

TEST(BoughSnow, FacesOutward) {
  Specimen s = branch(0, 0.03f);
  DrawList drawn(s, 0);
  BoughSnow snow = bough_snow(drawn, 0, 0.001);
  Vec3 sum(0);
  for (Vec3 n : snow.heaps.normal) sum += n;
  EXPECT_GT(sum.y, 0.2f * static_cast<float>(snow.heaps.normal.size()));
  Vec3 tuft(0);
  for (Vec3 n : tuft_surface().normal) tuft += n;
  EXPECT_GT(tuft.z, 0);
}

}  // namespace
}  // namespace frond
