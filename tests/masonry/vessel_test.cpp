#include "masonry/vessel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "core/bezier.h"
#include "masonry/block.h"
#include "solidity.h"

namespace frond {
namespace {

/// The volume of the body of revolution by Pappus of Alexandria: area times the path of its centroid. Cubic
/// metres.
double turned_volume(const std::vector<glm::dvec2>& outline) {
  // Area and first moment of the polygon that the axis closes: 2 pi times the integral of the radius.
  double moment = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    glm::dvec2 a = outline[i], b = outline[(i + 1) % outline.size()];
    moment += (a.x + b.x) * (a.x * b.y - a.y * b.x) / 6;
  }
  return 2 * kPi * moment;
}

/// Vases whose curves rise, of the given degree.
VesselShape random_vessel(int degree, Seed seed) {
  VesselShape shape;
  shape.profile.clear();
  for (int i = 0; i <= degree; ++i) {
    Seed own = seed.child(static_cast<std::uint64_t>(i));
    shape.profile.push_back({own.child("r").range(0.05, 0.2), 0.3 * i / degree});
  }
  return shape;
}

std::vector<VesselShape> vessels() {
  std::vector<VesselShape> all{VesselShape{}};
  for (int degree = 1; degree <= 20; ++degree)
    for (std::uint64_t i = 0; i < 3; ++i)
      all.push_back(random_vessel(degree, Seed{i}.child("degree", degree)));
  VesselShape bowl;  // a round bottom on a ring
  bowl.profile = {{0, 0}, {0.11, 0.0}, {0.14, 0.05}, {0.15, 0.08}};
  bowl.foot = 0.012;
  all.push_back(bowl);
  VesselShape flat = bowl;
  flat.foot = 0, flat.lip = 1;
  all.push_back(flat);
  VesselShape cone;
  cone.profile = {{0, 0}, {0.1, 0.3}};
  cone.foot_radius = 0.04;
  all.push_back(cone);
  VesselShape coarse;
  coarse.rings = 24;
  all.push_back(coarse);
  VesselShape giant;
  giant.height = 2, giant.wall = 0.05, giant.lip = 2, giant.foot = 0.1;
  all.push_back(giant);
  return all;
}

TEST(Vessel, IsAClosedBodyTurnedOutward) {
  for (const VesselShape& shape : vessels()) {
    auto profile = vessel_profile(shape);
    ASSERT_TRUE(profile) << profile.errors()[0].text();
    for (int sides : {3, 24}) {
      Surface s = vessel_surface(*profile, sides);
      ASSERT_EQ(s.find_fault(), "");
      EXPECT_EQ(solidity(s).open, 0u) << shape.profile.size();
      EXPECT_EQ(solidity(s).euler, 2) << shape.profile.size();
    }
  }
}

TEST(Vessel, HasTheVolumeThatPappusGives) {
  for (const VesselShape& shape : vessels()) {
    VesselProfile profile = *vessel_profile(shape);
    double turned = turned_volume(profile.outline);
    EXPECT_GT(turned, 0);
    for (int sides : {12, 96}) {
      // What a polygon has of the circle round it.
      double share = std::sin(2 * kPi / sides) / (2 * kPi / sides);
      EXPECT_NEAR(volume(vessel_surface(profile, sides)) / (turned * share), 1, 2e-4);
    }
  }
}

TEST(Vessel, PappusAgreesWithKnownBodies) {
  EXPECT_NEAR(turned_volume({{0, 0}, {2, 0}, {2, 3}, {0, 3}}), kPi * 4 * 3, 1e-12);
  EXPECT_NEAR(turned_volume({{0, 0}, {1, 0}, {0, 1}}), kPi / 3, 1e-12);
  std::vector<glm::dvec2> ring;
  for (int i = 0; i < 2000; ++i) {
    double a = 2 * kPi * i / 2000;
    ring.push_back({3 + std::cos(a), std::sin(a)});
  }
  EXPECT_NEAR(turned_volume(ring), 2 * kPi * 3 * kPi, 1e-3);
}

TEST(Vessel, TheWallIsAsThickAsAskedOrSaysWhyNot) {
  int full = 0;
  for (const VesselShape& shape : vessels()) {
    VesselProfile profile = *vessel_profile(shape);
    EXPECT_LE(profile.wall, shape.wall);
    EXPECT_EQ(profile.note.empty(), profile.wall == shape.wall);
    full += profile.note.empty();
    std::size_t first = 0;
    while (profile.curve[first] < 0) ++first;
    double start = profile.outline[first].y;
    // Each point of the inside is a wall's thickness away from the nearest of the outside, but for the lip
    // and the floor.
    for (std::size_t i = profile.inside + 12; i + 12 < profile.outline.size(); ++i) {
      double nearest = 1e9;
      for (std::size_t k = 1; k < profile.inside; ++k) {
        glm::dvec2 a = profile.outline[k - 1], way = profile.outline[k] - a;
        double t = std::clamp(glm::dot(profile.outline[i] - a, way) / glm::dot(way, way), 0.0, 1.0);
        nearest = std::min(nearest, glm::distance(profile.outline[i], a + way * t));
      }
      EXPECT_GT(nearest, 0.93 * profile.wall) << shape.profile.size() << ' ' << i;
      // Inside a wide foot all is solid.
      if (profile.outline[i].y < start + 3 * profile.wall) continue;
      EXPECT_LT(nearest, 1.9 * profile.wall * std::max(1.0, shape.lip)) << shape.profile.size() << ' ' << i;
    }
  }
  EXPECT_GT(full, 40);
}

TEST(Vessel, AWallThickerThanTheCurveBendsIsHeldBack) {
  VesselShape shape;
  shape.profile = {{0.03, 0}, {0.25, 0.02}, {0.25, 0.04}, {0.05, 0.06}};
  shape.wall = 0.02;
  VesselProfile profile = *vessel_profile(shape);
  EXPECT_LT(profile.wall, 0.02);
  EXPECT_NE(profile.note.find("thicker than"), std::string::npos);
  EXPECT_EQ(solidity(vessel_surface(profile, 24)).open, 0u);
}

TEST(Vessel, IsOpenAtTheTop) {
  for (const VesselShape& shape : vessels()) {
    VesselProfile profile = *vessel_profile(shape);
    // Looking down the axis one sees the floor.
    EXPECT_NEAR(profile.outline.back().x, 0, 1e-12);
    EXPECT_LT(profile.outline.back().y, 0.6 * profile.rim);
    double least = 1e9;
    for (std::size_t i = profile.inside;
         i < profile.outline.size() && profile.outline[i].y > 0.6 * profile.rim; ++i)
      least = std::min(least, profile.outline[i].x);
    EXPECT_GT(least, 0.004);
  }
}

TEST(Vessel, RefusesWhatCannotBeTurned) {
  auto words = [](std::vector<glm::dvec2> points) {
    VesselShape shape;
    shape.profile = std::move(points);
    auto profile = vessel_profile(shape);
    return profile ? std::string() : profile.errors()[0].what;
  };
  EXPECT_NE(words({{0.1, 0}}).find("expected 2 to 21"), std::string::npos);
  EXPECT_NE(words({{0.1, 0}, {-0.1, 1}}).find("expected 0 or more"), std::string::npos);
  EXPECT_NE(words({{0.1, 0}, {0, 1}}).find("axis"), std::string::npos);
  EXPECT_NE(words({{0.1, 1}, {0.1, 0}}).find("not higher"), std::string::npos);
  EXPECT_NE(words({{0.1, 0}, {1, -1}, {0.1, 0.1}}).find("dips below"), std::string::npos);
  EXPECT_NE(words({{0.02, 0}, {0.9, 0.9}, {0.02, 0.02}, {0.0, 0.9}, {0.9, 0.02}, {0.04, 0.05}, {0.04, 0.3}})
                .find("crosses"),
            std::string::npos);
}

TEST(Vessel, SpansFollowTheOutlineAndTheCurveExactly) {
  for (std::size_t count : {2u, 3u, 4u, 7u}) {
    VesselShape shape = random_vessel(static_cast<int>(count) - 1, Seed{12});
    shape.height = 0.4;
    VesselProfile profile = *vessel_profile(shape);
    auto spans = vessel_spans(shape, profile, 5e-5);
    EXPECT_LT(spans.size(), 70u);
    EXPECT_EQ(spans.front()[0], profile.outline.front());
    EXPECT_EQ(spans.back()[3], profile.outline.back());
    double scale = 0.4 / 0.3, worst = 0;
    for (std::size_t i = 0; i < spans.size(); ++i) {
      if (i > 0) {
        EXPECT_EQ(spans[i][0], spans[i - 1][3]);
      }
      for (double t : {0.25, 0.5, 0.75}) {
        glm::dvec2 p = bezier_jet(spans[i], t).at;
        double nearest = 1e9;
        for (std::size_t k = 1; k < profile.outline.size(); ++k) {
          glm::dvec2 a = profile.outline[k - 1], way = profile.outline[k] - a;
          double at = std::clamp(glm::dot(p - a, way) / glm::dot(way, way), 0.0, 1.0);
          nearest = std::min(nearest, glm::distance(p, a + way * at));
        }
        worst = std::max(worst, nearest);
      }
    }
    EXPECT_LT(worst, 2e-4) << count;
    if (count > 4) continue;
    // One span is the curve itself.
    auto longest = std::max_element(spans.begin(), spans.end(), [](const auto& a, const auto& b) {
      return a[3].y - a[0].y < b[3].y - b[0].y;
    });
    for (double t : {0.2, 0.5, 0.9}) {
      glm::dvec2 p = bezier_jet(*longest, t).at;
      double nearest = 1e9;
      for (int k = 0; k <= 20000; ++k) {
        glm::dvec2 q = bezier_jet(shape.profile, k / 20000.0).at * scale + glm::dvec2(0, shape.foot);
        nearest = std::min(nearest, glm::distance(p, q));
      }
      EXPECT_LT(nearest, 1.5e-5) << count;
    }
  }
}

TEST(Vessel, SoilFillsItToTheHeightAsked) {
  for (const VesselShape& shape : vessels()) {
    VesselProfile profile = *vessel_profile(shape);
    for (double share : {0.3, 0.85}) {
      Soil soil = vessel_soil(profile, share, 48, Seed{2});
      ASSERT_EQ(soil.surface.find_fault(), "");
      EXPECT_EQ(solidity(soil.surface).open, 0u) << shape.profile.size() << ' ' << share;
      EXPECT_EQ(solidity(soil.surface).euler, 2);
      EXPECT_GT(volume(soil.surface), 0);
      double asked = profile.floor + share * (profile.rim - profile.wall - profile.floor);
      EXPECT_NEAR(soil.height, asked, 0.25 * profile.rim);
      EXPECT_GE(soil.height, asked - 0.03 * profile.rim);
    }
  }
}

}  // namespace
}  // namespace frond
