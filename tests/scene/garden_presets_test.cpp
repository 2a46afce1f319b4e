#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "core/files.h"
#include "organisms/plant/plant.h"
#include "scene/preset.h"
#include "settings/garden.h"
#include "settings/settings.h"

namespace frond {
namespace {

const std::string kFolder = std::string(FROND_ROOT) + "/presets/garden/";

/// The plants of a preset of the garden, with the files that they name.
std::vector<PlantParams> plants_of(const std::string& name) {
  std::string path = kFolder + name + ".json";
  Result<Preset> preset = read_preset(*read_file(path), path, {});
  EXPECT_TRUE(preset.ok()) << (preset ? "" : preset.errors()[0].text());
  std::vector<PlantParams> plants;
  for (const Organism& organism : preset->organisms)
    if (const auto* plant = dynamic_cast<const Holding<PlantParams>*>(organism.grower.get()))
      plants.push_back(plant->params);
  return plants;
}

Model grown(const PlantParams& plant) {
  Result<Model> model = grow_plant(plant, Seed{3});
  EXPECT_TRUE(model.ok()) << (model ? "" : model.errors()[0].text());
  EXPECT_EQ(model->find_fault(), "");
  return *model;
}

double nearest(const Skeleton& skeleton, DVec3 to) {
  double least = 1e9;
  for (const Vec3& p : skeleton.position) least = std::min(least, glm::distance(DVec3(p), to));
  return least;
}

std::vector<std::string> texts(const std::vector<GrammarText::Rule>& rules) {
  std::vector<std::string> list;
  for (const auto& rule : rules) list.push_back(rule.text);
  return list;
}

TEST(GardenPresets, BushByItsRulesWithBothKindsOfFlowers) {
  PlantParams bush = plants_of("bush").at(0);
  EXPECT_EQ(
      texts(bush.grammar.rules),
      (std::vector<std::string>{"A ->(0.34) [&FLA]/////[&FLA]///////[FBA]",
                                "A ->(0.33) [&LA]/////[&FLA]///////[FBA]", "A ->(0.33) [&FLA]/////[&LA]",
                                "F -> S/////F", "S -> FL", "L -> [^^{-f+f+f-|-f+f+f}]", "B -> [-Fb]"}));
  EXPECT_EQ(bush.grammar.steps, 7);
  EXPECT_EQ(bush.grammar.angle, 22.5);
  EXPECT_EQ(bush.grammar.length, 0.5);
  EXPECT_EQ(bush.grammar.width, 0.2);
  Model model = grown(bush);
  EXPECT_GT(model.blades.size(), 100u);
  std::set<std::uint16_t> flowers(model.organs.prototype.begin(), model.organs.prototype.end());
  EXPECT_EQ(flowers.size(), 2u);
  EXPECT_NE(grow_plant(bush, Seed{4})->skeleton.size(), model.skeleton.size());  // never the same twice
}

TEST(GardenPresets, TreesOfAllFourSets) {
  std::vector<PlantParams> trees = plants_of("tree");
  ASSERT_EQ(trees.size(), 4u);
  std::vector<std::vector<double>> sets;
  for (const PlantParams& tree : trees) {
    std::vector<double> set;
    for (const char* name : {"r1", "r2", "a0", "a2", "d", "wr"})
      for (const auto& [key, value] : tree.grammar.constants)
        if (key == name) set.push_back(std::stod(value));
    sets.push_back(set);
    EXPECT_GT(grown(tree).organs.size(), 500u);
  }
  EXPECT_EQ(sets, (std::vector<std::vector<double>>{{0.9, 0.6, 45, 45, 137.5, 0.707},
                                                    {0.9, 0.9, 45, 45, 137.5, 0.707},
                                                    {0.9, 0.8, 45, 45, 137.5, 0.707},
                                                    {0.9, 0.7, 30, -30, 137.5, 0.707}}));
}

TEST(GardenPresets, PalmHasFrondsOfManyLeafletsAndABentTrunk) {
  PlantParams palm = plants_of("palm").at(0);
  EXPECT_EQ(palm.bark.kind, BarkKind::palm);
  Model model = grown(palm);
  std::size_t fronds = 0;
  for (std::uint16_t which : model.organs.prototype) fronds += model.prototypes[which].name == "K";
  EXPECT_GE(fronds, 20u);
  std::size_t trunk = 0;  // the node that most is above of: the top of the trunk lies aside of its foot
  for (std::size_t i = 0; i < model.skeleton.size(); ++i)
    if (model.skeleton.position[i].y > model.skeleton.position[trunk].y) trunk = i;
  EXPECT_GT(std::hypot(model.skeleton.position[trunk].x, model.skeleton.position[trunk].z), 0.5);
  EXPECT_GT(model.skeleton.position[trunk].y, 3.0);
}

TEST(GardenPresets, FrondsOfAPalmFollowTheRulesOfTheirGrammar) {
  PlantParams palm = plants_of("grammar_palm").at(0);
  EXPECT_EQ(texts(palm.organs.at(0).grammar->rules),
            (std::vector<std::string>{"L ->(0.33) &&F[+++F][---F]l", "L ->(0.33) F[+++F][---F]l",
                                      "L ->(0.34) ^^^l", "l -> &F[+++F][---F]l"}));
  Model model = grown(palm);
  std::set<std::size_t> leaflets;
  for (std::uint16_t which : model.organs.prototype) {
    const Prototype& frond = model.prototypes[which];
    if (frond.name != "L") continue;
    ASSERT_EQ(frond.parts.size(), 2u);  // leaflets and their stem
    leaflets.insert(frond.parts[0].surface.position.size() / 18);
  }
  EXPECT_GE(model.organs.size(), 20u);
  EXPECT_EQ(leaflets, (std::set<std::size_t>{96, 112}));  // eight for each of six or seven pairs
}

TEST(GardenPresets, GuidedPalmPassesEachPointOfItsCurve) {
  PlantParams palm = plants_of("guided_palm").at(0);
  const GuideText& guide = palm.grammar.guide;
  ASSERT_EQ(guide.bezier, (std::vector<DVec3>{{0, 0, 0}, {5, 0, 0}, {5, 5, 0}, {0, 5, 0}}));
  Model model = grown(palm);
  for (int i = 0; i <= guide.samples; ++i) {
    DVec3 point = bezier_point(guide.bezier, static_cast<double>(i) / guide.samples);
    EXPECT_LE(nearest(model.skeleton, point), guide.tolerance) << i;
  }
}

TEST(GardenPresets, GuidedBushHasABranchAtEachLeafPoint) {
  PlantParams pear = plants_of("guided_bush").at(0);
  Guide guide = *guide_of(pear.grammar.guide);
  Model model = grown(pear);
  EXPECT_EQ(guide.leaves(), 8u);
  for (std::size_t i = 0; i < guide.points.size(); ++i) {
    if (!guide.children(static_cast<std::int32_t>(i)).empty()) continue;
    EXPECT_LE(nearest(model.skeleton, guide.points[i].at), guide.tolerance) << i;
  }
  // Without its guide it comes to few of them.
  pear.grammar.guide = {};
  Model wild = grown(pear);
  int missed = 0;
  for (const GuidePoint& point : guide.points) missed += nearest(wild.skeleton, point.at) > 0.1;
  EXPECT_GT(missed, 100);
}

TEST(GardenPresets, CrocusesOpenASixfoldFlowerAndTreesInTheWindAreAllFour) {
  PlantParams crocus = plants_of("../lsystems/crocus-3").at(0);
  Model model = grown(crocus);
  std::map<std::string, int> organs;
  for (std::uint16_t which : model.organs.prototype) ++organs[model.prototypes[which].name];
  EXPECT_EQ(organs["W"], 6);  // petals
  EXPECT_EQ(organs["V"], 6);  // leaves
  std::vector<double> first_turn;
  for (const PlantParams& tree : plants_of("../lsystems/trees-2.8"))
    first_turn.push_back(std::stod(tree.grammar.constants.at(0).second));
  EXPECT_EQ(first_turn, (std::vector<double>{94.74, 137.5, 112.5, 180}));
}

TEST(GardenPresets, TheGardenHasAllOfIt) {
  std::string path = kFolder + "garden.json";
  Result<Preset> preset = read_preset(*read_file(path), path, {});
  ASSERT_TRUE(preset.ok()) << preset.errors()[0].text();
  EXPECT_EQ(settings()[preset->setup.setting].name, "garden");
  EXPECT_GT(preset->setup.block<Garden>().pond.size.x, 1);
  EXPECT_GE(preset->setup.block<Garden>().path.points.size(), 2u);
  EXPECT_FALSE(preset->setup.camera.location.constant());
  std::multiset<std::string> names;
  for (const Organism& organism : preset->organisms)
    for (int i = 0; i < organism.count; ++i) names.insert(organism.name);
  for (const char* name :
       {"bridge", "boulders", "wall", "ivy", "bush", "tree", "tree behind", "palm", "pots", "agaves"})
    EXPECT_GE(names.count(name), 1u) << name;
  // What is planted in the pots stands where they stand.
  std::vector<Vec2> pots, agaves;
  for (const Organism& organism : preset->organisms) {
    if (organism.name == "pots") pots = organism.place.at;
    if (organism.name == "agaves") agaves = organism.place.at;
  }
  EXPECT_EQ(pots, agaves);
}

}  // namespace
}  // namespace frond
