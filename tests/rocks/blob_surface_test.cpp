#include "rocks/blob_surface.h"

#include <gtest/gtest.h>

#include <cmath>

#include "closed.h"
#include "core/parallel.h"
#include "rocks/falloffs.h"

namespace frond {
namespace {

/// How far the worst vertex or middle of a triangle is off the surface, as a share of the size.
double worst(const Blobs& shape, const BlobCells& cells, const Surface& surface) {
  double off = 0;
  auto look = [&](DVec3 p) {
    off = std::max(off, std::abs(field_value(shape, p)) / glm::length(field_gradient(shape, p)));
  };
  for (Vec3 p : surface.position) look(p);
  for (auto [a, b, c] : surface.triangle)
    look((DVec3(surface.position[a]) + DVec3(surface.position[b]) + DVec3(surface.position[c])) / 3.0);
  return off / cells.size;
}

/// A ball of that radius where its cubic field is a half.
Blob ball(DVec3 middle, double radius) {
  double r = radius / std::sqrt(1 - std::cbrt(0.5));
  // The radius comes in twice: the field is one of d^2/r^2, and d is in radii.
  r = std::sqrt(r);
  return {DVec3(r), middle / r};
}

TEST(BlobSurface, IsClosedAndTurnedOutward) {
  for (Falloff falloff : kFalloffs)
    for (std::uint64_t i = 0; i < 40; ++i) {
      Blobs shape{random_blobs({}, Seed{i}), falloff, 1};
      for (int depth : {3, 5}) {
        Surface surface = blob_surface(shape, {depth, i % 2 == 0 ? 0.002 : 0});
        EXPECT_EQ(surface.find_fault(), "");
        Body body = body_of(surface);
        EXPECT_EQ(body.loose, 0u) << i;
        EXPECT_EQ(body.euler % 2, 0) << i;
        EXPECT_GT(body.volume, 0.1);
        for (auto [a, b, c] : surface.triangle) {
          Vec3 area = glm::cross(surface.position[b] - surface.position[a],
                                 surface.position[c] - surface.position[a]);
          Vec3 sum = surface.normal[a] + surface.normal[b] + surface.normal[c];
          EXPECT_GE(glm::dot(area, sum), -1e-5f * glm::length(area));
        }
      }
    }
}

TEST(BlobSurface, HasTheTopologyOfTheBody) {
  auto euler = [](const std::vector<Blob>& blobs, int depth) {
    Body body = body_of(blob_surface({blobs, Falloff::cubic, 0.5}, {depth, 0.001}));
    EXPECT_EQ(body.loose, 0u);
    return body.euler;
  };
  std::vector<Blob> ring;
  for (int i = 0; i < 12; ++i)
    ring.push_back(ball(DVec3(std::cos(i * kPi / 6), 0.1, std::sin(i * kPi / 6)), 0.3));
  for (int depth = 3; depth <= 7; ++depth) {
    EXPECT_EQ(euler({ball(DVec3(0.3), 1)}, depth), 2);
    EXPECT_EQ(euler({ball(DVec3(-2, 0, 0), 0.5), ball(DVec3(2, 0, 0), 0.5)}, depth), 4);
    EXPECT_EQ(euler(ring, depth), 0);
  }
}

TEST(BlobSurface, LiesOnTheTrueOne) {
  for (Falloff falloff : kFalloffs)
    for (std::uint64_t i = 0; i < 4; ++i) {
      Blobs shape{random_blobs({}, Seed{i}), falloff, 1};
      BlobCells cells = cut_cells(shape, {8, 0.0003});
      EXPECT_LT(worst(shape, cells, blob_surface(shape, cells)), 0.001);
    }
}

TEST(BlobSurface, OfABallIsABall) {
  Blobs shape{{ball(DVec3(1, 2, 3), 0.7)}, Falloff::cubic, 0.5};
  Surface surface = blob_surface(shape, {6, 0.0003});
  for (std::size_t i = 0; i < surface.position.size(); ++i) {
    Vec3 out = surface.position[i] - Vec3(1, 2, 3);
    EXPECT_NEAR(glm::length(out), 0.7, 1e-6);
    EXPECT_GT(glm::dot(surface.normal[i], out) / 0.7f, 0.99999f);
  }
  EXPECT_NEAR(body_of(surface).volume, 4 * kPi / 3 * 0.343, 0.002);
}

TEST(BlobSurface, VolumeConvergesWithDepth) {
  for (std::uint64_t i = 0; i < 3; ++i) {
    Blobs shape{random_blobs({}, Seed{i}), Falloff::gaussian, 1};
    std::vector<double> volume;
    for (int depth = 5; depth <= 8; ++depth) volume.push_back(volume_of(blob_surface(shape, {depth, 0})));
    // Errors fall with the square of the width of cells: each step to a quarter of the one before.
    for (std::size_t k = 2; k < volume.size(); ++k) {
      double step = std::abs(volume[k] - volume[k - 1]), before = std::abs(volume[k - 1] - volume[k - 2]);
      EXPECT_LT(step, 0.35 * before) << k;
    }
    EXPECT_NEAR(volume_of(blob_surface(shape, {7, 0.0003})), volume.back(), 0.002 * volume.back());
  }
}

/// Whether each place where random lines pass through the surface has a vertex nearby.
void expect_all_found(const Blobs& shape, int depth, std::uint64_t number) {
  BlobCells cells = cut_cells(shape, {depth, 0});
  Surface surface = blob_surface(shape, cells);
  double width = cells.root.size().x / (1 << depth);
  int roots = 0;
  for (std::uint64_t line = 0; line < 60; ++line) {
    Seed seed = Seed{number}.child("line", line);
    auto at = [&](const char* name) {
      Seed s = seed.child(name);
      return cells.root.low +
             cells.root.size() * DVec3(s.child(0).unit(), s.child(1).unit(), s.child(2).unit());
    };
    DVec3 from = at("from"), to = at("to");
    constexpr int kSamples = 400;
    for (int k = 0; k < kSamples; ++k) {
      DVec3 p = glm::mix(from, to, k / double(kSamples)), q = glm::mix(from, to, (k + 1) / double(kSamples));
      if ((field_value(shape, p) > 0) == (field_value(shape, q) > 0)) continue;
      ++roots;
      double nearest = 1e9;
      for (Vec3 v : surface.position) nearest = std::min(nearest, glm::distance(DVec3(v), (p + q) * 0.5));
      EXPECT_LT(nearest, 1.5 * width);
    }
  }
  EXPECT_GT(roots, 10);
}

TEST(BlobSurface, MissesNoRootOnRandomLines) {
  for (Falloff falloff : kFalloffs)
    for (std::uint64_t i = 0; i < 10; ++i)
      expect_all_found({random_blobs({}, Seed{i}), falloff, 1}, 4 + static_cast<int>(i % 2), i);
}

TEST(BlobSurface, FindsABlobFarSmallerThanACoarseCell) {
  // At depth 3 a cell is 0.6 wide; the small one is 0.005.
  for (std::uint64_t i = 0; i < 30; ++i) {
    Seed seed = Seed{i}.child("at");
    DVec3 at(1.9 + 0.3 * seed.child(0).unit(), seed.child(1).range(-1, 1), seed.child(2).range(-1, 1));
    Blobs shape{{ball(DVec3(-1, 0, 0), 1), ball(at, 0.005)}, Falloff::cubic, 0.5};
    Surface surface = blob_surface(shape, {3, 0.01});
    Body body = body_of(surface);
    EXPECT_EQ(body.euler, 4);
    EXPECT_EQ(body.loose, 0u);
    int near = 0;
    for (Vec3 p : surface.position) near += glm::distance(DVec3(p), at) < 0.006;
    EXPECT_GE(near, 6);
    EXPECT_LT(surface.position.size(), 3000u);
  }
}

TEST(BlobSurface, IsTheSameOnAnyNumberOfThreads) {
  Blobs shape{random_blobs({}, Seed{5}), Falloff::gaussian, 1};
  Surface many = blob_surface(shape, {6, 0.0003});
  limit_threads(1);
  Surface one = blob_surface(shape, {6, 0.0003});
  limit_threads(0);
  EXPECT_EQ(many.position, one.position);
  EXPECT_EQ(many.triangle, one.triangle);
}

TEST(BlobSurface, OfNothingIsEmpty) {
  EXPECT_TRUE(blob_surface({}).triangle.empty());
  EXPECT_TRUE(blob_surface({{{DVec3(1), DVec3(0)}}, Falloff::gaussian, 1}).triangle.empty());
}

}  // namespace
}  // namespace frond
