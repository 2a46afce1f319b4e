#include "organisms/plant/cpfg_plant.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace frond {
namespace {

/// A model in a folder, which is removed again.
class CpfgPlant : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / ("frond_cpfg_plant" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
    write("m.v", "angle increment: 90\ninitial line width: 0.2 cylinders\nsurface: l leaf.s 1\n");
    write("leaf.s",
          "0 1 0 1 0 0\nSIZE: 1\nleaf\n0 0 0 0.3 0 0 0.7 0 0 1 0 0\n0 0.3 0 0.3 0.3 0 0.7 0.3 0 1 0.3 0\n"
          "0 0.7 0 0.3 0.7 0 0.7 0.7 0 1 0.7 0\n0 1 0 0.3 1 0 0.7 1 0 1 1 0\n");
    grammar("derivation length: 3\nAxiom: A\nA --> F(2)[+~l(2)][{.f-f-f.}]A\n");
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }
  void grammar(const std::string& lines) const { write("m.l", "Lsystem: 1\n" + lines + "endlsystem\n"); }

  PlantParams plant() const {
    PlantParams params;
    std::ifstream file(folder_ / "m.l");
    NamedFile named{folder_ / "m.l", std::string(std::istreambuf_iterator<char>(file), {})};
    Errors errors = load_cpfg(named, params.grammar);
    EXPECT_TRUE(errors.empty()) << errors[0].what;
    use_model_colors(params);
    use_model_surfaces(params);
    params.smoothing = 1;
    params.height = 0.6;
    return params;
  }
  static Model grown(const PlantParams& params, double share = 1) {
    Result<Model> model = grow_plant(params, Seed{7}, share);
    EXPECT_TRUE(model.ok()) << (model ? "" : model.errors()[0].text());
    EXPECT_EQ(model->find_fault(), "");
    return *model;
  }

 private:
  std::filesystem::path folder_;
};

TEST_F(CpfgPlant, FiguresBecomeBranchesOrgansAndBlades) {
  PlantParams params = plant();
  EXPECT_EQ(params.grammar.steps, 3);
  Model model = grown(params);
  EXPECT_EQ(model.skeleton.size(), 4U);
  EXPECT_EQ(model.blades.size(), 3U);
  ASSERT_EQ(model.organs.size(), 3U);
  EXPECT_NEAR(model.organs.scale[0].y, 2 * 0.6f / 7, 1e-5f);  // the last outline ends at 7
  EXPECT_EQ(model.color[1], 128);
  EXPECT_EQ(params.bark.colors.size(), 256U);
}

TEST_F(CpfgPlant, SurfacesLieAsTheTurtleSays) {
  grammar("Axiom: ~l(1)F(4)\nA --> A\n");
  Model model = grown(plant());
  ASSERT_EQ(model.organs.size(), 1U);
  // x of the file lies along left, which is -x; 4 and the line's radius are 0.6 m.
  Vec3 corner(0);
  for (const Vec3& p : model.prototypes[model.organs.prototype[0]].parts[0].surface.position) {
    Vec3 at = model.organs.position[0] + model.organs.turn[0] * (model.organs.scale[0] * p);
    if (glm::length(at) > glm::length(corner)) corner = at;
  }
  EXPECT_NEAR(corner.x, -0.6f / 4.1f, 1e-5f);
  EXPECT_NEAR(corner.y, 0.6f / 4.1f, 1e-5f);
}

TEST_F(CpfgPlant, NegativeFactorsMirrorSurfaces) {
  auto farthest = [](const std::vector<Vec3>& points) {
    return *std::ranges::max_element(points, {}, [](const Vec3& p) { return glm::length(p); });
  };
  grammar("Axiom: ~l(-1,1,1)F(4)\nA --> A\n");
  Model mirrored = grown(plant());
  EXPECT_EQ(mirrored.organs.size(), 0U);
  ASSERT_EQ(mirrored.blades.size(), 1U);
  Vec3 corner = farthest(mirrored.blades.surface.position);
  EXPECT_NEAR(corner.x, 0.6f / 4.1f, 1e-5f);
  EXPECT_NEAR(corner.y, 0.6f / 4.1f, 1e-5f);
  // Two mirrors are a half turn, and stay an organ.
  grammar("Axiom: ~l(-1,-1,1)F(4)\nA --> A\n");
  Model turned = grown(plant());
  ASSERT_EQ(turned.organs.size(), 1U);
  std::vector<Vec3> points = turned.prototypes[turned.organs.prototype[0]].parts[0].surface.position;
  for (Vec3& p : points) p = turned.organs.turn[0] * (turned.organs.scale[0] * p);
  corner = farthest(points);
  EXPECT_GT(corner.x, 0);
  EXPECT_LT(corner.y, 0);
}

TEST_F(CpfgPlant, OrgansOfThePresetStandAtItsSurfaces) {
  PlantParams params = plant();
  params.organs.clear();
  params.organs.emplace_back().symbol = "l";
  use_model_surfaces(params);
  ASSERT_EQ(params.organs.size(), 1U);
  EXPECT_EQ(params.organs[0].shape, OrganShape::leaf);
  EXPECT_TRUE(cpfg_faults(params).empty());
  params.organs[0].symbol = "x";
  ASSERT_EQ(cpfg_faults(params).size(), 1U);
  EXPECT_EQ(cpfg_faults(params)[0].text(), "/organs/0/symbol: the view of the model has no surface \"x\"");
}

TEST_F(CpfgPlant, WhatTheModelSaysItselfIsRefused) {
  PlantParams params = plant();
  params.grammar.angle = 30;
  ASSERT_EQ(cpfg_faults(params).size(), 1U);
  EXPECT_EQ(cpfg_faults(params)[0].text(),
            "/grammar: a model of cpfg has all else in its own files; expected `file`, `steps`, `limits` and "
            "`vary` alone");
  params = plant();
  params.grammar.limits.modules = 10;
  ASSERT_EQ(cpfg_faults(params).size(), 1U);
  EXPECT_EQ(cpfg_faults(params)[0].text(),
            "/grammar/steps: step 1: the word has more than 10 modules and parameters");
}

TEST_F(CpfgPlant, EachPlantHasItsOwnChancesWhereItVaries) {
  grammar("Axiom: F(1+ran(1))[+F(ran(2))]F(ran(3))\nA --> A\n");
  PlantParams params = plant();
  auto branch = [&](Seed seed) {
    Result<Model> model = grow_plant(params, seed, 1);
    return model.ok() ? model->skeleton.position.at(2) : Vec3(0);
  };
  EXPECT_EQ(branch(Seed{1}), branch(Seed{2}));
  params.grammar.vary = true;
  EXPECT_NE(branch(Seed{1}), branch(Seed{2}));
  EXPECT_EQ(branch(Seed{1}), branch(Seed{1}));
}

TEST_F(CpfgPlant, GrowsBySteps) {
  PlantParams params = plant();
  params.by_steps = true;
  EXPECT_EQ(grown(params, 1.0 / 3).skeleton.size(), 2U);
  // The animation's last step is shorter than the others.
  write("m.a", "step: 2\n");
  params.grammar.cpfg = plant().grammar.cpfg;
  EXPECT_EQ(grown(params).skeleton.size(), 4U);
  EXPECT_EQ(grown(params, 2.0 / 3).skeleton.size(), 3U);
  Model early = grown(params, 0.5), late = grown(params, 0.51);
  ASSERT_EQ(early.skeleton.size(), late.skeleton.size());
  EXPECT_LT(glm::distance(early.skeleton.position.back(), late.skeleton.position.back()), 0.02f);
  EXPECT_LT(early.skeleton.position.back().y, late.skeleton.position.back().y);
}

}  // namespace
}  // namespace frond
