#include <gtest/gtest.h>

#include "creeping/triangle_surface.h"
#include "masonry/column.h"
#include "organisms/colonized/colonized.h"
#include "organisms/rock/rock.h"
#include "organisms/tree/tree.h"
#include "organisms/weber_penn/weber_penn.h"
#include "solids.h"
#include "world/obstacles.h"

namespace frond {
namespace {

constexpr std::uint64_t kSeeds = 100;

/// A wall behind a tree at the origin, a column to its right and a rock that hangs over its left.
std::vector<Surface> bodies() {
  std::vector<Surface> all{box(Vec3(-3, -0.2f, -0.65f), Vec3(3, 2.6f, -0.4f))};
  ColumnShape column;
  column.height = 2.2;
  for (Surface body : {column_surface(column), skin_of(*build_rock({}, Seed{2}))}) {
    Vec3 foot = all.size() == 1 ? Vec3(0.65f, -0.05f, 0.1f) : Vec3(-0.5f, 1.1f, 0.1f);
    for (Vec3& p : body.position) p += foot;
    all.push_back(std::move(body));
  }
  return all;
}

struct Yard {
  std::vector<Surface> around = bodies();
  Obstacles obstacles = *Obstacles::build(around);
  std::vector<TriangleSurface> hosts;
  Yard() {
    for (const Surface& body : around) {
      Result<TriangleSurface> host = TriangleSurface::build(body);
      hosts.push_back(std::move(*host));
    }
  }
  Detour detour() const {
    return [this](Vec3 from, Vec3 to, float clearance) { return obstacles.way(from, to, clearance); };
  }
  /// Segments that touch a body.
  std::size_t touching(const Skeleton& s) const {
    std::size_t count = 0;
    for (const TriangleSurface& host : hosts)
      for (std::size_t i = 0; i < s.size(); ++i) {
        DVec3 at(s.position[i]);
        count += host.inside(at) ||
                 (s.parent[i] != Skeleton::kRoot && host.crossing(DVec3(s.position[s.parent[i]]), at));
      }
    return count;
  }
};

/// Of trees with many seeds none may touch what it would have grown through. `grow` is asked with bodies or
/// without.
template <class Grow>
void expect_free(const Grow& grow) {
  Yard yard;
  std::size_t without = 0, nodes = 0, nodes_without = 0;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    Model round = grow(yard, Seed{seed}, true);
    EXPECT_EQ(yard.touching(round.skeleton), 0u) << "seed " << seed;
    EXPECT_EQ(round.find_fault(), "");
    nodes += round.skeleton.size();
    if (seed % 10 > 0) continue;
    Model alone = grow(yard, Seed{seed}, false);
    without += yard.touching(alone.skeleton);
    nodes_without += 10 * alone.skeleton.size();
  }
  EXPECT_GT(without, 100u) << "they are in its way";
  EXPECT_GT(nodes, nodes_without / 4) << "it grows on beside them";
}

TEST(RoundBodies, NoStemOfAWeberPennTreeTouchesThem) {
  WeberPennParams p;
  p.tree.scale = 2.6, p.tree.scale_v = 0.4, p.tree.levels = 3, p.tree.trunk_spread = 0;
  p.tree.level[0] = {.curve_res = 6, .curve_v = radians(60.0)};
  p.tree.level[0].length = 1;
  p.tree.level[1].branches = 14, p.tree.level[1].down_angle = radians(60.0),
  p.tree.level[1].rotate = radians(140.0);
  p.tree.level[2].branches = 6, p.tree.level[2].down_angle = radians(45.0),
  p.tree.level[2].rotate = radians(140.0);
  expect_free([&](const Yard& yard, Seed seed, bool round) {
    return std::move(*grow_weber_penn_tree(p, seed, round ? yard.detour() : Detour{}));
  });
}

TEST(RoundBodies, NoBranchOfAColonizedTreeTouchesThem) {
  ColonizedParams p;
  p.envelope.base = 0.5, p.envelope.height = 2.2, p.envelope.width = 2.4;
  p.growth_into.attractors = 300, p.growth_into.influence = 0.9, p.growth_into.step = 0.1;
  p.growth_into.kill = 0.2;
  p.thickness.radius = 0.06;
  p.leaf_spacing = 0.2;
  expect_free([&](const Yard& yard, Seed seed, bool round) {
    return std::move(*grow_colonized_tree(p, seed, round ? yard.detour() : Detour{}));
  });
}

TEST(RoundBodies, NoInternodeOfATreeTouchesThem) {
  TreeParams p;
  p.years = 9, p.roots = 0, p.knots = 0;
  expect_free([&](const Yard& yard, Seed seed, bool round) {
    GroveOptions options;
    options.years = p.years;
    if (round) options.detour = yard.detour();
    return tree_model(p, grow_grove({{p.species, Vec3(0), Vec3(0, 1, 0), seed}}, options)[0], p.years, {},
                      seed);
  });
}

}  // namespace
}  // namespace frond
