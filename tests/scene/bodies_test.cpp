#include <gtest/gtest.h>

#include <cmath>

#include "creeping/triangle_surface.h"
#include "geometry/far.h"
#include "pieces.h"
#include "scene_at.h"
#include "solidity.h"

namespace frond {
namespace {

/// What the bodies of a kind measure with its default properties and seed 1.
struct Measures {
  const char* kind;
  std::size_t pieces = 0;  ///< that hang together
  long genus = 0;          ///< holes through all of them
  double volume = 0;       ///< m3
  double area = 0;         ///< m2
};

class Bodies : public testing::TestWithParam<Measures> {};

Measures measured(const char* kind) {
  std::string text = std::string(R"({"film": {"frames": 1}, "seed": 1, "scene": {"setting": "studio"},
    "organisms": [{"kind": ")") +
                     kind + R"("}]})";
  Scene scene = *build_scene(*read_preset(text, "kind.json", {}));
  Measures all{kind};
  for (const Specimen& s : scene.specimens) {
    const Solids& solids = s.model.solids;
    for (std::size_t i = 0; i < solids.size(); ++i) {
      Surface placed;
      append_placed(placed, solids.shapes[solids.shape[i]].surface, solids.position[i], solids.turn[i],
                    solids.scale[i]);
      Solidity skin = solidity(placed);
      EXPECT_EQ(skin.open, 0u) << "shape " << solids.shape[i];
      std::vector<double> volume = printed_pieces(placed).volume;
      all.pieces += volume.size();
      all.genus += (2 * static_cast<long>(volume.size()) - skin.euler) / 2;
      double inside = 0, around = area(placed);
      for (double v : volume) inside += v;
      // No body has more in so large a skin than a ball.
      EXPECT_LE(inside, std::pow(around, 1.5) / (6 * std::sqrt(kPi)));
      all.volume += inside, all.area += around;
    }
  }
  return all;
}

TEST_P(Bodies, HaveThePiecesHolesVolumeAndAreaOfTheirKind) {
  const Measures& expected = GetParam();
  Measures found = measured(expected.kind);
  EXPECT_EQ(found.pieces, expected.pieces);
  EXPECT_EQ(found.genus, expected.genus);
  EXPECT_NEAR(found.volume, expected.volume, 0.01 * expected.volume);
  EXPECT_NEAR(found.area, expected.area, 0.01 * expected.area);
}

// A tube of a sponge is open at its foot, too.
INSTANTIATE_TEST_SUITE_P(
    , Bodies,
    testing::Values(Measures{"massive", 1, 0, 0.02463, 0.5063}, Measures{"columnar", 1, 0, 0.02502, 0.4538},
                    Measures{"foliose", 9, 0, 0.002078, 0.9203}, Measures{"table", 1510, 0, 0.01885, 2.184},
                    Measures{"encrusting", 1, 0, 0.002175, 0.3045}, Measures{"tube", 6, 6, 0.004834, 0.9531},
                    Measures{"mushroom", 1, 0, 0.0005715, 0.07976},
                    Measures{"shell", 1, 0, 5.279e-5, 0.02121}, Measures{"rock", 1, 0, 0.05778, 0.8687},
                    Measures{"pebbles", 150, 0, 0.009471, 1.0377}, Measures{"wall", 1209, 0, 6.930, 186.67},
                    Measures{"column", 1, 0, 0.5743, 6.622}, Measures{"bridge", 181, 0, 5.941, 184.83},
                    Measures{"vase", 1, 0, 0.001822, 0.5213}),
    [](const auto& kind) { return std::string(kind.param.kind); });

TEST(BesideBodies, TreesOfAllKindsKeepOutOfThemWhereTheyStand) {
  std::string text = R"({"film": {"frames": 1}, "seed": 2, "scene": {"setting": "studio"}, "organisms": [
    {"kind": "wall", "width": 6, "height": 2, "place": {"at": [[0, 0]], "turn_variation": 0}})";
  for (const char* kind : {R"("weber_penn", "tree": {"scale": 3})", R"("tree", "years": 8, "roots": 0)",
                           R"("colonized", "envelope": {"base": 0.5}, "colonize": {"attractors": 600})"})
    text +=
        std::string(R"(, {"kind": )") + kind + R"(, "count": 2, "place": {"at": [[-1, 0.4], [1, -0.4]]}})";
  Scene scene = *build_scene(*read_preset(text + "]}", "beside.json", {}));
  TriangleSurface wall = taken(TriangleSurface::build(skin_of(scene.specimens[0].model)));
  std::size_t nodes = 0;
  for (const Specimen& s : scene.specimens)
    for (Vec3 at : s.model.skeleton.position) {
      ++nodes;
      EXPECT_FALSE(wall.inside(DVec3(at))) << s.entry;
    }
  EXPECT_GT(nodes, 1000u);
}

}  // namespace
}  // namespace frond
