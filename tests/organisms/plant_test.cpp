#include "organisms/plant/plant.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "geometry/outline.h"
#include "geometry/polygon.h"

namespace frond {
namespace {

PlantParams herb(const std::string& axiom, std::vector<std::string> rules, int steps, double angle) {
  PlantParams params;
  params.grammar.axiom = axiom;
  for (const std::string& rule : rules) params.grammar.rules.emplace_back().text = rule;
  params.grammar.steps = steps;
  params.grammar.angle = angle;
  params.smoothing = 1;
  return params;
}

Model grown(const PlantParams& params) {
  Result<Model> model = grow_plant(params, Seed{7});
  EXPECT_TRUE(model.ok()) << (model ? "" : model.errors()[0].text());
  EXPECT_EQ(model->find_fault(), "");
  return *model;
}

OrganParams organ(const std::string& symbol, OrganShape shape = OrganShape::leaf) {
  OrganParams params;
  params.symbol = symbol;
  params.shape = shape;
  return params;
}

TEST(Plant, DrawsEachSegmentOfItsGrammar) {
  EXPECT_EQ(grown(herb("F", {"F -> F[+F]F[-F]F"}, 4, 25.7)).skeleton.size(), 626u);
  EXPECT_EQ(grown(herb("F-F-F-F", {"F -> F-F+F+FF-F-F+F"}, 2, 90)).skeleton.size(), 257u);
}

TEST(Plant, HeedsTheLimitsOfItsGrammar) {
  PlantParams params = herb("F(1)", {"F(x) : x > 0 -> F(x)F(x)"}, 8, 20);
  params.grammar.where = "p.json:1:2: /organisms/0/grammar";
  EXPECT_TRUE(grow_plant(params, Seed{1}).ok());
  params.grammar.limits.modules = 100;
  for (double share : {1.0, 0.95})
    for (bool by_steps : {false, true}) {
      params.by_steps = by_steps;
      Result<Model> model = grow_plant(params, Seed{1}, share);
      ASSERT_FALSE(model.ok());
      EXPECT_EQ(model.errors()[0].where, params.grammar.where);
      EXPECT_NE(model.errors()[0].what.find("limit of 100 modules"), std::string::npos);
    }
}

TEST(Plant, WhatIsNotFiniteIsRefused) {
  EXPECT_FALSE(grow_plant(herb("F(1e30)", {}, 0, 20), Seed{1}).ok());
  PlantParams flat = herb("+(90)F(1e17)-(90)F(1e-30)", {}, 0, 20);
  flat.height = 1000;
  EXPECT_FALSE(grow_plant(flat, Seed{1}).ok());
}

TEST(Plant, SmoothingMultipliesNodesAndKeepsOrgansAtTheirs) {
  PlantParams params = herb("X", {"X -> F[+X]F[-X]+X", "F -> FF"}, 4, 20);
  params.organs = {organ("X", OrganShape::flower)};
  Model straight = grown(params);
  params.smoothing = 3;
  Model smooth = grown(params);
  EXPECT_EQ(smooth.skeleton.size(), 3 * (straight.skeleton.size() - 1) + 1);
  ASSERT_EQ(straight.organs.size(), 81u);
  ASSERT_EQ(smooth.organs.size(), 81u);
  for (std::size_t i = 0; i < 81; ++i)
    EXPECT_LT(glm::distance(smooth.organs.position[i], smooth.skeleton.position[smooth.organs.node[i]]),
              1e-4f);
}

TEST(Plant, FillsOutlinesThatRideOnTheirBranch) {
  Model bush = grown(herb(
      "A",
      {"A -> [&FL!A]/////'[&FL!A]///////'[&FL!A]", "F -> S/////F", "S -> FL", "L -> ['''^^{-f+f+f-|-f+f+f}]"},
      5, 22.5));
  ASSERT_GT(bush.blades.size(), 100u);
  // A leaf is a hexagon: four triangles.
  EXPECT_EQ(bush.blades.surface.triangle.size(), 4 * bush.blades.size());
  for (std::size_t i = 0; i < bush.blades.size(); ++i) {
    ASSERT_NE(bush.blades.node[i], Skeleton::kRoot);
    EXPECT_LT(glm::distance(bush.blades.foot[i], bush.skeleton.position[bush.blades.node[i]]), 1e-3f);
  }
}

TEST(Plant, OrganFramesAreTurnsThatFollowTheTurtle) {
  PlantParams params = herb("F[&(90)~L]/(90)F[+(90)~L(2)]", {}, 0, 45);
  params.organs = {organ("L")};
  params.organs[0].size = 0.5;
  params.organs[0].size_variation = params.organs[0].turn_variation = 0;
  Model model = grown(params);
  ASSERT_EQ(model.organs.size(), 2u);
  for (const Quat& turn : model.organs.turn) {
    glm::mat3 frame = glm::mat3_cast(turn);
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) EXPECT_NEAR(glm::dot(frame[a], frame[b]), a == b ? 1 : 0, 1e-5);
    EXPECT_NEAR(glm::determinant(frame), 1, 1e-5);
  }
  // Pitched down from straight up, the first leaf points away from the turtle's upper side.
  EXPECT_LT(glm::distance(model.organs.turn[0] * Vec3(0, 1, 0), Vec3(0, 0, -1)), 1e-5f);
  EXPECT_FLOAT_EQ(model.organs.scale[1].x, 1.0f);
}

TEST(Plant, PipesAddUpAtEveryFork) {
  PlantParams params = herb("X", {"X -> F[+X][-X]FX", "F -> FF"}, 5, 25);
  params.thickness = {GirthFrom::pipe, 0.1, 2.3, {}, 1e-5, 0};
  Model model = grown(params);
  const Skeleton& s = model.skeleton;
  std::vector<double> carried(s.size(), 0);
  for (std::size_t i = s.size(); i-- > 0;) {
    double own = std::pow(s.radius[i], 2.3);
    if (carried[i] > 0) {
      EXPECT_NEAR(carried[i] / own, 1, 1e-3) << i;
    }
    if (s.parent[i] != Skeleton::kRoot) carried[s.parent[i]] += own;
  }
  EXPECT_NEAR(s.radius[0], 0.1, 1e-6);
}

TEST(Plant, HasTheHeightAskedFor) {
  PlantParams params = herb("F", {"F -> F[+F]F[-F][F]"}, 4, 20);
  params.height = 1.7;
  params.origin = PlantOrigin::middle;
  Model model = grown(params);
  float low = 1e9f, high = -1e9f;
  for (const Vec3& p : model.skeleton.position) low = std::min(low, p.y), high = std::max(high, p.y);
  EXPECT_NEAR(low, 0, 1e-5);
  EXPECT_NEAR(high, 1.7, 1e-4);
}

/// What a camera would see jump: organs by their names, the wood as a whole.
struct Sight {
  std::map<std::uint32_t, std::size_t> organ;
  double wood = 0;
  explicit Sight(const Model& m) {
    for (std::size_t i = 0; i < m.organs.size(); ++i) organ[m.organs.id[i]] = i;
    for (std::size_t i = 0; i < m.skeleton.size(); ++i)
      if (std::int32_t p = m.skeleton.parent[i]; p != Skeleton::kRoot)
        wood += m.skeleton.radius[i] * m.skeleton.radius[i] *
                glm::distance(m.skeleton.position[i], m.skeleton.position[p]);
  }
};

TEST(Plant, GrowsThroughItsStepsWithoutAJump) {
  PlantParams params = herb("A(1)",
                            {"A(l) -> F(l)K(1)[&(45)B(l*0.8)]/(137.5)A(l*0.9)",
                             "B(l) -> F(l)K(1)[-(40)B(l*0.8)]", "K(s) : s > 0.2 -> K(s*0.5)", "K(s) -> "},
                            6, 20);
  for (const char* rule : {"K(s) -> [&(40)~L(s)][/(120)&(55)~L(s)]"})
    params.grammar.interpretation.emplace_back().text = rule;
  params.grammar.angle_jitter = 8;
  params.grammar.length_jitter = 0.2;
  params.thickness = {.from = GirthFrom::pipe, .radius = 0.1};
  params.organs = {organ("L")};
  params.height = 2;
  params.by_steps = true;
  constexpr int kFrames = 600;
  double wood = Sight(*grow_plant(params, Seed{7})).wood;
  Model before = *grow_plant(params, Seed{7}, 0);
  std::size_t followed = 0;
  for (int frame = 1; frame <= kFrames; ++frame) {
    SCOPED_TRACE(frame);
    Model after = *grow_plant(params, Seed{7}, static_cast<double>(frame) / kFrames);
    ASSERT_EQ(after.find_fault(), "");
    Sight a(before), b(after);
    EXPECT_NEAR(a.wood, b.wood, 8 * wood / kFrames);
    for (auto [id, j] : b.organ) {
      if (!a.organ.contains(id)) {
        EXPECT_LT(after.organs.scale[j].y, 0.01f) << "a new leaf is large";
        continue;
      }
      std::size_t i = a.organ[id];
      ++followed;
      EXPECT_LT(glm::distance(before.organs.position[i], after.organs.position[j]), 0.03f);
      EXPECT_LT(glm::distance(before.organs.scale[i], after.organs.scale[j]), 0.008f);
      EXPECT_GT(std::abs(glm::dot(before.organs.turn[i], after.organs.turn[j])), 0.995f);
    }
    before = std::move(after);
  }
  EXPECT_GT(followed, 4000u);
  EXPECT_EQ(before.skeleton.position, grow_plant(params, Seed{7})->skeleton.position);
}

TEST(Plant, NeedsNoBranch) {
  PlantParams params = herb("A(0)", {"A(n) -> +(137.5)[f(n^0.5)~D]A(n+1)"}, 50, 45);
  params.organs = {organ("D", OrganShape::berry)};
  Model head = grown(params);
  EXPECT_EQ(head.skeleton.size(), 0u);
  EXPECT_EQ(head.organs.size(), 50u);
}

TEST(Plant, RefusesOrgansThatCannotBe) {
  PlantParams params = herb("F~K", {}, 0, 45);
  ASSERT_FALSE(grow_plant(params, Seed{1}).ok());
  EXPECT_NE(grow_plant(params, Seed{1}).errors()[0].text().find("\"K\""), std::string::npos);
  params.organs = {organ("K"), organ("Q")};
  ASSERT_FALSE(plant_grammar(params).ok());
  EXPECT_NE(plant_grammar(params).errors()[0].text().find("\"Q\""), std::string::npos);
}

TEST(Plant, OrgansThatOnlyARuleNamesAreMissedBeforeGrowing) {
  PlantParams params = herb("F~KA", {"A -> F~L", "B(t) : t > 5 -> ~M"}, 1, 45);
  params.organs = {organ("L")};
  Result<Grammar> grammar = plant_grammar(params);
  ASSERT_FALSE(grammar.ok());
  ASSERT_EQ(grammar.errors().size(), 2u);  // M too, although B(t) never comes
  EXPECT_EQ(grammar.errors()[0].where, "axiom");
  EXPECT_NE(grammar.errors()[0].what.find("\"K\""), std::string::npos);
  EXPECT_EQ(grammar.errors()[1].where, "rule 2");
  params.organs = {organ("L"), organ("K"), organ("M")};
  EXPECT_TRUE(plant_grammar(params).ok());
}

TEST(Plant, MeshesAreColouredFromTheirAxisOut) {
  PlantParams params = herb("F~K", {}, 0, 45);
  params.organs = {organ("K", OrganShape::obj)};
  params.organs[0].mesh = {
      {{0, 0, 0}, {0.5f, 0, 0}, {0, 0, -0.25f}}, {{0, 1, 0}, {0, 1, 0}, {0, 1, 0}}, {{0, 1, 2}}, {}};
  const Surface mesh = grown(params).prototypes[0].parts[0].surface;
  ASSERT_EQ(mesh.uv.size(), 3u);
  EXPECT_EQ(mesh.uv[0].x, 0);
  EXPECT_EQ(mesh.uv[1].x, 1);
  EXPECT_EQ(mesh.uv[2].x, 0.5f);
}

TEST(Plant, VariantsOfAFrondTakeTurns) {
  PlantParams params = herb("A", {"A -> F[&~K]/(137)A"}, 60, 45);
  params.organs = {organ("A"), organ("K", OrganShape::frond)};
  params.organs[1].variants = 4;
  Model model = grown(params);
  std::map<int, int> times;
  for (std::uint16_t which : model.organs.prototype) ++times[which];
  EXPECT_EQ(times.size(), 5u);  // one of A, four of K
  for (int k = 1; k <= 4; ++k) EXPECT_GT(times[k], 5) << k;
  EXPECT_NE(model.prototypes[1].parts[0].surface.position, model.prototypes[2].parts[0].surface.position);
}

TEST(Plant, ShapesOfOrgansAreSound) {
  PlantParams params = herb("ABCDEK", {}, 0, 45);
  params.organs = {organ("A"),
                   organ("B", OrganShape::petal),
                   organ("C", OrganShape::flower),
                   organ("D", OrganShape::bud),
                   organ("E", OrganShape::berry),
                   organ("K", OrganShape::ball)};
  params.organs[2].petals = 13;
  params.organs[1].bend = radians(-30.0);
  Model model = grown(params);  // which checks the prototypes
  EXPECT_EQ(model.organs.size(), 6u);
}

TEST(Plant, LeavesAsPicturesCurlEachInAWayOfItsOwn) {
  PlantParams params = herb("F~K", {}, 0, 45);
  params.organs = {organ("K", OrganShape::picture)};
  params.organs[0].picture.emplace().shape = LeafShape::maple;
  params.organs[0].luster = Luster{.through = 0.6};
  Model flat = grown(params);
  EXPECT_EQ(flat.prototypes.size(), 3u);  // and the ball and the disc
  EXPECT_EQ(flat.prototypes[0].parts[0].pictures.size(), params.organs[0].picture->colors.size());
  EXPECT_EQ(flat.prototypes[0].luster->through, 0.6);
  params.organs[0].picture->curl = 0.5;
  Model curled = grown(params);
  EXPECT_EQ(curled.prototypes.size(), 5u);
  EXPECT_NE(curled.prototypes[0].parts[0].surface.position, curled.prototypes[1].parts[0].surface.position);
}

TEST(Plant, LeavesAsPicturesTakeAllTheirColoursUnlessTheGrammarPicks) {
  auto colors = [](const std::string& axiom) {
    PlantParams params = herb(axiom, {}, 0, 45);
    params.organs = {organ("K", OrganShape::picture)};
    params.organs[0].picture.emplace();
    std::vector<std::int32_t> found = grown(params).organs.color;
    return std::set<std::int32_t>(found.begin(), found.end());
  };
  std::string many;
  for (int i = 0; i < 24; ++i) many += "F~K";
  EXPECT_EQ(colors(many), (std::set<std::int32_t>{0, 1, 2}));
  EXPECT_EQ(colors("'(1)" + many), (std::set<std::int32_t>{1}));
}

double area(std::span<const Vec3> points, std::span<const std::array<std::uint32_t, 3>> triangles) {
  double sum = 0;
  for (auto [a, b, c] : triangles)
    sum += 0.5 * glm::length(glm::cross(points[b] - points[a], points[c] - points[a]));
  return sum;
}

TEST(Outline, ConcaveOnesAreCutWithoutOverlap) {
  // A U, a comb and a star, tilted; in both directions.
  std::vector<std::vector<Vec2>> shapes = {
      {{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}},
      {{0, 0}, {7, 0}, {7, 2}, {6, 2}, {6, 1}, {5, 1}, {5, 2}, {4, 2}, {4, 1}, {3, 1}, {3, 2}, {0, 2}}};
  shapes.emplace_back();
  for (int i = 0; i < 14; ++i)
    shapes.back().emplace_back((i % 2 ? 1.0 : 2.5) * std::cos(i * kPi / 7),
                               (i % 2 ? 1.0 : 2.5) * std::sin(i * kPi / 7));
  glm::mat3 tilt = glm::mat3_cast(glm::angleAxis(0.8f, glm::normalize(Vec3(1, 2, 3))));
  for (std::vector<Vec2> shape : shapes) {
    for (int way = 0; way < 2; ++way) {
      std::vector<Vec3> points;
      for (Vec2 p : shape) points.push_back(tilt * Vec3(p.x, p.y, 0));
      std::vector<std::array<std::uint32_t, 3>> triangles;
      triangulate(points, 0, triangles);
      EXPECT_EQ(triangles.size(), points.size() - 2);
      EXPECT_NEAR(area(points, triangles), glm::length(polygon_area(points)), 1e-4);
      std::reverse(shape.begin(), shape.end());
    }
  }
}

}  // namespace
}  // namespace frond
