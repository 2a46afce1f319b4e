#include "organisms/ivy/ivy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <set>

#include "motion/unfold.h"
#include "organisms/column/column.h"
#include "organisms/ivy/ivy_forms.h"
#include "organisms/ivy/ivy_rest.h"
#include "organisms/wall/wall.h"
#include "world/world.h"

namespace frond {
namespace {

const GroundHeight kLevel = [](double, double) { return 0.0; };

Surface wall(double width = 2, double height = 1.6) {
  WallShape shape;
  shape.width = width, shape.height = height;
  return build_wall(shape, Seed{1}).hull;
}

IvyParams small_ivy() {
  IvyParams params;
  params.crawl.max_age = 90;
  params.facing = Vec3(0, 0, 1);
  params.crawl.let_go = 0;
  return params;
}

Ivy ivy_on_wall(const IvyParams& params, std::uint64_t seed = 1) {
  Result<Ivy> ivy = grow_ivy(params, *TriangleSurface::build(wall()), {}, 3, kLevel, Seed{seed});
  if (!ivy) ADD_FAILURE() << ivy.errors().front().text();
  return ivy ? std::move(*ivy) : Ivy{};
}

TEST(Walkers, StandOnTheirHostAndGoTheirWay) {
  IvyParams params = small_ivy();
  params.crawl.trace = false;
  params.crawl.max_age = 200, params.crawl.speed = 0.005;
  params.facing = Vec3(0);
  Result<TriangleSurface> built = TriangleSurface::build(wall());
  const TriangleSurface& host = *built;
  Result<Ivy> ivy = grow_ivy(params, host, {}, 12, kLevel, Seed{1});
  ASSERT_TRUE(ivy);
  EXPECT_EQ(ivy->model.find_fault(), "");
  EXPECT_EQ(ivy->model.skeleton.size(), 0u) << "they leave nothing";
  EXPECT_EQ(ivy->model.organs.size(), ivy->strands.strands.size());
  Organs before = walkers_at(params.walkers, ivy->strands, 0.5, Seed{2});
  for (int step = 1; step <= 40; ++step) {
    Organs now = walkers_at(params.walkers, ivy->strands, 0.5 + step / 100.0, Seed{2});
    for (std::size_t i = 0; i < now.size(); ++i) {
      EXPECT_LT(host.closest(DVec3(now.position[i]))->distance, 0.004);
      // Two steps of growth at most, and no jump of the body.
      EXPECT_LT(glm::distance(now.position[i], before.position[i]), 2.2f * 0.005f);
      EXPECT_GT(glm::dot(now.turn[i] * Vec3(0, 0, 1), before.turn[i] * Vec3(0, 0, 1)), 0.3f);
      EXPECT_EQ(now.scale[i], before.scale[i]);
    }
    before = now;
  }
}

TEST(Ivy, IsAModelWithLeavesOnItsStrands) {
  Ivy ivy = ivy_on_wall(small_ivy());
  EXPECT_EQ(ivy.model.find_fault(), "");
  EXPECT_GT(ivy.strands.strands.size(), 5u);
  ASSERT_GT(ivy.model.organs.size(), 100u);
  const Organs& o = ivy.model.organs;
  for (std::size_t i = 0; i < o.size(); ++i) {
    // Each petiole stands on its node, and the blade lies off the wall's face and does not look into it.
    EXPECT_LT(glm::distance(o.position[i], ivy.model.skeleton.position[o.node[i]]), 0.02f);
    Vec3 n = ivy.strands.normal[o.node[i]];
    EXPECT_GT(glm::dot(o.turn[i] * Vec3(0, 0, 1), n), 0.05f);
  }
  // The foot is bare.
  for (std::size_t i = 0; i < o.size(); ++i)
    EXPECT_GT(ivy.model.skeleton.distance[o.node[i]], 0.55 * IvyLeaves{}.bare);
}

TEST(Ivy, WearsTheLeafOfAnotherClimber) {
  IvyParams params = small_ivy();
  LeafLook& look = params.leaves.picture.emplace();
  look.shape = LeafShape::maple;
  Result<TriangleSurface> built = TriangleSurface::build(wall());
  const TriangleSurface& host = *built;
  for (bool sprig : {false, true}) {
    look.sprig = sprig;
    Ivy ivy = ivy_on_wall(params);
    EXPECT_EQ(ivy.model.find_fault(), "");
    const Organs& o = ivy.model.organs;
    ASSERT_GT(o.size(), 100u);
    std::set<std::string> drawn, worn;
    for (const Drawing& drawing : leaf_drawings(look))
      drawn.insert(drawing.names.begin(), drawing.names.end());
    for (const Prototype& leaf : ivy.model.prototypes)
      worn.insert(leaf.parts.front().pictures.begin(), leaf.parts.front().pictures.end());
    EXPECT_EQ(worn, drawn);
    std::size_t sunk = 0, points = 0;
    for (std::size_t i = 0; i < o.size(); ++i) {
      Surface leaf = felt(params.leaves, ivy.model.prototypes[o.prototype[i]].parts.front().surface);
      EXPECT_LT(o.color[i], 3);
      for (std::size_t k = 0; k < leaf.position.size(); ++k) {
        if (leaf.uv[k].x > 1) continue;
        ++points;
        sunk += host.inside(DVec3(o.position[i] + o.turn[i] * (leaf.position[k] * o.scale[i])));
      }
    }
    EXPECT_GT(points, 1000u);
    EXPECT_EQ(sunk, 0u) << "blades lie on the wall, not in it";
  }
}

TEST(Ivy, StandsWhereItIsPut) {
  IvyParams params = small_ivy();
  Result<Ivy> ivy =
      grow_ivy(params, *TriangleSurface::build(wall()), {Vec3(0.5f, 0.05f, 0.4f)}, 1, kLevel, Seed{1});
  ASSERT_TRUE(ivy.ok());
  Vec3 root = ivy->model.skeleton.position[0];
  EXPECT_NEAR(root.x, 0.5, 0.02);
  EXPECT_NEAR(root.z, 0.12, 0.02);
  for (const Vec3& p : ivy->model.skeleton.position) EXPECT_GT(p.y, -0.01f);
}

TEST(Ivy, RefusesWhatNothingHoldsOnTo) {
  Result<std::shared_ptr<const TriangleSurface>> none =
      World(Seed{1}, Heights(), 1, false).host({}, "what the ivy grows on");
  ASSERT_FALSE(none.ok());
  EXPECT_NE(none.errors()[0].text().find("what the ivy grows on"), std::string::npos);
}

TEST(Ivy, SeedsDifferAndOneSeedDoesNot) {
  Ivy a = ivy_on_wall(small_ivy()), b = ivy_on_wall(small_ivy()), c = ivy_on_wall(small_ivy(), 2);
  EXPECT_EQ(a.model.skeleton.position, b.model.skeleton.position);
  EXPECT_EQ(a.model.organs.position, b.model.organs.position);
  EXPECT_NE(a.model.skeleton.position, c.model.skeleton.position);
}

TEST(Ivy, LeavesAreSmallerAndFresherNearTheTips) {
  Ivy ivy = ivy_on_wall(small_ivy());
  const Organs& o = ivy.model.organs;
  double young = 0, old = 0, young_color = 0, old_color = 0;
  int young_count = 0, old_count = 0;
  for (std::size_t i = 0; i < o.size(); ++i) {
    float to_tip = ivy.model.skeleton.to_tip[o.node[i]];
    if (to_tip < 0.1f) young += o.scale[i].x, young_color += o.color[i], ++young_count;
    if (to_tip > 0.4f) old += o.scale[i].x, old_color += o.color[i], ++old_count;
  }
  ASSERT_GT(young_count, 10);
  ASSERT_GT(old_count, 10);
  EXPECT_LT(young / young_count, 0.65 * old / old_count);
  EXPECT_GT(young_color / young_count, old_color / old_count + 2);
}

TEST(Ivy, BearsLeavesOfAllAges) {
  IvyParams params = small_ivy();
  params.crawl.max_age = 160;
  Ivy ivy = ivy_on_wall(params);
  std::map<int, int> forms;  // six petioles each
  for (std::uint16_t which : ivy.model.organs.prototype) ++forms[which / 6];
  EXPECT_EQ(forms.size(), 4u);
}

TEST(Ivy, SprigsBearManyLeavesForFewPlacements) {
  IvyParams params = small_ivy();
  params.crawl.max_age = 160;
  Ivy ivy = ivy_on_wall(params);
  params.leaves.detail = IvyDetail::sprigs;
  Model model;
  model.skeleton = ivy.model.skeleton;
  std::size_t leaves =
      add_ivy_leaves(model, ivy.strands, params.leaves, {*TriangleSurface::build(wall()), kLevel}, Seed{1});
  EXPECT_EQ(model.find_fault(), "");
  EXPECT_GE(leaves, 6 * model.organs.size());
  EXPECT_GT(leaves, ivy.model.organs.size() / 2);
  // A leaf of a sprig is coarse: a few dozen triangles.
  for (const Prototype& p : model.prototypes) EXPECT_LT(p.parts[0].surface.triangle.size(), 250u);
}

TEST(Ivy, DropsLeavesThatFindNoPlace) {
  IvyParams params = small_ivy();
  params.leaves.overlap = 0.05;
  std::size_t placed = ivy_on_wall(params).model.organs.size();
  params.leaves.overlap = 20;
  EXPECT_LT(placed, 0.9 * static_cast<double>(ivy_on_wall(params).model.organs.size()));
}

TEST(Ivy, BearsTendrilsOppositeItsLeavesOnlyWhereTheyAreAsked) {
  IvyParams params = small_ivy();
  Ivy plain = ivy_on_wall(params);
  Tendrils& tendrils = params.tendrils.emplace();
  tendrils.pads = true, tendrils.reach = 0.06, tendrils.every = 2;
  Ivy ivy = ivy_on_wall(params);
  EXPECT_EQ(ivy.model.find_fault(), "");
  std::size_t strands = plain.model.skeleton.size();
  ASSERT_GT(ivy.model.skeleton.size(), strands + 500);
  EXPECT_EQ(plain.strands.size(), strands) << "none without the property";
  EXPECT_EQ(ivy.strands.size(), ivy.model.skeleton.size());
  EXPECT_EQ(ivy.model.organs.position, plain.model.organs.position) << "leaves are as without them";
  // They have a colour of their own; strands keep theirs.
  auto own = static_cast<std::int32_t>(params.bark.colors.size());
  for (std::size_t i = 0; i < ivy.model.skeleton.size(); ++i)
    EXPECT_EQ(ivy.model.color[i], i < strands ? plain.model.color[i] : own);
  std::map<std::int32_t, Vec3> tips;  // of the first leaf of a node
  const Organs& o = ivy.model.organs;
  for (std::size_t i = 0; i < o.size(); ++i) tips.emplace(o.node[i], o.turn[i] * Vec3(0, 1, 0));
  int same = 0, opposite = 0;
  const Skeleton& s = ivy.model.skeleton;
  for (std::size_t i = strands; i + 4 < s.size(); ++i) {
    if (s.parent[i] >= static_cast<std::int32_t>(strands)) continue;
    Vec3 way = s.position[i + 4] - s.position[s.parent[i]];
    (glm::dot(way, tips.at(s.parent[i])) < 0 ? opposite : same)++;
  }
  EXPECT_GT(opposite, 20);
  EXPECT_GT(opposite, 4 * same);
}

/// A mask that is projected along z over the wall, white where a function of shares of its sides says so.
CrawlMask projected(const std::function<bool(double, double)>& white) {
  constexpr int kSide = 64;
  std::vector<float> grey;
  for (int i = 0; i < kSide * kSide; ++i)
    grey.push_back(white((i % kSide + 0.5) / kSide, (i / kSide + 0.5) / kSide) ? 1.0f : 0.0f);
  CrawlMask mask;
  mask.stops = 0.5;
  mask.picture.along = Axis::z;
  mask.picture.area = {Vec2(-1, 0), Vec2(1, 1.6f)};
  mask.picture.width = mask.picture.height = kSide;
  mask.picture.grey = std::make_shared<const std::vector<float>>(grey);
  return mask;
}

TEST(MaskedIvy, IsAsWithoutAMaskWhereThatIsWhite) {
  IvyParams params = small_ivy();
  Ivy free = ivy_on_wall(params);
  params.crawl.mask = projected([](double, double) { return true; });
  Ivy white = ivy_on_wall(params);
  EXPECT_EQ(white.strands.skeleton.position, free.strands.skeleton.position);
  EXPECT_EQ(white.model.organs.position, free.model.organs.position);
}

TEST(MaskedIvy, IsNoneWhereAllIsBlack) {
  IvyParams params = small_ivy();
  params.crawl.mask = projected([](double, double) { return false; });
  Ivy none = ivy_on_wall(params);
  EXPECT_EQ(none.model.organs.size(), 0u);
  EXPECT_EQ(none.model.skeleton.size(), 0u);
}

TEST(MaskedIvy, HasNoLeafOutsideOfTheWhiteAndReachesEachPieceOfIt) {
  // Two islands above the foot, which is black.
  auto island = [](double x, double y) { return y > 0.2 && y < 0.6 && (x < 0.35 || x > 0.65); };
  IvyParams params = small_ivy();
  params.facing = Vec3(0);
  params.crawl.mask = projected(island);
  params.leaves.bare = 0;
  for (std::uint64_t seed = 1; seed < 4; ++seed) {
    Result<Ivy> ivy = grow_ivy(params, *TriangleSurface::build(wall()), {}, 16, kLevel, Seed{seed});
    ASSERT_TRUE(ivy);
    std::set<std::pair<bool, bool>>
        pieces;  // left or right, and the front or the back: it is projected on both
    for (const Vec3& foot : ivy->model.organs.position) {
      constexpr float kPetiole = 0.06f;  // metres that a leaf reaches over from its strand
      float x = std::abs(foot.x);
      EXPECT_TRUE(x > 0.3f - kPetiole && foot.y > 0.64f - kPetiole && foot.y < 1.28f + kPetiole)
          << foot.x << " " << foot.y;
      pieces.insert({foot.x > 0, foot.z > 0});
    }
    EXPECT_EQ(pieces.size(), 4u);
    EXPECT_GT(ivy->model.organs.size(), 100u);
  }
}

TEST(Fluttering, RepeatsAndGrowsWithThePetiole) {
  Flutter flutter;
  flutter.amplitude = radians(10.0);
  auto angle = [](const Quat& q) { return 2 * std::acos(std::min(1.0f, std::abs(q.w))); };
  double longer = 0, shorter = 0, step = 0;
  for (std::uint32_t id = 0; id < 40; ++id) {
    Quat first = fluttering(flutter, 4, 0, Vec3(0.1f, 1, 0), id, 1), last = first;
    EXPECT_LT(angle(glm::conjugate(first) * fluttering(flutter, 4, 4, Vec3(0.1f, 1, 0), id, 1)), 1e-3f);
    for (int frame = 1; frame <= 96; ++frame) {
      Quat now = fluttering(flutter, 4, frame / 24.0, Vec3(0.1f, 1, 0), id, 1);
      longer += angle(now);
      shorter += angle(fluttering(flutter, 4, frame / 24.0, Vec3(0.1f, 1, 0), id, 0.4f));
      step = std::max<double>(step, angle(glm::conjugate(last) * now));
      last = now;
    }
  }
  EXPECT_NEAR(shorter / longer, 0.4, 0.02);
  EXPECT_LT(step, radians(10.0)) << "from frame to frame";
  EXPECT_GT(longer / (40 * 96), radians(1.0));
  // Phases differ.
  std::set<float> phases;
  for (std::uint32_t id = 0; id < 40; ++id) phases.insert(fluttering(flutter, 4, 1, Vec3(0), id, 1).w);
  EXPECT_GT(phases.size(), 30u);
  flutter.amplitude = 0;
  EXPECT_EQ(fluttering(flutter, 4, 1, Vec3(0), 1, 1), Quat(1, 0, 0, 0));
}

}  // namespace
}  // namespace frond
