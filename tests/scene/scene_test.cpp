#include "scene/scene.h"

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>

#include "core/files.h"
#include "core/parallel.h"
#include "land/ground.h"
#include "organisms/coral/coral.h"
#include "preset/json.h"
#include "settings/lawn.h"
#include "settings/underwater.h"

namespace frond {
namespace {

Preset preset_of(const std::string& text, const std::vector<std::string>& sets = {}) {
  Result<Preset> preset = read_preset(text, "test.json", sets);
  if (!preset) ADD_FAILURE() << preset.errors().front().text();
  return preset ? *preset : Preset{};
}

Preset preset_at(const std::string& path) { return preset_of(*read_file(FROND_ROOT "/" + path)); }

CoralParams coral(const Preset& preset, std::size_t i) {
  return grower_of<Holding<CoralParams>>(preset.organisms.at(i)).params;
}

TEST(Preset, LocalOrGlobal) {
  // C4: own value over the scene's, unless the scene's is forced.
  const std::string body = R"(
    "defaults": {"wave": {"amplitude": 10, "speed": 2}, "thickness": {"radius": 0.2}},
    "organisms": [{"kind": "coral", "wave": {"amplitude": 30}}, {"kind": "coral", "thickness": {"radius": 0.1}}]})";
  Preset own = preset_of("{" + body);
  EXPECT_NEAR(degrees(coral(own, 0).wave.amplitude), 30, 1e-9);
  EXPECT_NEAR(coral(own, 0).wave.speed, 2, 1e-9);
  EXPECT_NEAR(degrees(coral(own, 1).wave.amplitude), 10, 1e-9);
  EXPECT_NEAR(coral(own, 0).thickness.radius, 0.2, 1e-9);
  EXPECT_NEAR(coral(own, 1).thickness.radius, 0.1, 1e-9);

  Preset forced = preset_of(R"({"force": ["wave"],)" + body);
  EXPECT_NEAR(degrees(coral(forced, 0).wave.amplitude), 10, 1e-9);
  EXPECT_NEAR(coral(forced, 1).thickness.radius, 0.1, 1e-9);
}

TEST(Preset, EveryPropertyCanBeForced) {
  for (std::string name :
       {"steps", "pitch",       "roll",   "angle_jitter", "length_jitter", "internode",  "length_scale",
        "lift",  "width_scale", "height", "smoothing",    "thickness",     "distortion", "skin",
        "wave",  "food",        "growth", "form",         "place",         "count",      "grammar"})
    EXPECT_TRUE(
        read_preset(R"({"force": [")" + name + R"("], "organisms": [{"kind": "coral"}]})", "x", {}).ok())
        << name;
  EXPECT_FALSE(read_preset(R"({"force": ["wav"], "organisms": []})", "x", {}).ok());
}

TEST(Preset, TellsOfABrokenGrammarWhereItIs) {
  auto preset = read_preset(
      R"({"organisms": [{"kind": "coral", "form": "own", "grammar": {"axiom": "F["}}]})", "x.json", {});
  ASSERT_FALSE(preset.ok());
  EXPECT_EQ(preset.errors()[0].text(),
            "x.json:1:70: /organisms/0/grammar/axiom: column 2: this `[` is not closed; add a `]`; in `F[`");
}

TEST(Preset, RulesKnowWhereTheyStand) {
  Preset preset = preset_of(R"({"defaults": {"grammar": {"rules": ["F -> FF"]}},
 "organisms": [{"kind": "coral", "form": "own", "grammar": {"interpretation": [{"rule": "A -> F"}]}}]})");
  const GrammarText grammar = coral(preset, 0).grammar;
  EXPECT_EQ(grammar.rules.at(0).where, "test.json:1:37: /organisms/0/grammar/rules/0");
  EXPECT_EQ(grammar.interpretation.at(0).where, "test.json:2:80: /organisms/0/grammar/interpretation/0");
}

TEST(Preset, MistakesInRulesAreToldOnceByAFullPathToo) {
  auto first_of = [](const char* rule) {
    std::string text =
        R"({"organisms": [{"kind": "plant", "grammar": {"rules": [")" + std::string(rule) + "\"]}}]}";
    Result<Preset> preset = read_preset(text, "/home/x.json", {});
    return preset ? preset->notes.at(0).where : preset.errors().at(0).where;
  };
  for (const char* rule : {"F -> F[", "F -> F[+X]"})
    EXPECT_EQ(first_of(rule), "/home/x.json:1:56: /organisms/0/grammar/rules/0");
}

TEST(Preset, WarningsAreToldWithTheirPlace) {
  Preset preset = preset_of(R"({"organisms": [
  {"kind": "tree", "habit": {"branching_angle": 1.08}},
  {"kind": "coral", "pitch": 0.43},
  {"kind": "coral", "pitch": 1},
  {"kind": "plant", "grammar": {"rules": ["F -> F[+X]K"]}, "organs": [{"symbol": "K"}]}]})");
  ASSERT_EQ(preset.notes.size(), 3u);
  EXPECT_EQ(preset.notes[0].where, "test.json:2:49: /organisms/0/habit/branching_angle");
  EXPECT_NE(preset.notes[0].what.find("if radians were meant, write 61.9"), std::string::npos);
  EXPECT_EQ(preset.notes[1].where, "test.json:3:30: /organisms/1/pitch");
  EXPECT_EQ(
      preset.notes[2].text().find("test.json:5:43: /organisms/3/grammar/rules/0: column 9: `X` does nothing"),
      0u);
}

TEST(Preset, ShippedOnesRaiseNoWarnings) {
  int tried = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(FROND_ROOT "/presets")) {
    if (entry.path().extension() != ".json" || entry.path().parent_path().filename() == "grammars") continue;
    Result<Preset> preset = read_preset(*read_file(entry.path()), entry.path().string(), {});
    ASSERT_TRUE(preset.ok()) << preset.errors()[0].text();
    for (const Error& warning : preset->notes) ADD_FAILURE() << warning.text();
    ++tried;
  }
  EXPECT_GT(tried, 40);
}

TEST(Scene, TellsAsManyStepsAsItForetold) {
  for (const char* path :
       {"presets/ivy/brick_wall.json", "presets/thicket.json", "presets/garden/vases.json"}) {
    std::size_t estimate = 0;
    std::atomic<std::size_t> told = 0;
    ProgressSink watch{[&](std::string_view, std::size_t steps) { estimate += steps; }, [&] { ++told; }};
    ASSERT_TRUE(build_scene(preset_at(path), watch)) << path;
    EXPECT_EQ(told, estimate) << path;
  }
}

TEST(Scene, FindsRoomOnBodiesWithoutMoreOrFewerStepsThanForetold) {
  const std::string_view text = R"({"seed": 4, "scene": {"setting": "underwater"}, "organisms": [
      {"kind": "rock", "name": "rock", "count": 1, "place": {"at": [[0, 0]]}, "depth": 4},
      {"kind": "encrusting", "count": 12, "place": {"on": ["rock"], "spacing": SPACING}}]})";
  for (const char* spacing : {"0.01", "0.7"}) {  // room for all, and for few
    std::string own(text);
    own.replace(own.find("SPACING"), 7, spacing);
    Result<Preset> preset = read_preset(own, "test.json", {});
    ASSERT_TRUE(preset.ok()) << preset.errors()[0].text();
    std::size_t estimate = 0;
    std::atomic<std::size_t> told = 0;
    ProgressSink watch{[&](std::string_view, std::size_t steps) { estimate += steps; }, [&] { ++told; }};
    Result<Scene> scene = build_scene(*preset, watch);
    ASSERT_TRUE(scene.ok()) << scene.errors()[0].text();
    EXPECT_EQ(told, estimate) << spacing;
    EXPECT_EQ(std::string_view(spacing) == "0.7", !scene->notes.empty());
  }
}

TEST(Scene, IsTheSameAtAnyThreadCount) {
  Preset preset = preset_at("tests/presets/tiny_film.json");
  limit_threads(1);
  Scene one = *build_scene(preset);
  limit_threads(2);
  Scene two = *build_scene(preset);
  limit_threads(0);
  ASSERT_EQ(one.specimens.size(), two.specimens.size());
  for (std::size_t i = 0; i < one.specimens.size(); ++i)
    EXPECT_EQ(one.specimens[i].model.skeleton.position, two.specimens[i].model.skeleton.position);
}

TEST(Scene, GivesEachCoralAPhaseAndBrightnessOfItsOwn) {
  Scene scene = *build_scene(preset_at("tests/presets/tiny_film.json"));
  ASSERT_EQ(scene.specimens.size(), 2u);
  EXPECT_NE(scene.specimens[0].motion.wave.phase, scene.specimens[1].motion.wave.phase);
  EXPECT_NE(scene.specimens[0].brightness, scene.specimens[1].brightness);
}

TEST(Scene, EachMayStandTurnedAndAsLargeAsIsSaid) {
  auto scene = build_scene(preset_of(R"({"organisms": [{
    "kind": "plant", "count": 3, "grammar": {"axiom": "F + (90) F"},
    "place": {"at": [[0, 0], [5, 0], [9, 0]], "each": [{}, {"turn": 90, "size": 2}],
              "size_variation": 0, "turn_variation": 0, "lean": 0}}]})"));
  ASSERT_TRUE(scene);
  auto end = [&](std::size_t i) {
    const std::vector<Vec3>& nodes = scene->specimens[i].model.skeleton.position;
    return nodes.back() - nodes.front();
  };
  ASSERT_EQ(scene->specimens.size(), 3u);
  Vec3 turned = glm::angleAxis(static_cast<float>(kPi / 2), Vec3(0, 1, 0)) * end(0);
  EXPECT_LT(glm::distance(end(1), 2.0f * turned), 1e-4f);
  EXPECT_LT(glm::distance(end(2), end(0)), 1e-4f) << "those that have none stand as they were";
}

TEST(Scene, RootsEveryCoral) {
  // Nothing floats: the foot of each coral lies inside a stone or under the floor.
  Scene scene = *build_scene(preset_at("presets/thicket.json"));
  EXPECT_GE(scene.specimens.size(), 12u);
  for (const Specimen& b : scene.specimens) {
    Vec3 foot = b.model.skeleton.position[0];
    bool in_stone = false;
    for (const StoneInstance& stone : ground_as<SeaFloor>(*scene.ground).stone_instances) {
      float away = glm::length(Vec2(foot.x - stone.at.x, foot.z - stone.at.z));
      float top = stone.at.y + 0.7f * stone.size.y;
      in_stone = in_stone || (away < 1e-3f && foot.y < top && foot.y > stone.at.y);
    }
    EXPECT_TRUE(in_stone || foot.y < 0.3f) << b.name;
  }
}

TEST(Reef, HasNoJumps) {
  // Over the whole film: between two frames no node moves more than 8 times the film's mean motion.
  Scene scene = *build_scene(preset_at("presets/thicket.json"));
  for (const Specimen& b : scene.specimens) EXPECT_EQ(b.model.skeleton.find_fault(), "") << b.name;
  double total = 0, count = 0;
  float most = 0;
  std::string worst;
  for (const Specimen& b : scene.specimens) {
    Pose last, now;
    pose_skeleton(b.model.skeleton, b.motion, 0, last);
    for (int frame = 2; frame <= scene.film.frames; ++frame) {
      pose_skeleton(b.model.skeleton, b.motion, scene.film.time(frame), now);
      for (std::size_t i = 0; i < b.model.skeleton.size(); ++i) {
        float step = glm::distance(now.position[i], last.position[i]);
        total += step;
        count += 1;
        if (step > most) most = step, worst = b.name;
      }
      std::swap(last, now);
    }
  }
  EXPECT_LT(most, 8 * total / count) << "in " << worst << ", " << most << " m against " << total / count;
}

TEST(Schema, IsTheOneInDocs) {
  EXPECT_EQ(*read_file(FROND_ROOT "/docs/preset.schema.json"), serialize_pretty(preset_schema()));
}

TEST(Schema, NoKindDescribesWhatAllOfThemHave) {
  int kinds = 0;
  auto walk = [&](auto& self, const Value& v) -> void {
    const Value *common = v.find("properties"), *cases = v.find("allOf");
    for (std::size_t i = 0; common && cases && i < cases->items.size(); ++i, ++kinds)
      for (const Member& member : cases->items[i].find("then")->find("properties")->members)
        EXPECT_TRUE(member.value.is(Value::Type::boolean) || !common->find(member.name)) << member.name;
    for (const Value& item : v.items) self(self, item);
    for (const Member& member : v.members) self(self, member.value);
  };
  walk(walk, preset_schema());
  EXPECT_GT(kinds, 20);
}

TEST(Garden, GrowsNoGrassInPondAndPath) {
  const char* text = R"({"scene": {"setting": "garden", "meadow": {"blade": 0.08, "blades": 50, "extent": 7},
    "garden": {"pond": {"size": [3, 2]}, "path": {"points": [[-6, 4], [6, 3]]}, "lilies": 10}}})";
  Result<Preset> preset = read_preset(text, "garden.json", {});
  ASSERT_TRUE(preset.ok()) << preset.errors()[0].text();
  Scene scene = *build_scene(*preset);
  const auto& lawn_of = ground_as<Lawn>(*scene.ground);
  ASSERT_GT(lawn_of.turf_patches.size(), 500u);
  ASSERT_GT(lawn_of.gravel_patches.size(), 50u);
  double lawn = 0, gravel = 0;
  for (const Patch& patch : lawn_of.turf_patches) {
    Vec2 at(patch.at.x, patch.at.z);
    EXPECT_GT(lawn_of.plot().pond_distance(at), 0);
    EXPECT_GT(lawn_of.plot().path_distance(at), 0);
    double side = 0.4 / (1 << patch.shape / (kTurfShapes * kTurfMixtures));
    lawn += side * side;
  }
  for (const Patch& patch : lawn_of.gravel_patches) {
    EXPECT_LT(lawn_of.plot().path_distance(Vec2(patch.at.x, patch.at.z)), 0);
    double side = 0.5 / (1 << patch.shape / 4);
    gravel += side * side;
  }
  EXPECT_NEAR(gravel, 12 * 1.2, 3);
  EXPECT_NEAR(lawn, kPi * (49 - 6) - gravel, 9);
  EXPECT_EQ(scene.specimens[0].name, "water lilies");
}

TEST(Scene, PebblesLieOnTheGroundHoweverItRuns) {
  for (std::string setting : {"meadow", "underwater"}) {
    Scene scene = *build_scene(preset_of(R"({"seed": 3, "scene": {"setting": ")" + setting + R"(",
      "meadow": {"blades": 0}, "floor": {"relief": 0.8, "scale": 3, "stones": 0}},
      "organisms": [{"kind": "pebbles", "place": {"at": [[2, 1]], "lean": 30}, "radius": 3, "depth": 3}]})"));
    const Solids& s = scene.specimens.at(0).model.solids;
    ASSERT_GT(s.size(), 100u);
    const Heights& height = scene.ground->heights();
    float least = 1e9f, most = -1e9f;
    for (std::size_t i = 0; i < s.size(); ++i) {
      float ground = static_cast<float>(height(s.position[i].x, s.position[i].z));
      float high = 0;
      for (Vec3 p : s.shapes[s.shape[i]].surface.position) high = std::max(high, p.y * s.scale[i].y);
      EXPECT_LT(s.position[i].y, ground);
      EXPECT_GT(s.position[i].y + high, ground);
      least = std::min(least, ground), most = std::max(most, ground);
    }
    EXPECT_GT(most - least, 0.3f);  // it did run up and down
    const auto* sea = dynamic_cast<const SeaFloor*>(scene.ground.get());
    EXPECT_TRUE(!sea || sea->stone_instances.empty());
  }
}

TEST(Scene, IsWhatItPromises) {
  for (const char* name : {"presets/thicket", "presets/reef/chromis", "presets/species/corals/mushroom_coral",
                           "presets/asking/surface", "presets/bush", "presets/fused", "presets/garden/rocks",
                           "presets/garden/vases", "presets/garden/bridge", "presets/garden/guided_palm",
                           "presets/ivy/column", "presets/trees/poplar", "presets/forest/fern",
                           "presets/aspen", "presets/heart_tree", "presets/lsystems/growing-tree-2.6"}) {
    std::string path = std::string(FROND_ROOT "/") + name + ".json";
    Result<Preset> preset = read_preset(*read_file(path), path, {});
    ASSERT_TRUE(preset.ok()) << preset.errors()[0].text();
    Result<Scene> scene = build_scene(*preset);
    ASSERT_TRUE(scene.ok()) << scene.errors()[0].text();
    EXPECT_EQ(scene->find_fault(), "") << name;
    // What becomes another shape over the film is sound in the middle of it, too.
    for (const Specimen& s : scene->specimens) {
      if (!s.life.changes()) continue;
      auto now = developed(s, scene->film.length() / 2);
      ASSERT_TRUE(now.ok()) << now.errors()[0].text();
      EXPECT_EQ((*now)->model.find_fault(), "") << name;
    }
  }
}

/// What only growing finds is told at its place, as all else.
TEST(Scene, TellsWhereWhatCannotGrowStandsInThePreset) {
  auto said = [](const std::string& ivy) {
    Result<Scene> scene = build_scene(preset_of(R"({"scene": {"setting": "meadow"}, "organisms": [
 {"kind": "tree", "name": "tree", "years": 2},
 {"kind": "wall", "name": "wall"},
 {"kind": "ivy", "name": "vine", )" + ivy + "}]}"));
    return scene ? std::string() : scene.errors().front().text();
  };
  EXPECT_EQ(said(R"("on": ["wall"])"), "");
  std::string box = said(R"("on": ["wall"], "crawl": {"low": [50, 0, 50], "high": [60, 9, 60]})");
  EXPECT_TRUE(box.starts_with("test.json:4:59: /organisms/2/crawl: its box, from low to high, misses"))
      << box;
  std::string bare = said(R"("on": ["tree"])");
  EXPECT_TRUE(bare.starts_with("test.json:4:40: /organisms/2/on: nothing stands here of \"tree\"")) << bare;
}

}  // namespace
}  // namespace frond
