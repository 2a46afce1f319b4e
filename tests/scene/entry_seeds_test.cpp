// What hangs on which seed: organisms and the order that a preset lists them in.
#include "scene/entry_seeds.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "grove/dates.h"
#include "scene/scene.h"
#include "scene/specimen_cache.h"

namespace frond {
namespace {

constexpr const char* kGrammar = R"("grammar": {"axiom": "F", "steps": 3, "rules": ["F -> F[+F]F"]})";

/// A meadow in which some of each kind have names; `front` and `behind` are entries before and after them.
Preset meadow(int version, std::string front = "", std::string behind = "") {
  if (!front.empty()) front += ", ";
  if (!behind.empty()) behind.insert(0, ", ");
  Result<Preset> preset = read_preset(fmt::format(
                                          R"({{"version": {}, "seed": 3, "film": {{"frames": 8}},
        "scene": {{"setting": "meadow", "year": [[0, 0.1], [0.5, 0.9]],
                   "snow": {{"depth": [[0, 0.2], [0.5, 0.05]]}}}},
        "organisms": [{}
          {{"kind": "plant", "name": "weed", "count": 3, "height": 1, "place": {{"radius": 3}}, {}}},
          {{"kind": "plant", "height": 1, "place": {{"at": [[5, 0]]}}, {}}},
          {{"kind": "rock", "name": "stone", "place": {{"at": [[6, 4]]}}}},
          {{"kind": "rock", "place": {{"at": [[-6, 4]]}}}},
          {{"kind": "plant", "name": "herb", "count": 20, "height": 0.3, "place": {{"radius": 8}},
           "sown": {{"models": 2, "where": {{"radius": 0.3}}, "present": [0.2, 0.7]}}, {}}}{}
        ]}})",
                                          version, front, kGrammar, kGrammar, kGrammar, behind),
                                      "meadow", {});
  if (!preset) ADD_FAILURE() << preset.errors()[0].text();
  return preset ? *preset : Preset{};
}

Scene grown(const Preset& preset, SpecimenCache* cache = nullptr) {
  Result<Scene> scene = build_scene(preset, {[](auto, auto) {}, [] {}}, cache);
  if (!scene) ADD_FAILURE() << scene.errors()[0].text();
  return scene ? std::move(*scene) : Scene{};
}

/// All that a specimen is, where it stands and how it moves.
std::string text_of(const Specimen& s) {
  std::string text = fmt::format("{} {} {} {}", s.brightness, s.motion.growth.start, s.motion.wave.phase,
                                 s.life.season_seed.key);
  for (Vec3 p : s.model.skeleton.position) text += fmt::format(" {} {} {}", p.x, p.y, p.z);
  for (Vec3 p : s.model.solids.position) text += fmt::format(" {} {} {}", p.x, p.y, p.z);
  if (s.load)
    for (float drop : s.load->drops) text += fmt::format(" {} {}", drop, s.load->powder.key);
  return text;
}

/// What stands of each kind and name, in the order of the scene. What lies as snow is left out, as it lies on
/// all of them.
std::map<std::string, std::vector<std::string>> members(const Preset& preset, const Scene& scene) {
  std::map<std::string, std::vector<std::string>> all;
  auto called = [&](std::size_t entry) {
    const Organism& o = preset.organisms[entry];
    return o.name.empty() ? std::string("unnamed ") + typeid(*o.grower).name() : o.name;
  };
  for (const Specimen& s : scene.specimens)
    if (s.entry != Specimen::kNoEntry) all[called(s.entry)].push_back(text_of(s));
  for (const CopySet& set : scene.copy_sets)
    for (std::size_t i = 0; i < set.copies.size(); ++i)
      all[called(set.entry)].push_back(fmt::format(
          "{} {} {} {} {} {} {}", set.copies.model[i], set.copies.foot[i].x, set.copies.foot[i].z,
          set.copies.turn[i].y, set.copies.tint[i], set.copies.span[i].begin, set.copies.span[i].end));
  return all;
}

constexpr const char* kFarOff = R"({"kind": "vase", "name": "new", "place": {"at": [[14, 14]]}})";

TEST(EntrySeeds, OneMoreInFrontLeavesEveryOtherAsItGrew) {
  Preset before = meadow(2), after = meadow(2, kFarOff);
  auto old = members(before, grown(before)), now = members(after, grown(after));
  EXPECT_EQ(now.erase("new"), 1u);
  ASSERT_EQ(old.size(), 5u);
  EXPECT_EQ(old, now);
}

TEST(EntrySeeds, AnotherOrderLeavesEveryOneAsItGrew) {
  Preset first = meadow(2, kFarOff), last = meadow(2, "", kFarOff);
  EXPECT_EQ(members(first, grown(first)), members(last, grown(last)));
}

TEST(EntrySeeds, PresetsWithoutAVersionKeepTheirSeeds) {
  EXPECT_EQ(read_preset(R"({"organisms": []})", "old", {})->version, 1);
  Preset old = meadow(1);
  std::vector<Seed> seeds = entry_seeds(old, "organism");
  for (std::size_t o = 0; o < seeds.size(); ++o)
    EXPECT_EQ(seeds[o].key, (Seed{3}.child("organism", o).key)) << o;
  Preset more = meadow(1, kFarOff);
  EXPECT_NE(members(old, grown(old)).at("weed"), members(more, grown(more)).at("weed"));
}

TEST(EntrySeeds, ThoseWithoutANameCountAmongTheirLikeAlone) {
  std::string plant = fmt::format(R"({{"kind": "plant", "place": {{"at": [[14, 0]]}}, {}}})", kGrammar);
  Preset before = meadow(2), after = meadow(2, plant);
  std::vector<Seed> old = entry_seeds(before, "organism"), now = entry_seeds(after, "organism");
  EXPECT_EQ(now[0].key, old[1].key) << "the first plant without a name";
  EXPECT_NE(now[2].key, old[1].key) << "is now the second";
  for (std::size_t o : {0u, 2u, 3u, 4u}) EXPECT_EQ(now[o + 1].key, old[o].key) << o;
}

TEST(EntrySeeds, ThoseOfOneNameDiffer) {
  Preset twins = meadow(2, kFarOff, R"({"kind": "vase", "name": "new", "place": {"at": [[-14, 14]]}})");
  std::vector<Seed> seeds = entry_seeds(twins, "organism");
  EXPECT_NE(seeds.front().key, seeds.back().key);
}

TEST(EntrySeeds, WhoTakesTheRoomOfOneLeavesTheOthersThere) {
  Preset before = meadow(2);
  auto old = members(before, grown(before)).at("weed");
  // Where the first of the weeds stands.
  Vec3 foot;
  for (const Specimen& s : grown(before).specimens)
    if (s.name == "weed") {
      foot = s.placement.foot;
      break;
    }
  Preset after = meadow(
      2, fmt::format(R"({{"kind": "vase", "name": "new", "height": 0.1, "place": {{"at": [[{}, {}]]}}}})",
                     foot.x, foot.z));
  auto now = members(after, grown(after)).at("weed");
  ASSERT_EQ(now.size(), old.size());
  EXPECT_NE(now[0], old[0]);
  EXPECT_EQ(now[1], old[1]);
  EXPECT_EQ(now[2], old[2]);
}

TEST(EntrySeeds, OneMoreInFrontGrowsNothingOfTheOthersAgain) {
  SpecimenCache cache;
  grown(meadow(2), &cache);
  Preset after = meadow(2, kFarOff);
  Scene scene = grown(after, &cache);
  EXPECT_EQ(scene.grown, std::vector<std::size_t>{0});
  EXPECT_EQ(members(after, scene), members(after, grown(after)));
}

TEST(EntrySeeds, TheSameTreesAreFelledWhenOneMoreStandsInFront) {
  Dates dates{{{9, {.year = 10, .storm = 0, .cut = Cut{"", 0.5, true}, .prune = {}}}}, {}};
  std::vector<FellingTree> trees;
  for (std::uint64_t i = 0; i < 12; ++i) trees.push_back({"oak", Seed{i}, true});
  auto old = felled_in(dates, 9, trees, Seed{1});
  trees.insert(trees.begin(), FellingTree{"oak", Seed{99}, false});
  auto now = felled_in(dates, 9, trees, Seed{1});
  EXPECT_TRUE(std::equal(old.begin(), old.end(), now.begin() + 1));
  EXPECT_EQ(std::ranges::count(old, 1), 6);
}

}  // namespace
}  // namespace frond
