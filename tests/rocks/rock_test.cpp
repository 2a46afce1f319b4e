#include "rocks/rock.h"

#include <gtest/gtest.h>

#include <cmath>

#include "closed.h"

namespace frond {
namespace {

RockShape quick() {
  RockShape shape;
  shape.cells = {5, 0.001};
  return shape;
}

Box box_of(const Surface& s) {
  Box box{DVec3(1e9), DVec3(-1e9)};
  for (Vec3 p : s.position) box.low = glm::min(box.low, DVec3(p)), box.high = glm::max(box.high, DVec3(p));
  return box;
}

TEST(Rock, IsOneClosedPieceOnTheGround) {
  for (std::uint64_t i = 0; i < 20; ++i) {
    RockShape shape = quick();
    shape.weathering.strata = i % 2 ? 0.5 : 0;
    Surface rock = rock_surface(shape, Seed{i});
    EXPECT_EQ(rock.find_fault(), "");
    EXPECT_EQ(count_pieces(rock), 1) << i;
    Body body = body_of(rock);
    EXPECT_EQ(body.loose, 0u);
    EXPECT_GT(body.volume, 0.01);
    Box box = box_of(rock);
    EXPECT_NEAR(box.low.y, 0, 1e-3);
    EXPECT_GT(box.size().x, 0.25);
    EXPECT_LT(std::max(box.size().x, box.size().z), 0.85);
    // Its underside is flat: a good part of its shadow stands on the ground.
    double shadow = 0, foot = 0;
    for (auto [a, b, c] : rock.triangle) {
      double area =
          0.5 * glm::cross(rock.position[b] - rock.position[a], rock.position[c] - rock.position[a]).y;
      if (area > 0) shadow += area;
      if (rock.position[a].y + rock.position[b].y + rock.position[c].y < 0.03) foot -= area;
    }
    EXPECT_GT(foot, 0.2 * shadow) << i;
  }
}

TEST(Rock, BareOneIsTheSurfaceOfItsBlobs) {
  RockShape shape = quick();
  for (std::uint64_t i = 0; i < 8; ++i) {
    Blobs blobs = rock_blobs(shape, Seed{i});
    Surface rock = bare_rock(shape, blobs);
    Isosurface native = native_rock(shape, blobs);
    for (Vec3 p : rock.position) {
      DVec3 place = DVec3(p) / native.unit + native.origin;
      EXPECT_NEAR(field_value(blobs, place), 0, 1e-5);
      EXPECT_TRUE(glm::all(glm::lessThan(native.box.low, place)) &&
                  glm::all(glm::lessThan(place, native.box.high)));
      EXPECT_LE(glm::length(field_gradient(blobs, place)), native.steepest);
    }
    Box box = box_of(rock);
    double longest = std::max(box.size().x, std::max(box.size().y, box.size().z));
    EXPECT_GT(longest, 0.55);
    EXPECT_LE(longest, 0.6 + 1e-6);
    EXPECT_LE(box.size().y, 1.05 * std::min(box.size().x, box.size().z));  // it lies
    // The bound of the gradient is not so large that tracing crawls.
    double steepest = 0;
    for (std::uint64_t k = 0; k < 3000; ++k) {
      Seed s = Seed{i}.child("p", k);
      DVec3 p =
          native.box.low + native.box.size() * DVec3(s.child(0).unit(), s.child(1).unit(), s.child(2).unit());
      steepest = std::max(steepest, glm::length(field_gradient(blobs, p)));
    }
    EXPECT_LE(steepest, native.steepest);
    EXPECT_LT(native.steepest, 3 * steepest);
  }
}

TEST(Rock, LyingTurnsItButDoesNotMirrorIt) {
  RockShape shape = quick();
  for (std::uint64_t i = 0; i < 8; ++i) {
    shape.lying = false;
    Blobs before = rock_blobs(shape, Seed{i});
    shape.lying = true;
    Blobs after = rock_blobs(shape, Seed{i});
    auto handed = [](const Blobs& b) {
      auto at = [&](std::size_t k) { return b.blobs[k].radius * b.blobs[k].center; };
      return glm::dot(at(0) - at(3), glm::cross(at(1) - at(3), at(2) - at(3)));
    };
    EXPECT_NEAR(handed(before), handed(after), 1e-9);
  }
}

TEST(Rock, EachKindOfWeatheringShows) {
  RockShape shape = quick();
  shape.weathering = {.facets = 0, .facet_depth = 0, .roughness = 0, .strata = 0, .underside = 0};
  Surface bare = rock_surface(shape, Seed{2});
  EXPECT_EQ(bare.position, bare_rock(shape, rock_blobs(shape, Seed{2})).position);
  double volume = volume_of(bare);
  auto changed = [&](Weathering w) {
    shape.weathering = w;
    return volume_of(rock_surface(shape, Seed{2})) / volume - 1;
  };
  Weathering none = shape.weathering, one = none;
  one.facets = 10, one.facet_depth = 0.4;
  EXPECT_LT(changed(one), -0.05);
  one = none, one.strata = 0.6;
  EXPECT_LT(changed(one), -0.02);
  one = none, one.underside = 0.3;
  EXPECT_LT(changed(one), -0.1);
  one = none, one.roughness = 0.5;
  shape.weathering = one;
  Surface rough = rock_surface(shape, Seed{2});
  // The underside is put to the ground: compare what it does to the height of neighbours.
  double bent = 0, before = 0;
  for (std::size_t i = 0; i < rough.triangle.size(); ++i) {
    auto [a, b, c] = rough.triangle[i];
    bent += glm::length(rough.normal[a] - rough.normal[b]);
    before += glm::length(bare.normal[a] - bare.normal[b]);
  }
  EXPECT_GT(bent, 1.15 * before);
}

TEST(Rock, IsTheSameFromTheSameSeedOnly) {
  RockShape shape = quick();
  EXPECT_EQ(rock_surface(shape, Seed{1}).position, rock_surface(shape, Seed{1}).position);
  EXPECT_NE(rock_surface(shape, Seed{1}).position, rock_surface(shape, Seed{2}).position);
}

}  // namespace
}  // namespace frond
