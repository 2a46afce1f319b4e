#include "foliage/mosaic.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/seed.h"
#include "foliage/ivy_leaf.h"

namespace frond {
namespace {

/// Petioles of several lengths and slopes, as ivy has them.
std::vector<IvyLeafShape> shapes() {
  std::vector<IvyLeafShape> list;
  for (double stalk : {0.5, 0.9, 1.3})
    for (double rise : {35.0, 65.0}) {
      IvyLeafShape shape;
      shape.stalk = stalk, shape.rise = radians(rise);
      list.push_back(shape);
    }
  return list;
}

std::vector<LeafForm> forms() {
  std::vector<LeafForm> list;
  for (const IvyLeafShape& shape : shapes()) {
    LeafDisc disc = ivy_disc(shape);
    list.push_back({{{disc.middle, Vec3(0, 0, 1), disc.radius}}});
  }
  return list;
}

/// Sites along strands that climb a wall two metres wide and high, about as dense as its leaves can lie.
std::vector<MosaicSite> wall_sites(int strands, int each) {
  std::vector<MosaicSite> sites;
  for (int k = 0; k < each; ++k)
    for (int s = 0; s < strands; ++s) {
      Seed own = Seed{7}.child(static_cast<std::uint64_t>(s * each + k));
      MosaicSite site;
      float side = k % 2 ? 1.0f : -1.0f;
      site.foot = Vec3(2.0f * (static_cast<float>(s) + 0.5f) / static_cast<float>(strands) +
                           static_cast<float>(own.child(0).range(-0.04, 0.04)),
                       2.0f * static_cast<float>(k) / static_cast<float>(each), 0);
      site.normal = glm::normalize(Vec3(0, 0.4f, 1));
      site.tip = Vec3(0.5f * side, -1, 0);
      site.size = static_cast<float>(own.child(1).range(0.045, 0.07));
      site.forms = 6;
      sites.push_back(site);
    }
  return sites;
}

/// The area of the outlines that lies under other outlines, measured on a raster of the wall of 2 mm.
double overlap_area(const std::vector<MosaicSite>& sites, const std::vector<LaidLeaf>& laid) {
  constexpr double kCell = 0.002;
  constexpr int kSide = 1200;
  std::vector<std::uint8_t> count(kSide * kSide, 0);
  std::vector<IvyLeafShape> list = shapes();
  for (const LaidLeaf& leaf : laid) {
    const MosaicSite& site = sites[leaf.site];
    Vec3 foot = site.foot + leaf.turn * (ivy_attachment(list[leaf.form]) * site.size);
    Vec3 right = leaf.turn * Vec3(1, 0, 0), along = leaf.turn * Vec3(0, 1, 0);
    int reach = static_cast<int>(1.15 * site.size / kCell);
    int x = static_cast<int>(std::floor((foot.x + 0.2) / kCell));
    int y = static_cast<int>(std::floor((foot.y + 0.2) / kCell));
    for (int j = std::max(0, y - reach); j <= std::min(kSide - 1, y + reach); ++j)
      for (int i = std::max(0, x - reach); i <= std::min(kSide - 1, x + reach); ++i) {
        // Seen from the front: the place of the blade that has this x and y.
        double dx = i * kCell - 0.2 - foot.x, dy = j * kCell - 0.2 - foot.y;
        double det = right.x * along.y - right.y * along.x;
        double u = (dx * along.y - dy * along.x) / det / site.size,
               v = (right.x * dy - right.y * dx) / det / site.size;
        if (std::hypot(u, v) < ivy_rim(list[leaf.form].form, std::atan2(u, v)))
          ++count[static_cast<std::size_t>(j * kSide + i)];
      }
  }
  double cells = 0;
  for (std::uint8_t n : count) cells += n > 1 ? n - 1 : 0;
  return cells * kCell * kCell;
}

TEST(Mosaic, OverlapsAFifthOfWhatNaiveLeavesDo) {
  std::vector<MosaicSite> sites = wall_sites(26, 60);
  MosaicOptions options;
  options.overlap = 0.06;
  std::vector<LaidLeaf> laid = lay_leaves(sites, forms(), options);
  ASSERT_GT(laid.size(), 400u);
  // As many leaves on the same strands without looking: side by side, each as it likes best.
  std::vector<LaidLeaf> naive;
  for (std::size_t i = 0; i < laid.size(); ++i) {
    auto site = static_cast<std::uint32_t>(i * sites.size() / laid.size());
    auto form = static_cast<std::uint32_t>(Seed{9}.child(i).bits() % 6);
    naive.push_back({site, form, leaf_turn(sites[site].normal, sites[site].tip), 0});
  }
  double ours = overlap_area(sites, laid), theirs = overlap_area(sites, naive);
  RecordProperty("ratio", std::to_string(theirs / ours));
  EXPECT_LT(5 * ours, theirs) << laid.size() << " leaves, " << ours << " m2 against " << theirs;
}

TEST(Mosaic, CoversMoreWhereMoreOverlapIsAllowed) {
  std::vector<MosaicSite> sites = wall_sites(26, 60);
  MosaicOptions none, some, all;
  none.overlap = 0, some.overlap = 0.3, all.overlap = 100;
  std::size_t a = lay_leaves(sites, forms(), none).size(), b = lay_leaves(sites, forms(), some).size(),
              c = lay_leaves(sites, forms(), all).size();
  EXPECT_LT(a, b);
  EXPECT_LT(b, c);
  EXPECT_EQ(c, sites.size());
  for (const LaidLeaf& leaf : lay_leaves(sites, forms(), some)) EXPECT_LE(leaf.covered, 0.3f);
}

TEST(Mosaic, LeavesLookWhereTheyShould) {
  std::vector<MosaicSite> sites = wall_sites(10, 20);
  for (const LaidLeaf& leaf : lay_leaves(sites, forms(), {})) {
    EXPECT_NEAR(glm::length(leaf.turn), 1, 1e-5);
    EXPECT_LT(glm::distance(leaf.turn * Vec3(0, 0, 1), sites[leaf.site].normal), 1e-4f);
    float tip = glm::dot(leaf.turn * Vec3(0, 1, 0), glm::normalize(sites[leaf.site].tip));
    EXPECT_GT(tip, std::cos(radians(70.0f + 30.0f)));
  }
}

TEST(Mosaic, LensIsRightToSevenDigits) {
  EXPECT_NEAR(lens_area(1, 1, 0), kPi, 1e-7);
  EXPECT_EQ(lens_area(1, 0.5, 1.6), 0);
  EXPECT_NEAR(lens_area(1, 0.25, 0.5), kPi / 16, 1e-7);
  EXPECT_NEAR(lens_area(1, 1, 1), 2 * kPi / 3 - std::sqrt(3.0) / 2, 1e-7);
}

TEST(Mosaic, TakesSitesThatLeaveNoChoice) {
  EXPECT_TRUE(lay_leaves({}, forms(), {}).empty());
  MosaicSite site;
  site.tip = site.normal;
  site.size = 0;
  std::vector<MosaicSite> sites{site};
  EXPECT_TRUE(lay_leaves(sites, forms(), {}).empty());
  sites[0].size = 0.05f;
  EXPECT_EQ(lay_leaves(sites, forms(), {}).size(), 1u);
}

}  // namespace
}  // namespace frond
