#include "organisms/plant/flower_organ.h"

#include <gtest/gtest.h>

#include <set>

#include "organisms/plant/organ_prototypes.h"

namespace frond {
namespace {

OrganParams flower(const std::string& symbol) {
  OrganParams organ;
  organ.symbol = symbol;
  organ.shape = OrganShape::diagram;
  organ.size = 0.02;
  organ.turn_variation = organ.size_variation = 0;
  FloralDiagram& d = organ.diagram.emplace();
  d.whorls.resize(4);
  d.whorls[0].part = FloralPart::sepals;
  d.whorls[1].falls = true;
  d.whorls[2].part = FloralPart::stamens;
  d.whorls[3].part = FloralPart::carpels;
  return organ;
}

OrganParams raceme(const std::string& symbol, const std::string& of, int flowers = 12) {
  OrganParams organ;
  organ.symbol = symbol;
  organ.shape = OrganShape::inflorescence;
  organ.size = 0.2;
  Inflorescence& by = organ.inflorescence.emplace();
  by.flower = of;
  by.flowers = flowers;
  return organ;
}

PlantParams plant(const std::string& axiom, std::vector<OrganParams> organs) {
  PlantParams p;
  p.grammar.axiom = axiom;
  p.grammar.steps = 1;
  p.smoothing = 1;
  p.organs = std::move(organs);
  return p;
}

Model flowering(const PlantParams& params, std::uint64_t seed = 7) {
  Result<Model> model = grow_plant(params, Seed{seed});
  EXPECT_TRUE(model.ok()) << (model ? "" : model.errors()[0].text());
  EXPECT_EQ(model->find_fault(), "");
  return *model;
}

TEST(FlowerOrgan, IsAllItsPiecesInOnePlace) {
  Model model = flowering(plant("F~W(1)", {flower("W")}));
  ASSERT_EQ(model.organs.size(), 5u) << "four whorls and the receptacle";
  std::set<std::uint16_t> shapes(model.organs.prototype.begin(), model.organs.prototype.end());
  EXPECT_EQ(shapes.size(), 5u);
  for (std::size_t i = 1; i < 5; ++i) {
    EXPECT_EQ(model.organs.position[i], model.organs.position[0]);
    EXPECT_EQ(model.organs.turn[i], model.organs.turn[0]);
    EXPECT_EQ(model.organs.id[i], model.organs.id[0]) << "it sways as one";
  }
}

TEST(FlowerOrgan, TakesItsStageFromTheGrammar) {
  auto reach = [](const std::string& axiom) {
    Model model = flowering(plant(axiom, {flower("W")}));
    float far = 0;
    for (std::uint16_t which : model.organs.prototype) far = std::max(far, reach_of(model.prototypes[which]));
    return std::pair{model.organs.size(), far};
  };
  EXPECT_EQ(reach("F~W(1)"), reach("F~W(1,1)")) << "without a stage it is open";
  EXPECT_EQ(reach("F~W"), reach("F~W(1,1,1)"));
  EXPECT_EQ(reach("F~W(1,0)"), reach("F~W(1,1,1,0)"));
  EXPECT_LT(reach("F~W(1,0)").second, 0.8f * reach("F~W(1,1)").second);
  EXPECT_EQ(reach("F~W(1,2)").first, 3u) << "petals have fallen, stamens shrivelled";
}

TEST(FlowerOrgan, StagesAreInOrder) {
  for (int n : {1, 2, 5, 8, 13}) {
    FloralDiagram d;
    d.stages = n;
    EXPECT_EQ(stage_index(d, 0), 0);
    EXPECT_EQ(stage_index(d, 1), n);
    EXPECT_EQ(stage_index(d, 2), stage_count(d) - 1);
    EXPECT_EQ(stage_index(d, -3), 0);
    EXPECT_EQ(stage_index(d, 9), stage_count(d) - 1);
    int before = 0;
    for (double stage = 0; stage <= 2; stage += 0.01) {
      EXPECT_GE(stage_index(d, stage), before);
      before = stage_index(d, stage);
    }
  }
}

TEST(FlowerOrgan, InflorescencesGrowOnTheirBranch) {
  PlantParams params = plant("F(0.1)F(0.1)~I(1)", {flower("W"), raceme("I", "W")});
  Model model = flowering(params);
  EXPECT_GT(model.skeleton.size(), 3u + 12u) << "an axis and stalks";
  EXPECT_GE(model.organs.size(), 12u * 4u);
  float first = 2;
  for (std::size_t i = 0; i < model.organs.size(); ++i) {
    ASSERT_GE(model.organs.node[i], 0);
    EXPECT_GT(model.organs.birth[i], 0.4f) << "it grows after the stem";
    first = std::min(first, model.organs.birth[i]);
    EXPECT_LT(glm::distance(model.organs.position[i],
                            model.skeleton.position[static_cast<std::size_t>(model.organs.node[i])]),
              1e-3f);
  }
  EXPECT_LT(first, 0.8f) << "from its foot on";
  // Twice as large by the grammar.
  params.grammar.axiom = "F(0.1)F(0.1)~I(2)";
  auto top = [](const Model& m) {
    float high = 0;
    for (Vec3 p : m.skeleton.position) high = std::max(high, p.y);
    return high - 0.2f;
  };
  EXPECT_GT(top(flowering(params)), 1.6f * top(model));
}

TEST(FlowerOrgan, InflorescencesMayBearOthers) {
  Model model = flowering(plant("F~I", {flower("W"), raceme("U", "W", 5), raceme("I", "U", 4)}));
  std::set<std::uint32_t> flowers(model.organs.id.begin(), model.organs.id.end());
  EXPECT_EQ(flowers.size(), 20u);
}

TEST(FlowerOrgan, IsTheSameForTheSameSeedAndChangesNoOther) {
  PlantParams params = plant("F[+F~W]~I", {flower("W"), raceme("I", "W")});
  params.organs[0].turn_variation = 0.3;
  Model a = flowering(params), b = flowering(params), c = flowering(params, 8);
  EXPECT_EQ(a.organs.position, b.organs.position);
  EXPECT_NE(a.organs.position, c.organs.position);
  // A leaf that comes before stays where it was.
  PlantParams without = plant("F[+F~W]", {params.organs[0]});
  EXPECT_EQ(flowering(without).organs.turn[0], a.organs.turn[0]);
}

TEST(FlowerOrgan, TellsWhatIsWrong) {
  std::vector<OrganParams> organs = {flower("W"), raceme("I", "V")};
  Errors unknown = flower_faults(organs, 1);
  ASSERT_EQ(unknown.size(), 1u);
  EXPECT_EQ(unknown[0].where, "/inflorescence/flower");
  EXPECT_NE(unknown[0].what.find("\"V\""), std::string::npos);
  organs[1].inflorescence->flower = "I";
  EXPECT_NE(flower_faults(organs, 1)[0].what.find("an inflorescence"), std::string::npos);
  organs[1].inflorescence->flower = "W";
  EXPECT_TRUE(flower_faults(organs, 1).empty());
  organs[1].inflorescence->flowers = 501;
  EXPECT_EQ(flower_faults(organs, 1)[0].where, "/inflorescence/flowers");
  organs[1].inflorescence->flowers = 500;
  organs.push_back(raceme("J", "I", 300));
  EXPECT_EQ(flower_faults(organs, 2)[0].what,
            "bears 150000 florets with what they bear; expected at most 100000");
  organs[0].diagram->whorls[2].marks.emplace();
  EXPECT_EQ(flower_faults(organs, 0)[0].where, "/diagram/whorls/2/marks");
  organs[0].diagram.reset();
  EXPECT_EQ(flower_faults(organs, 0)[0].where, "/diagram");
}

}  // namespace
}  // namespace frond
