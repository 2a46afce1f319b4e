#include "draw/twigs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/parallel.h"
#include "draw/draw_list.h"
#include "draw/eyes.h"
#include "draw/twigs_scene.h"

namespace frond {
namespace {

constexpr double kTwigs = 25, kAway = 60;

const Scene& far_aspen() {
  static const Scene scene = aspen_scene(kAway, kTwigs);
  return scene;
}

const TwigPlan& far_plan() {
  static const std::shared_ptr<const TwigPlan> plan = twig_plans(far_aspen())[0];
  return *plan;
}

TEST(Twigs, OnlyThoseOfLargePlantsThatAreSmallInThePictureComeFromAPalette) {
  ASSERT_GT(far_aspen().specimens[0].model.organs.size(), 30'000u);
  ASSERT_TRUE(twig_plans(far_aspen())[0]);
  EXPECT_FALSE(twig_plans(aspen_scene(kAway, 0))[0]) << "it is turned off";
  EXPECT_FALSE(twig_plans(aspen_scene(3, kTwigs))[0]) << "it is near";
  EXPECT_FALSE(twig_plans(scene_at("tests/presets/tiny_plant.json"))[0]) << "it is small";
}

TEST(Twigs, EachOrganAndNodeIsDrawnOnce) {
  const Specimen& aspen = far_aspen().specimens[0];
  const TwigPlan& plan = far_plan();
  DrawList drawn(aspen, 0, aspen.model.solids, &plan);
  std::size_t single = 0;
  for (const OrganGroup& group : drawn.organs.groups) single += group.end - group.begin;
  EXPECT_EQ(single, static_cast<std::size_t>(std::ranges::count(plan.replaced, 0)));
  EXPECT_LT(single, aspen.model.organs.size() / 5) << "most are on twigs";
  EXPECT_EQ(plan.limbs.skeleton.find_fault(), "");
  // What is below a limb's node is a limb.
  const Skeleton& rest = aspen.model.skeleton;
  std::set<std::int32_t> limbs(plan.origin.begin(), plan.origin.end());
  for (const TwigPlan::Place& place : plan.places) {
    EXPECT_TRUE(limbs.contains(rest.parent[static_cast<std::size_t>(place.node)]));
    EXPECT_FALSE(limbs.contains(place.node));
  }
}

TEST(Twigs, BeginAtTheirJointsAtAllTimes) {
  const Specimen& aspen = far_aspen().specimens[0];
  const TwigPlan& plan = far_plan();
  for (double time : {0.0, 0.04}) {
    DrawList drawn(aspen, time, aspen.model.solids, &plan);
    ASSERT_EQ(drawn.twigs->places.size(), plan.places.size());
    for (std::size_t i = 0; i < plan.places.size(); ++i) {
      Vec3 joint = drawn.pose.position[joint_of(aspen.model.skeleton, plan.places[i].node)];
      ASSERT_LT(glm::distance(drawn.twigs->places[i].at, joint), 1e-6f);
    }
    // The wood of each begins there.
    for (const std::vector<TwigPart>& shape : drawn.twigs->shapes)
      for (const TwigPart& part : shape) {
        if (part.kind != CopyPart::Kind::wood) continue;
        float nearest = 1e9f;
        for (const Vec3& p : part.surface.position) nearest = std::min(nearest, glm::length(p));
        EXPECT_LT(nearest, plan.grain) << "a pixel";
      }
  }
}

TEST(Twigs, KeepTheAreaOfTheLeavesThatTheyStandFor) {
  const Specimen& aspen = far_aspen().specimens[0];
  const TwigPlan& plan = far_plan();
  DrawList all(aspen, 0), drawn(aspen, 0, aspen.model.solids, &plan);
  auto area_of = [](const DrawList& list) {
    double sum = 0;
    for (const OrganGroup& group : list.organs.groups)
      for (const OrganPlace& place : list.organs.places(group))
        for (const OrganPart& part : list.model.prototypes[group.prototype].parts)
          sum += area(part.surface) * static_cast<double>(place.scale.x * place.scale.y);
    return sum;
  };
  double twigs = 0;
  for (std::size_t i = 0; i < plan.places.size(); ++i)
    for (const TwigPart& part : drawn.twigs->shapes[plan.places[i].kept])
      if (part.kind == CopyPart::Kind::organ)
        twigs += area(part.surface) *
                 static_cast<double>(drawn.twigs->places[i].scale.x * drawn.twigs->places[i].scale.x);
  EXPECT_NEAR((area_of(drawn) + twigs) / area_of(all), 1, 0.06);
}

TEST(Twigs, StandWhereThoseThatTheyStandForDo) {
  const Specimen& aspen = far_aspen().specimens[0];
  const TwigPlan& plan = far_plan();
  DrawList drawn(aspen, 0, aspen.model.solids, &plan);
  // The middle of all leaves of the crown, and how far they are from it, hardly change.
  auto spread = [](const std::vector<Vec3>& at) {
    Vec3 sum(0), squares(0);
    for (Vec3 p : at) sum += p, squares += p * p;
    sum /= static_cast<float>(at.size());
    return std::pair(sum, glm::sqrt(squares / static_cast<float>(at.size()) - sum * sum));
  };
  std::vector<Vec3> own, copied;
  for (std::size_t i = 0; i < plan.replaced.size(); ++i)
    if (plan.replaced[i]) own.push_back(aspen.model.organs.position[i]);
  for (const OrganPlace& place : drawn.twigs->places) {
    std::size_t i = static_cast<std::size_t>(&place - drawn.twigs->places.data());
    for (const TwigPart& part : drawn.twigs->shapes[plan.places[i].kept])
      if (part.kind == CopyPart::Kind::organ)
        for (Vec3 p : part.surface.position) copied.push_back(place.at + place.turn * (place.scale * p));
  }
  auto [middle, wide] = spread(own);
  auto [middle_now, wide_now] = spread(copied);
  EXPECT_LT(glm::distance(middle, middle_now), 3 * plan.grain);
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(wide_now[axis] / wide[axis], 1, 0.08);
}

TEST(Twigs, KeepTheirKindsFromFrameToFrameAndMoveLittle) {
  const Specimen& aspen = far_aspen().specimens[0];
  const TwigPlan& plan = far_plan();
  DrawList first(aspen, 0, aspen.model.solids, &plan),
      second(aspen, far_aspen().film.time(2), aspen.model.solids, &plan);
  float moved = 0;
  for (std::size_t k = 0; k < plan.palette.size(); ++k) {
    ASSERT_EQ(first.twigs->shapes[k].size(), second.twigs->shapes[k].size());
    for (std::size_t p = 0; p < first.twigs->shapes[k].size(); ++p) {
      const Surface &a = first.twigs->shapes[k][p].surface, &b = second.twigs->shapes[k][p].surface;
      EXPECT_EQ(a.triangle, b.triangle);
      for (std::size_t v = 0; v < a.position.size(); ++v)
        moved = std::max(moved, glm::distance(a.position[v], b.position[v]));
    }
  }
  EXPECT_GT(moved, 0) << "leaves flutter";
  EXPECT_LT(moved, 2 * plan.grain) << "nothing pops";
}

TEST(Twigs, ThePlanIsTheSameWithAnyNumberOfThreads) {
  limit_threads(1);
  std::shared_ptr<const TwigPlan> alone = twig_plans(far_aspen())[0];
  limit_threads(0);
  ASSERT_EQ(alone->places.size(), far_plan().places.size());
  for (std::size_t i = 0; i < alone->places.size(); ++i) {
    EXPECT_EQ(alone->places[i].kept, far_plan().places[i].kept);
    EXPECT_EQ(alone->places[i].turn, far_plan().places[i].turn);
  }
}

}  // namespace
}  // namespace frond
