#include <gtest/gtest.h>

#include "scene/scene.h"
#include "scene/specimen_cache.h"

namespace frond {
namespace {

const ProgressSink kNobodyWatches{[](auto, auto) {}, [] {}};

Preset small_reef(const std::string& coral, const std::string& film = R"({"frames": 48, "fps": 12})") {
  Result<Preset> preset = read_preset(R"({"version": 2, "film": )" + film +
                                          R"(, "scene": {"setting": "underwater"},
      "organisms": [)" + coral + "]}",
                                      "reef.json", {});
  if (!preset) ADD_FAILURE() << preset.errors().front().text();
  return *preset;
}

constexpr std::string_view kBrain =
    R"({"kind": "massive", "name": "brain", "count": 3, "across": 0.2, "height": 0.12, "edge": 0.01)";
std::string brain_with(const std::string& more) { return std::string(kBrain) + more + "}"; }

Color color_of(const Specimen& s, double time) {
  return (*developed(s, time))->model.solids.shapes[0].material.color;
}

TEST(SceneHealth, OfOneChangesNothing) {
  Scene plain = *build_scene(small_reef(brain_with(""))),
        whole = *build_scene(small_reef(brain_with(R"(, "health": 1)")));
  for (std::size_t i = 0; i < plain.specimens.size(); ++i) {
    EXPECT_FALSE(whole.specimens[i].life.condition);
    EXPECT_EQ(plain.specimens[i].model.solids.position, whole.specimens[i].model.solids.position);
  }
}

TEST(SceneHealth, PalesAtItsTimeAndEachMomentByItself) {
  Scene scene = *build_scene(
      small_reef(brain_with(R"(, "health": {"at": [[0, 1], [2, 0.5], [4, 1]], "stagger": 0.5})")));
  const Specimen& s = scene.specimens[0];
  Color begin = color_of(s, 0), white = color_of(s, 2.4), again = color_of(s, 0);
  EXPECT_GT(white.blue, begin.blue + 0.1f);
  EXPECT_EQ(begin.red, again.red);
  EXPECT_NEAR(color_of(s, 9).blue, begin.blue, 1e-3f);
  EXPECT_NE(scene.specimens[0].life.condition->delay, scene.specimens[1].life.condition->delay);
}

TEST(SceneHealth, GrowsNothingAnew) {
  SpecimenCache cache;
  Scene first = *build_scene(small_reef(brain_with("")), kNobodyWatches, &cache);
  // What is reused shares nothing that could tell, but it grows in no time: a text of the same key.
  Scene ailing =
      *build_scene(small_reef(brain_with(R"(, "health": [[0, 1], [2, 0.4]])")), kNobodyWatches, &cache);
  Scene alone = *build_scene(small_reef(brain_with(R"(, "health": [[0, 1], [2, 0.4]])")));
  for (std::size_t i = 0; i < first.specimens.size(); ++i) {
    EXPECT_EQ(first.specimens[i].model.solids.shapes.size(), ailing.specimens[i].model.solids.shapes.size());
    if (first.specimens[i].entry == Specimen::kNoEntry) continue;
    EXPECT_EQ(color_of(ailing.specimens[i], 2).red, color_of(alone.specimens[i], 2).red);
    EXPECT_EQ(first.specimens[i].model.solids.shapes[0].surface.position,
              ailing.specimens[i].model.solids.shapes[0].surface.position);
  }
}

TEST(SceneHealth, PiecesOfAFlowerMoveAsOne) {
  for (const char* fares : {R"("health": {"at": 0, "sheds": 0.5})", R"("season": {"at": 0.98})"}) {
    Scene scene = *build_scene(*read_preset(
        R"({"film": {"frames": 24}, "scene": {"setting": "studio"}, "organisms": [{"kind": "plant", "height": 0.3,
            "place": {"lean": 0}, "grammar": {"axiom": "FF[~O(1, 1)]"}, "organs": [{"symbol": "O", "shape": "diagram", "size": 0.05,
              "diagram": {"whorls": [{"part": "sepals", "count": 5}, {"part": "petals", "count": 5}, {"part": "stamens", "count": 6},
                                     {"part": "carpels", "count": 1}]}}], )" +
            std::string(fares) + "}]}",
        "flower.json", {}));
    const Organs now = (*developed(scene.specimens[0], 0))->model.organs;
    ASSERT_GE(now.size(), 4u) << fares;
    for (std::size_t i = 1; i < now.size(); ++i) {
      EXPECT_EQ(now.position[i], now.position[0]) << fares;
      EXPECT_EQ(now.turn[i], now.turn[0]) << fares;
    }
  }
}

TEST(SceneHealth, IsForWhatLives) {
  Result<Preset> stone = read_preset(R"({"organisms": [{"kind": "rock", "health": 0.5}]})", "stone.json", {});
  ASSERT_FALSE(stone);
  EXPECT_NE(stone.errors().front().text().find("/organisms/0/health"), std::string::npos);
}

TEST(SceneGrowth, ARateNeedsThePaceOfTheFilm) {
  Result<Preset> none =
      read_preset(R"({"organisms": [{"kind": "coral", "growth": {"rate": 5}}]})", "rate.json", {});
  ASSERT_FALSE(none);
  EXPECT_NE(none.errors().front().text().find("/organisms/0/growth/rate"), std::string::npos);
}

/// How large a coral is at a time of a film, metres: along branches, or in height or radius.
double length_at(const Specimen& s, double time) {
  const double front = std::min(growth_front(s.motion.growth, time), 1.0);
  if (s.model.skeleton.size() > 1) {
    double longest = 0;
    for (std::size_t i = 0; i < s.model.skeleton.size(); ++i)
      if (static_cast<double>(s.model.skeleton.birth[i]) <= front)
        longest = std::max<double>(longest, s.model.skeleton.distance[i]);
    return longest;
  }
  Model then = s.model;
  then.solids = grown_to(s.model.solids, static_cast<float>(front));
  return static_cast<double>(length_of(then));
}

TEST(SceneGrowth, CoralsGrowAtTheirOwnRates) {
  Scene scene = *build_scene(small_reef(
      R"({"kind": "massive", "name": "mound", "across": 0.4, "height": 0.25, "edge": 0.012, "place": {"at": [[0, 0]], "rock": 0},
          "growth": {"rate": 1, "years_a_second": 5}},
         {"kind": "coral", "name": "staghorn", "form": "branching", "steps": 4, "height": 0.9, "place": {"at": [[1.5, 0]], "rock": 0},
          "growth": {"rate": 10, "years_a_second": 1}})"));
  std::size_t found = 0;
  for (const Specimen& s : scene.specimens) {
    if (s.entry == Specimen::kNoEntry || s.name.empty()) continue;
    ++found;
    const double rate = s.name == "mound" ? 0.01 * 5 : 0.1 * 1,
                 whole = static_cast<double>(length_of(s.model));
    // Bodies grow by layers, which are not all as thick: theirs is the mean rate.
    for (double share :
         s.name == "mound" ? std::vector<double>{} : std::vector<double>{0.3, 0.5, 0.75, 0.95}) {
      const double time = share * whole / rate;
      EXPECT_NEAR(length_at(s, time), rate * time, 0.05 * whole) << s.name << " at " << share;
    }
    EXPECT_NEAR(length_at(s, 1.01 * whole / rate), whole, 1e-4 * whole) << s.name;
    EXPECT_LT(length_at(s, 0.9 * whole / rate), whole) << s.name;
  }
  EXPECT_EQ(found, 2u);
}

}  // namespace
}  // namespace frond
