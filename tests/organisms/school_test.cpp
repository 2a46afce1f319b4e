#include "organisms/school/school.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

#include "core/parallel.h"
#include "images/raster.h"
#include "organisms/school/swimmer_shape.h"

namespace frond {
namespace {

/// Alignment of the headings at a step: 0 random .. 1 all equal.
double polarization(const Trajectory& trajectory, int step) {
  Vec3 sum(0);
  for (int i = 0; i < trajectory.count; ++i) sum += trajectory.heading[trajectory.at(step, i)];
  return trajectory.count > 0 ? glm::length(sum) / static_cast<float>(trajectory.count) : 0;
}

constexpr double kFilm = 4;
constexpr int kFish = 80;

/// A few swaying posts among which fish swim, and a stone.
std::unique_ptr<const World> reef() {
  auto world = std::make_unique<World>(Seed{1}, Heights([](double, double) { return 0.0; }), kFilm, true);
  Specimen coral{{"coral", 0}, {}};
  Skeleton& s = coral.model.skeleton;
  for (int post = 0; post < 5; ++post)
    for (int i = 0; i < 12; ++i) {
      std::int32_t parent = i == 0 ? Skeleton::kRoot : static_cast<std::int32_t>(s.size()) - 1;
      s.add({0.45f * static_cast<float>(post - 2), 0.12f * static_cast<float>(i),
             0.3f * static_cast<float>(post % 2)},
            0.04f, parent, 0);
    }
  set_tip_distances(s);
  coral.motion.wave.amplitude = 0.2;
  coral.motion.film_length = kFilm;
  std::vector<Specimen> all;
  all.push_back(std::move(coral));
  world->add(std::move(all));
  return world;
}

SwimTask task() {
  SwimTask task;
  task.count = kFish;
  task.home = Vec3(0, 0.9f, 0);
  task.film = kFilm;
  task.seed = Seed{7};
  return task;
}

Trajectory swum_among(const World& world) {
  SwimTask swims = task();
  Vec3 reach(2.6f, 1.5f, 2.6f);
  return swim(swims, 2.2, 0.12, clearance_of(world, swims.home - reach, swims.home + reach, 0.04f));
}

/// Shared, as each test asks of the same school.
const Trajectory& trajectory() {
  static const Trajectory made = swum_among(*reef());
  return made;
}

float distance_to(Vec3 at, Vec3 a, Vec3 b) {
  Vec3 way = b - a;
  float t = glm::clamp(glm::dot(at - a, way) / std::max(1e-12f, glm::dot(way, way)), 0.0f, 1.0f);
  return glm::distance(at, a + t * way);
}

TEST(School, IsTheSameForAnyThreads) {
  std::unique_ptr<const World> world = reef();
  limit_threads(1);
  Trajectory one = swum_among(*world);
  limit_threads(4);
  Trajectory four = swum_among(*world);
  limit_threads(0);
  EXPECT_EQ(one.position, four.position);
  EXPECT_EQ(one.heading, four.heading);
  EXPECT_EQ(one.stroke, four.stroke);
}

TEST(School, KeepsClearOfWhatStands) {
  std::unique_ptr<const World> world = reef();
  const Specimen& coral = world->standing()[0];
  float least = static_cast<float>(task().length) / 2;
  for (int frame = 0; frame < 96; ++frame) {
    double time = kFilm * frame / 96;
    Pose pose;
    pose_skeleton(coral.model.skeleton, coral.motion, time, pose);
    for (int i = 0; i < kFish; ++i) {
      Vec3 at = fish_at(trajectory(), i, time).position;
      ASSERT_GT(at.y, least) << "over the ground";
      for (std::size_t n = 0; n < pose.position.size(); ++n) {
        std::int32_t parent = coral.model.skeleton.parent[n];
        if (parent < 0) continue;
        ASSERT_GT(distance_to(at, pose.position[static_cast<std::size_t>(parent)], pose.position[n]),
                  pose.radius[n] + least)
            << "fish " << i << " at " << time;
      }
    }
  }
}

TEST(School, KeepsApart) {
  const Trajectory& s = trajectory();
  for (int step = 0; step <= s.steps; ++step)
    for (int i = 0; i < kFish; ++i)
      for (int j = i + 1; j < kFish; ++j)
        ASSERT_GT(glm::distance(s.position[s.at(step, i)], s.position[s.at(step, j)]),
                  0.3 * task().params.spacing)
            << i << " and " << j << " at step " << step;
}

TEST(School, ClosesTheFilm) {
  const Trajectory& s = trajectory();
  EXPECT_EQ(std::set<int>(s.next.begin(), s.next.end()).size(), static_cast<std::size_t>(kFish));
  for (int i = 0; i < kFish; ++i) {
    FishPose end = fish_at(s, i, kFilm), begin = fish_at(s, s.next[static_cast<std::size_t>(i)], 0);
    EXPECT_LT(glm::distance(end.position, begin.position), 1e-4f);
    EXPECT_LT(glm::distance(end.heading, begin.heading), 1e-3f);
    EXPECT_NEAR(end.size, begin.size, 1e-5f);
    EXPECT_NEAR(std::remainder(end.stroke - begin.stroke, 1.0f), 0, 1e-3f);
  }
}

TEST(School, AFilmOfTwoFramesIsSwumAsAnyOther) {
  SwimTask swims = task();
  swims.film = 2.0 / 24;
  Trajectory made = swim(swims, 2.2, 0.12, clearance_of(*reef(), Vec3(-3, -1, -3), Vec3(3, 3, 3), 0.04f));
  EXPECT_GE(made.steps, 3) << "directions are taken over three steps to each side";
  ASSERT_EQ(made.heading.size(), made.position.size());
  for (const Vec3& heading : made.heading) EXPECT_NEAR(glm::length(heading), 1, 1e-4);
}

TEST(School, SwimsSmoothly) {
  const Trajectory& s = trajectory();
  double fastest = task().params.speed * (1.5 + glm::length(task().params.current));
  for (int step = 0; step < s.steps; ++step)
    for (int i = 0; i < kFish; ++i)
      ASSERT_LT(glm::distance(s.position[s.at(step, i)], s.position[s.at(step + 1, i)]), 2 * fastest * s.step)
          << "fish " << i << " at step " << step;
}

TEST(School, HeadsOneWay) {
  double chance = 1 / std::sqrt(static_cast<double>(kFish)), sum = 0;
  for (int step = 0; step <= trajectory().steps; ++step) sum += polarization(trajectory(), step);
  EXPECT_GT(sum / (trajectory().steps + 1), 4 * chance);
}

TEST(School, FrameAloneIsThatOfAFilm) {
  SchoolParams params;
  Organs alone = school_organs(params, trajectory(), 2.5);
  for (int frame = 0; frame < 60; ++frame) school_organs(params, trajectory(), frame / 24.0);
  Organs in_order = school_organs(params, trajectory(), 60 / 24.0);
  EXPECT_EQ(alone.position, in_order.position);
  EXPECT_EQ(alone.prototype, in_order.prototype);
}

TEST(School, FishAreSoundMeshes) {
  SchoolParams params;
  for (const Prototype& shape : swimmer_prototypes(params.fish)) {
    const Surface& mesh = shape.parts[0].surface;
    EXPECT_EQ(mesh.find_fault(), "");
    float front = -1, back = 1;
    for (Vec3 p : mesh.position) front = std::max(front, p.y), back = std::min(back, p.y);
    EXPECT_NEAR(front - back, 1, 0.05);
  }
}

/// Half the difference between the highest and the lowest that what lies `aside` from the middle gets in a
/// stroke, and the phase at which it is highest.
struct Swing {
  double reach, highest;
};
Swing swing(Surface (*animal)(double), double aside) {
  constexpr int kPhases = 48;
  double low = 1, high = -1, at = 0;
  std::size_t vertex = 0;
  Surface rest = animal(0);
  for (std::size_t i = 0; i < rest.position.size(); ++i)
    if (std::abs(rest.position[i].x - aside) < std::abs(rest.position[vertex].x - aside)) vertex = i;
  for (int k = 0; k < kPhases; ++k) {
    double up = static_cast<double>(animal(static_cast<double>(k) / kPhases).position[vertex].z);
    low = std::min(low, up);
    if (up > high) high = up, at = static_cast<double>(k) / kPhases;
  }
  return {(high - low) / 2, at};
}

TEST(School, EyesStandOutOfTheHead) {
  const FishForm form;
  const Vec2 eye = fish_eye(form);
  auto head = [&](double width) {
    float out = 0;
    for (Vec3 p : fish_surface(form, width, 0, 0).position)
      if (std::hypot(0.5f - p.y - eye.x, p.z - eye.y) < 0.02f) out = std::max(out, std::abs(p.x));
    return out;
  };
  EXPECT_GT(head(0.06), head(0) + 0.005f);
}

TEST(School, TheBodyClosesWhereTheTailBegins) {
  const FishForm form;
  auto thickness = [&](double from, double to) {
    float least = 1, most = -1;
    for (Vec3 p : fish_surface(form, 0, 0, 0).position)
      if (double along = 0.5 - static_cast<double>(p.y); along > from && along < to)
        least = std::min(least, p.x), most = std::max(most, p.x);
    return most - least;
  };
  EXPECT_LT(thickness(kFishBody - 0.001, kFishBody + 0.001), 0.15f * thickness(0.55, 0.6));
}

TEST(School, BackAndBellyAreArchedApartAtTheSameDepth) {
  FishForm form;
  form.arch = 0.3;
  for (double at : {0.1, 0.4, 0.8}) {
    double up = fish_height(form, at, 1), down = fish_height(form, at, -1);
    EXPECT_NEAR(up + down, 2 * fish_depth(form, at), 1e-12);
    EXPECT_NEAR(up / down, 1.3 / 0.7, 1e-9);
  }
}

TEST(School, AFinWithSpinesIsNotchedBetweenThem) {
  FishForm form;
  form.dorsal = 0.2;
  auto peaks = [&] {
    std::vector<std::pair<double, double>> rim;  // along the fish, and how high by the fin's height there
    for (Vec3 p : fish_surface(form, 0, 0, 0).position) {
      double along = 0.5 - static_cast<double>(p.y), fin = dorsal_height(form, along);
      double share =
          (static_cast<double>(p.z) - fish_height(form, along / kFishBody, 1)) / std::max(fin, 1e-6);
      if (along > 0.3 && along < 0.58 && share > 0.7) rim.emplace_back(along, share);
    }
    std::ranges::sort(rim);
    int count = 0;
    for (std::size_t k = 1; k + 1 < rim.size(); ++k)
      count += rim[k].second > rim[k - 1].second && rim[k].second > rim[k + 1].second;
    return count;
  };
  EXPECT_GE(peaks(), 5);
  form.dorsal_shape = DorsalShape::ribbon;
  EXPECT_LE(peaks(), 2);
}

TEST(School, HeightsOfTheSkinAreOfTheShapeAlone) {
  FishParams fish;
  FishLook red = fish.look;
  red.flank = {1, 0, 0}, red.pattern = FishPattern::bars;
  EXPECT_EQ(fish_relief_name(fish.form, fish.look), fish_relief_name(fish.form, red));
  const std::string bytes = (*fish_relief(fish.form, fish.look).draw())[0].bytes;
  const Raster heights = *read_png(bytes);
  // The gill cover stands off: before its edge the skin is higher than behind it.
  auto height = [&](double along) {
    return heights.at(static_cast<int>(along * heights.width), heights.height / 2, 0);
  };
  EXPECT_GT(height(0.195), height(0.215) + 20);
}

TEST(School, LightPassesThroughFinsBetweenTheirRays) {
  FishParams fish;
  auto opacities = [&] {
    const std::string bytes = (*swimmer_drawing(fish.animal, fish.form, fish.look).draw())[0].bytes;
    const Raster picture = *read_png(bytes);
    std::pair<int, int> both{255, 255};  // of the body's middle, and the least
    if (picture.channels < 4) return both;
    both.first = picture.data[picture.index(picture.width * 2 / 5, picture.height / 2) + 3];
    for (std::size_t i = 3; i < picture.data.size(); i += 4)
      both.second = std::min<int>(both.second, picture.data[i]);
    return both;
  };
  EXPECT_EQ(opacities().first, 255);
  EXPECT_LT(opacities().second, 180);
  fish.look.clear = 0;
  EXPECT_EQ(opacities().second, 255);
}

TEST(School, EveryAnimalIsASoundMeshOneUnitLarge) {
  for (SeaAnimal animal : {SeaAnimal::fish, SeaAnimal::turtle, SeaAnimal::manta, SeaAnimal::jellyfish}) {
    FishParams params;
    params.animal = animal;
    std::vector<Prototype> shapes = swimmer_prototypes(params);
    EXPECT_EQ(shapes.size(), static_cast<std::size_t>(kShapes));
    for (const Prototype& shape : shapes) {
      const Surface& mesh = shape.parts[0].surface;
      EXPECT_EQ(mesh.find_fault(), "") << shape.name;
      EXPECT_EQ(mesh.uv.size(), mesh.position.size()) << shape.name;
      EXPECT_LT(mesh.triangle.size(), 12000u) << shape.name;
    }
  }
  float wide = 0;
  for (Vec3 p : manta_surface(0).position) wide = std::max(wide, 2 * p.x);
  EXPECT_NEAR(wide, 1, 0.12) << "from wingtip to wingtip";
}

TEST(School, AWaveRunsOutOverTheWings) {
  for (auto animal : {manta_surface, turtle_surface}) {
    // Of a wing at 60 and at 95 hundredths of its reach.
    float reach = 0;
    for (Vec3 p : animal(0).position) reach = std::max(reach, p.x);
    Swing middle = swing(animal, 0.6 * static_cast<double>(reach)),
          tip = swing(animal, 0.95 * static_cast<double>(reach));
    EXPECT_GT(tip.reach, 1.4 * middle.reach);
    double later = tip.highest - middle.highest;
    EXPECT_GT(later - std::floor(later), 0.01) << "the tip follows";
    EXPECT_LT(later - std::floor(later), 0.35);
  }
}

TEST(School, WingsKeepTheirSidesAlike) {
  for (auto animal : {manta_surface, turtle_surface})
    for (double phase : {0.1, 0.35, 0.8}) {
      Vec3 sum(0);
      Surface mesh = animal(phase);
      for (const auto& triangle : mesh.triangle) {
        Vec3 middle =
            (mesh.position[triangle[0]] + mesh.position[triangle[1]] + mesh.position[triangle[2]]) / 3.0f;
        sum += glm::length(area_of(mesh, triangle)) * middle;
      }
      EXPECT_NEAR(sum.x, 0, 0.004) << "it would roll over";
    }
}

TEST(School, AJellyfishContractsFasterThanItOpens) {
  constexpr int kPhases = 200;
  auto held = [](int k) {  // water under its bell, by rings
    double sum = 0, phase = static_cast<double>(k) / kPhases;
    for (int i = 0; i < 40; ++i) {
      Vec2 a = bell_profile(i / 40.0, phase), b = bell_profile((i + 1) / 40.0, phase);
      sum += kPi * static_cast<double>(a.x * b.x) * static_cast<double>(a.y - b.y);
    }
    return sum;
  };
  int shrinks = 0;
  double least = 1, most = 0;
  for (int k = 0; k < kPhases; ++k) {
    shrinks += held(k + 1) < held(k);
    least = std::min(least, held(k)), most = std::max(most, held(k));
  }
  EXPECT_LT(shrinks, 0.4 * kPhases) << "of the pulse";
  EXPECT_GT(shrinks, 0.15 * kPhases);
  EXPECT_LT(least, 0.85 * most) << "water is driven out";
}

TEST(School, LooksVaryAndStayWhereTheFilmBeginsAgain) {
  SchoolParams params;
  EXPECT_EQ(looks_of(params.fish).size(), 1u);
  params.fish.variation = 0.2;
  SwimTask swims = task();
  swims.looks = static_cast<std::size_t>(look_count(params.fish));
  Trajectory made = swim(swims, 2.2, 0, clearance_of(*reef(), Vec3(-3, -1, -3), Vec3(3, 3, 3), 0.1f));
  Organs first = school_organs(params, made, 0);
  std::set<std::int32_t> looks(first.color.begin(), first.color.end());
  EXPECT_EQ(looks.size(), looks_of(params.fish).size());
  for (std::size_t i = 0; i < first.color.size(); ++i)
    EXPECT_EQ(first.color[i], first.color[static_cast<std::size_t>(made.next[i])]);
}

TEST(School, WhatRestsBetweenStrokesBeatsForwardInEveryFilm) {
  for (int count : {1, 7}) {
    SwimTask swims = task();
    swims.count = count, swims.film = 3, swims.length = 4, swims.idle = 0;
    Trajectory made = swim(swims, 3, 0, clearance_of(*reef(), Vec3(-3, -1, -3), Vec3(3, 3, 3), 0.1f));
    for (int i = 0; i < count; ++i) {
      for (int s = 1; s <= made.steps; ++s)
        EXPECT_GE(made.stroke[made.at(s, i)], made.stroke[made.at(s - 1, i)] - 1e-4f);
      EXPECT_GE(made.stroke[made.at(made.steps, i)] - made.stroke[made.at(0, i)], 0.49f);
    }
  }
}

TEST(School, LargeAnimalsTurnSlowly) {
  auto turned = [](double most) {
    SwimTask swims = task();
    swims.count = 1, swims.film = 30;
    swims.params.turn = most, swims.params.current = Vec3(0);
    Trajectory made = swim(swims, 2.2, 0, clearance_of(*reef(), Vec3(-3, -1, -3), Vec3(3, 3, 3), 0.1f));
    double sum = 0;
    for (int k = 0; k < 400; ++k) sum += std::abs(static_cast<double>(fish_at(made, 0, k / 20.0).turn));
    return sum;
  };
  EXPECT_LT(turned(0.3), 0.8 * turned(5));
}

TEST(School, DistancesAreThoseOfTheBodies) {
  Clearance grid(Vec3(-1), Vec3(1), 0.05f);
  grid.add(Vec3(0), 0.2f);
  grid.measure();
  for (float x : {0.4f, 0.6f, 0.9f}) EXPECT_NEAR(grid({x, 0.03f, -0.02f}), x - 0.2f, 0.06f);
  EXPECT_GT(grid.away({0.6f, 0, 0}).x, 0.8f);
}

}  // namespace
}  // namespace frond
