#include "foliage/floral_diagram.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "foliage/whorl_members.h"

namespace frond {
namespace {

Whorl whorl(FloralPart part, int count) {
  Whorl w;
  w.part = part;
  w.count = count;
  return w;
}

/// The flower of a mallow: K5 C5 A10 G(3).
FloralDiagram regular(int count = 5) {
  FloralDiagram d;
  d.whorls = {whorl(FloralPart::sepals, count), whorl(FloralPart::petals, count),
              whorl(FloralPart::stamens, 2 * count), whorl(FloralPart::carpels, 3)};
  return d;
}

/// How far a place lies from the axis.
double radius_of(Vec3 p) { return std::hypot(static_cast<double>(p.x), static_cast<double>(p.z)); }

double turned(double from, double to) { return std::remainder(to - from, 2 * kPi); }

TEST(FloralDiagram, WhorlsHaveTheirMembersAtEvenAnglesAndAlternate) {
  for (int count : {1, 2, 3, 4, 5, 6, 8}) {
    FloralDiagram d = regular(count);
    std::vector<double> sepals = azimuths(d, 0), petals = azimuths(d, 1);
    ASSERT_EQ(sepals.size(), static_cast<std::size_t>(count));
    EXPECT_EQ(sepals[0], 0) << "the first sepal is on the upper side";
    for (std::size_t k = 0; k < petals.size(); ++k) {
      double step = turned(petals[k], petals[(k + 1) % petals.size()]);
      EXPECT_NEAR(std::abs(turned(step, 2 * kPi / count)), 0, 1e-9);
      for (double sepal : sepals) EXPECT_GE(std::abs(turned(sepal, petals[k])), kPi / count - 1e-9);
    }
    d.whorls[1].turn = 0;
    EXPECT_NEAR(turned(azimuths(d, 0)[0], azimuths(d, 1)[0]), 0, 1e-9) << "unless the diagram says so";
  }
}

TEST(FloralDiagram, SpiralsStepByTheGoldenAngle) {
  FloralDiagram d = regular();
  d.whorls[1].count = 30;
  d.whorls[1].spiral.emplace();
  std::vector<double> all = azimuths(d, 1);
  for (std::size_t k = 1; k < all.size(); ++k) EXPECT_NEAR(turned(all[k - 1], all[k]), kGoldenAngle, 1e-9);
}

TEST(FloralDiagram, MembersOfATubeShareTheirEdges) {
  for (double slant : {0.0, 0.15}) {
    FloralDiagram d = regular();
    d.whorls[1].fused = 0.6;
    d.whorls[1].slant = slant;
    d.whorls[1].lower.emplace().length = 1.4;
    for (double stage : {0.0, 0.3, 0.7, 1.0, 1.6}) {
      WhorlBlades blades(d, 1, stage);
      for (std::size_t k = 0; k < 5; ++k)
        for (double t : {0.0, 0.2, 0.5, 0.6})
          EXPECT_LT(glm::distance(blades.at(k, t, 1), blades.at((k + 1) % 5, t, -1)), 1e-5f)
              << stage << ' ' << t;
      EXPECT_GT(glm::distance(blades.at(0, 0.9, 1), blades.at(1, 0.9, -1)), 1e-3f) << "lobes are free";
    }
  }
}

TEST(FloralDiagram, TwoSidedWhorlsAreTheirOwnMirrorImage) {
  for (Aestivation aestivation : {Aestivation::valvate, Aestivation::imbricate, Aestivation::contorted}) {
    FloralDiagram d = regular();
    Whorl& w = d.whorls[1];
    w.aestivation = aestivation;
    w.wave = 0.5;
    w.upper.emplace().length = 1.3;
    w.lower.emplace().open = radians(20.0);
    for (double stage : {0.0, 0.5, 1.0}) {
      WhorlBlades blades(d, 1, stage);
      std::vector<double> all = azimuths(d, 1);
      for (std::size_t k = 0; k < 5; ++k) {
        std::size_t other = 0;
        while (std::abs(turned(all[other], -all[k])) > 1e-6) ++other;
        for (double t : {0.1, 0.5, 0.9})
          for (double s : {-1.0, -0.4, 0.0, 0.7}) {
            Vec3 p = blades.at(k, t, s), q = blades.at(other, t, -s);
            EXPECT_LT(glm::distance(p, Vec3(-q.x, q.y, q.z)), 1e-5f);
          }
      }
    }
  }
}

TEST(FloralDiagram, ClosedBudsFitIntoTheirWidth) {
  for (double bud : {0.2, 0.35, 0.6})
    for (Aestivation aestivation : {Aestivation::valvate, Aestivation::imbricate, Aestivation::contorted})
      for (double fused : {0.0, 0.6}) {
        FloralDiagram d = regular();
        d.bud = bud;
        d.whorls[1].aestivation = aestivation;
        d.whorls[1].fused = fused;
        d.whorls[1].wave = 1;
        double widest = 0, open = 0;
        for (const Prototype& piece : flower_prototypes(d, 0))
          for (const OrganPart& part : piece.parts)
            for (Vec3 p : part.surface.position) widest = std::max(widest, radius_of(p));
        for (const Prototype& piece : flower_prototypes(d, 1))
          for (const OrganPart& part : piece.parts)
            for (Vec3 p : part.surface.position) open = std::max(open, radius_of(p));
        EXPECT_LE(widest, 0.5 * bud * 1.001) << bud << ' ' << fused;
        EXPECT_GT(open, 1.5 * widest);
      }
}

/// The least distance, along the midrib's normal, of a blade from its neighbour where both lie over each
/// other, by the sign that they have at the middle of the overlap; below 0 they cut.
double clearance(const WhorlBlades& blades, std::size_t k, std::size_t next, double sector) {
  constexpr int kSamples = 16;
  double least = 1;
  for (double t : {0.15, 0.3, 0.45, 0.6, 0.75, 0.9}) {
    double rim = blades.rim_angle(k, t), other = blades.rim_angle(next, t), overlap = rim + other - sector;
    if (overlap < 1e-6) continue;
    std::vector<double> apart;
    Vec3 up = blades.at(k, t, 0, 0.001) - blades.at(k, t, 0);
    double cosine = -(radius_of(blades.at(k, t, 0, 0.001)) - radius_of(blades.at(k, t, 0))) / 0.001,
           sine = static_cast<double>(up.y) / 0.001;
    for (int i = 0; i <= kSamples; ++i) {
      double a = sector - other + overlap * i / kSamples;
      Vec3 p = blades.at(k, t, a / rim), q = blades.at(next, t, (a - sector) / other);
      apart.push_back((static_cast<double>(p.y) - static_cast<double>(q.y)) * sine -
                      (radius_of(p) - radius_of(q)) * cosine);
    }
    double sign = apart[kSamples / 2] < 0 ? -1 : 1;
    for (double d : apart) least = std::min(least, sign * d);
  }
  return least;
}

TEST(FloralDiagram, NeighboursTouchAndDoNotCut) {
  for (Aestivation aestivation : {Aestivation::valvate, Aestivation::imbricate, Aestivation::contorted})
    for (int count : {3, 4, 5, 6})
      for (double cup : {-0.3, 0.0, 0.5})
        for (double stage : {0.0, 0.5, 0.8, 1.0}) {
          FloralDiagram d = regular(count);
          Whorl& w = d.whorls[1];
          w.aestivation = aestivation;
          w.cup = cup;
          w.fold = radians(12.0);
          w.width = 1.1;
          WhorlBlades blades(d, 1, stage);
          for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k)
            EXPECT_GT(clearance(blades, k, (k + 1) % static_cast<std::size_t>(count), 2 * kPi / count), -1e-6)
                << static_cast<int>(aestivation) << ' ' << count << ' ' << cup << ' ' << stage;
        }
}

TEST(FloralDiagram, HasAsManyPiecesAtAllStages) {
  FloralDiagram d = regular();
  d.whorls[1].lower.emplace().colors = {{1, 0, 0}};
  d.whorls[1].marks.emplace();
  d.whorls[1].falls = true;
  std::size_t pieces = 1;  // the receptacle
  for (std::size_t i = 0; i < d.whorls.size(); ++i) pieces += static_cast<std::size_t>(pieces_of(d, i));
  EXPECT_EQ(pieces, 7u);
  for (double stage : {0.0, 0.4, 1.0, 1.3, 2.0}) {
    std::vector<Prototype> made = flower_prototypes(d, stage);
    ASSERT_EQ(made.size(), pieces);
    EXPECT_EQ(made[1].parts.empty(), stage == 2.0) << "petals fall";
    EXPECT_FALSE(made[0].parts.empty()) << "sepals stay";
    for (const Prototype& piece : made)
      for (const OrganPart& part : piece.parts) {
        EXPECT_EQ(part.surface.find_fault(), "");
        EXPECT_FALSE(part.surface.triangle.empty());
      }
  }
}

TEST(FloralDiagram, TubesHaveNoSeam) {
  FloralDiagram d = regular();
  d.whorls[1].fused = 0.7;
  const Surface s = flower_prototypes(d, 1)[1].parts[0].surface;
  std::size_t shared = 0;
  for (std::size_t i = 0; i < s.position.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (glm::distance(s.position[i], s.position[j]) < 1e-6f && s.uv[i].x < 0.69f && s.uv[i].x > 0.01f) {
        ++shared;
        EXPECT_LT(glm::distance(s.normal[i], s.normal[j]), 1e-4f);
      }
  EXPECT_GT(shared, 10u);
}

TEST(FloralDiagram, WithersFromTheOpenFlower) {
  FloralDiagram d = regular();
  Color open = flower_prototypes(d, 1)[1].colors[0], gone = flower_prototypes(d, 2)[1].colors[0];
  EXPECT_NE(open, gone);
  double least = std::abs(gone.red - d.faded.red) + std::abs(gone.green - d.faded.green);
  EXPECT_LT(least, std::abs(open.red - d.faded.red) + std::abs(open.green - d.faded.green));
  EXPECT_LT(opening_of(FloralPart::petals, 2).grown, 1);
  EXPECT_GT(opening_of(FloralPart::carpels, 2).grown, 1) << "the fruit sets";
}

}  // namespace
}  // namespace frond
