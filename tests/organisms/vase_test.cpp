#include "organisms/vase/vase.h"

#include <gtest/gtest.h>

#include "masonry/block.h"
#include "solidity.h"

namespace frond {
namespace {

VaseParams of_degree(int degree) {
  VaseParams params;
  params.shape.profile.clear();
  for (int i = 0; i <= degree; ++i)
    params.shape.profile.push_back({i % 2 == 0 ? 0.10 : 0.13, 0.3 * i / degree});
  return params;
}

TEST(VaseModel, IsTurnedWhereThatIsExactAndAMeshElsewhere) {
  for (int degree = 1; degree <= 20; ++degree) {
    VaseParams params = of_degree(degree);
    Result<Model> model = grow_vase(params, Seed{1});
    ASSERT_TRUE(model);
    EXPECT_EQ(model->find_fault(), "");
    EXPECT_EQ(model->solids.shapes[0].turned.empty(), degree > 3) << degree;
    // A mesh is there in any case, for whatever measures or exports.
    EXPECT_EQ(solidity(model->solids.shapes[0].surface).open, 0u);
    EXPECT_GT(volume(model->solids.shapes[0].surface), 0);
  }
}

TEST(VaseModel, ThePresetMayDecide) {
  VaseParams params = of_degree(3);
  params.form = VaseForm::mesh;
  EXPECT_TRUE(grow_vase(params, Seed{1})->solids.shapes[0].turned.empty());
  params = of_degree(9);
  params.form = VaseForm::turned;
  EXPECT_FALSE(grow_vase(params, Seed{1})->solids.shapes[0].turned.empty());
  params = of_degree(3);
  params.bands.emplace_back();
  EXPECT_TRUE(grow_vase(params, Seed{1})->solids.shapes[0].turned.empty()) << "bands need a mesh";
}

TEST(VaseModel, HoldsSoilWhereAsked) {
  VaseParams params = of_degree(4);
  EXPECT_EQ(grow_vase(params, Seed{1})->solids.size(), 1u);
  params.soil = 0.8;
  Model model = *grow_vase(params, Seed{1});
  ASSERT_EQ(model.solids.size(), 2u);
  EXPECT_EQ(model.solids.shapes[1].material.matter, Matter::soil);
  float top = 0, rim = 0;
  for (const Vec3& p : model.solids.shapes[1].surface.position) top = std::max(top, p.y);
  for (const Vec3& p : model.solids.shapes[0].surface.position) rim = std::max(rim, p.y);
  EXPECT_GT(top, 0.7f * rim);
  EXPECT_LT(top, 0.95f * rim);
}

TEST(VaseModel, SaysThatItsWallIsThinner) {
  VaseParams params;
  params.shape.wall = 0.2;
  Model model = *grow_vase(params, Seed{1});
  ASSERT_EQ(model.notes.size(), 1u);
  EXPECT_NE(model.notes[0].find("not 0.2"), std::string::npos) << model.notes[0];
}

TEST(VaseModel, ErrorsOfTheCurveAreErrorsOfTheVase) {
  VaseParams params;
  params.shape.profile = {{0.1, 1}, {0.1, 0}};
  EXPECT_FALSE(grow_vase(params, Seed{1}));
}

}  // namespace
}  // namespace frond
