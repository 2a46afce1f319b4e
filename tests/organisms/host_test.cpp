#include "organisms/wall/wall.h"

#include <gtest/gtest.h>

#include <set>

#include "organisms/column/column.h"
#include "organisms/kinds.h"
#include "organisms/mesh/mesh.h"
#include "preset/json.h"
#include "preset/reader.h"
#include "solids.h"

namespace frond {

/// One organism of a kind that is known already.
struct OfKind {
  const Kind<Organism>* kind = nullptr;
  Organism organism;
};
void describe(Properties& v, OfKind& one) { one.kind->describe(v, one.organism); }

namespace {

TEST(TriangleSurface, WallIsBricksInTonesBeforeMortar) {
  WallParams params;
  params.shape.openings = {{WallHole::window, 0.5, 0.8, 1.0, 1.1}};
  Model model = build_wall_model(params, Seed{1});
  EXPECT_EQ(model.find_fault(), "");
  EXPECT_TRUE(closed(model.hull));
  std::set<float> tones;
  std::size_t bricks = 0;
  for (std::size_t i = 0; i < model.solids.size(); ++i) {
    const Material& m = model.solids.shapes[model.solids.shape[i]].material;
    if (m.matter == Matter::brick) ++bricks, tones.insert(m.color.red);
  }
  EXPECT_GT(bricks, 800u);
  EXPECT_GE(tones.size(), 8u);
  // Each seed builds another wall of the same size.
  Model other = build_wall_model(params, Seed{2});
  EXPECT_EQ(other.solids.size(), model.solids.size());
  EXPECT_NE(other.solids.shape, model.solids.shape);
}

TEST(TriangleSurface, ColumnIsWhatIvyHoldsOnTo) {
  Model model = build_column_model({});
  EXPECT_EQ(model.find_fault(), "");
  EXPECT_TRUE(closed(model.hull));
  EXPECT_EQ(model.solids.size(), 1u);
  EXPECT_EQ(model.solids.shapes[0].surface.triangle.size(), model.hull.triangle.size());
}

TEST(TriangleSurface, MeshIsScaledToItsSize) {
  MeshParams params;
  params.file.name = "box.obj";
  EXPECT_FALSE(build_mesh_model(params).ok()) << "nothing has been read";
  NamedFile box{"box.obj", "v 0 0 0\nv 2 0 0\nv 0 4 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"};
  EXPECT_TRUE(load_mesh_body(box, params).empty());
  params.size = 3;
  Result<Model> model = build_mesh_model(params);
  ASSERT_TRUE(model.ok());
  EXPECT_EQ(model->find_fault(), "");
  Surface all = merged(model->solids);
  float top = 0, low = 1;
  for (const Vec3& p : all.position) top = std::max(top, p.y), low = std::min(low, p.y);
  EXPECT_NEAR(top, 3, 1e-5);
  EXPECT_NEAR(low, 0, 1e-5);
}

TEST(Kinds, EachAnswersWithItsDefaults) {
  for (const Kind<Organism>& kind : organism_kinds()) {
    Result<Document> document = parse_json("{}", "test.json");
    Reader reader(true);
    OfKind one{&kind, {}};
    reader.read_root(document->root, one);
    ASSERT_TRUE(one.organism.grower) << kind.name;
    one.organism.grower->review();
    EXPECT_GE(one.organism.grower->traits().tallest, 0) << kind.name;
  }
}

}  // namespace
}  // namespace frond
