#include "land/far_land.h"

#include <algorithm>
#include <cmath>

#include "core/noise.h"
#include "land/hills.h"

namespace frond {

namespace {

constexpr double kLong = 2;          // length of parcels by their width
constexpr double kOpen = 60;         // metres past the edge of the near ground that are always grass
constexpr double kWoodSize = 900;    // metres from one wood to the next
constexpr double kRockSlope = 0.9;   // rise over run of what bears no soil, 42 degrees
constexpr double kSteepField = 0.2;  // rise over run of what is no longer ploughed
constexpr double kMassif = 5200;     // metres from one mountain to the next
constexpr double kVillage = 110;     // metres from the middle of a village within which nothing else is

/// How something grows with the metres past the edge of the near ground.
struct FarRise {
  double by, from, to;
  double at(double out) const { return by * smooth_step(from, to, out); }
};
// The farther, the higher, so that hills show above those before them; by the relief, by eye.
constexpr FarRise kHillsRise{0.6, 200, 4000}, kNearRise{0.6, 300, 3000}, kFarRise{2.2, 2000, 11000};

Seed pair_seed(const Seed& a, const Seed& b) { return Seed{a.key ^ b.key}.child("border"); }

}  // namespace

double GroundEdge::outside(Vec2 at) const {
  return (square ? std::max(std::abs(at.x), std::abs(at.y)) : glm::length(at)) - radius;
}

FarLand::FarLand(const FarLandShape& shape, const GroundEdge& edge, Seed seed)
    : shape_(shape), edge_(edge), seed_(seed) {
  double turn = seed.child("along").range(0, kPi);
  along_ = Vec2(std::cos(turn), std::sin(turn));
  std::vector<double> noises;
  // Samples tell which value of the noise the share that is wooded is above.
  constexpr int kSamples = 40;
  constexpr double kSampleStep = 0.37;  // of a wood's size
  for (int i = 0; i < kSamples * kSamples; ++i)
    noises.push_back(
        wood_noise(Vec2(i % kSamples, i / kSamples) * static_cast<float>(kSampleStep * kWoodSize)));
  std::ranges::sort(noises);
  auto rank = static_cast<std::size_t>((1 - shape.woods) * static_cast<double>(noises.size() - 1));
  wood_from_ = shape.woods > 0 ? noises[rank] : 1e9;
  if (shape.villages > 0) found_villages();
}

Vec2 FarLand::turned(Vec2 at) const {
  return {glm::dot(at, along_), glm::dot(at, Vec2(-along_.y, along_.x))};
}

Vec2 FarLand::unturned(Vec2 at) const { return along_ * at.x + Vec2(-along_.y, along_.x) * at.y; }

double FarLand::wood_noise(Vec2 at) const {
  Vec2 p = at / static_cast<float>(kWoodSize);
  auto level = static_cast<float>(seed_.child("woods").range(0, 999));
  return noise(Vec3(p.x, level, p.y)) + 0.5 * noise(Vec3(2.7f * p.x, level + 9, 2.7f * p.y));
}

double FarLand::height(Vec2 at, double spacing) const {
  double out = edge_.outside(at), ends = edge_.beyond ? edge_.beyond(at) : 0;
  // From the near ground to the land as it is here.
  constexpr double kLeastMetres = 500, kOfRadius = 0.7;
  double share = smooth_step(0.0, std::max(kLeastMetres, kOfRadius * edge_.radius), out);
  if (share <= 0) return ends;
  double away = glm::length(at);
  constexpr double kHillRoughness = 0.15, kMountainRoughness = 0.75, kErosion = 1;
  double hills = hill_noise(at, shape_.hill_size, kHillRoughness, spacing, seed_.child("hills"));
  double land =
      shape_.relief * (0.5 * hills * (0.4 + kHillsRise.at(out)) + kNearRise.at(out) + kFarRise.at(out));
  constexpr double kFoot = 0.35;  // of the mountains, as a share of their distance
  double risen = smooth_step(kFoot, 1.0, away / std::max(shape_.mountains_distance, 1.0));
  if (shape_.mountains > 0 && risen > 0) {
    // Farther ranges look over those before them.
    constexpr double kHigher = 0.35, kHighestAt = 2.4;  // the share, and where, by the mountains' distance
    double farther = 1 + kHigher * smooth_step(1.0, kHighestAt, away / shape_.mountains_distance);
    double ridges =
        eroded_hill_noise(at, kMassif, kMountainRoughness, kErosion, spacing, seed_.child("mountains"));
    land += shape_.mountains * risen * farther * std::max(0.0, 0.55 + 0.5 * ridges);
  }
  return ends + (land - ends) * share;
}

Vec2 FarLand::slope(Vec2 at, double spacing) const {
  auto d = static_cast<float>(std::max(spacing, 1.0));
  auto rise = [&](Vec2 step) {
    return static_cast<float>(height(at + step, spacing) - height(at - step, spacing)) / (2 * d);
  };
  return {rise(Vec2(d, 0)), rise(Vec2(0, d))};
}

Parcel FarLand::parcel(Vec2 at) const {
  constexpr double kAcrossShare = 0.35;  // of parcels, that are ploughed across the main direction
  auto wide = static_cast<float>(shape_.parcel), length = static_cast<float>(kLong * shape_.parcel);
  Vec2 p = turned(at);
  auto row = static_cast<int>(std::floor(p.y / wide));
  float best = 1e30f, second = 1e30f;
  Vec2 own(0), other(0);
  Seed own_seed, other_seed;
  for (int j = row - 2; j <= row + 2; ++j) {
    auto column = static_cast<int>(std::floor(p.x / length));
    for (int i = column - 1; i <= column + 1; ++i) {
      Seed cell = seed_.child("parcel")
                      .child(static_cast<std::uint64_t>(j + 1'000'000))
                      .child(static_cast<std::uint64_t>(i + 1'000'000));
      Vec2 site((static_cast<float>(i) + static_cast<float>(cell.child(0).range(0.35, 0.65))) * length,
                (static_cast<float>(j) + static_cast<float>(cell.child(1).range(0.3, 0.7))) * wide);
      float away = glm::distance(site, p);
      if (away < best) {
        second = best, other = own, other_seed = own_seed;
        best = away, own = site, own_seed = cell;
      } else if (away < second) {
        second = away, other = site, other_seed = cell;
      }
    }
  }
  double edge = double{second * second - best * best} / (2.0 * std::max(glm::distance(own, other), 1e-3f));
  return {own_seed,
          unturned(own),
          unturned(other),
          edge,
          pair_seed(own_seed, other_seed),
          own_seed.child("across").unit() < kAcrossShare};
}

bool FarLand::wooded(const Parcel& parcel) const {
  if (edge_.outside(parcel.site) < kOpen) return false;
  for (const Village& village : villages_)
    if (glm::distance(village.at, parcel.site) < 2 * kVillage) return false;
  return wood_noise(parcel.site) > wood_from_;
}

FarCover FarLand::cover(Vec2 at, const Parcel& parcel, double height, Vec2 slope) const {
  constexpr float kRoughSize = 500;       // metres over which borders come and go
  constexpr double kAboveHills = 1.5;     // by the relief: where mountains begin
  constexpr double kMountainSlope = 0.3;  // rise over run, about, of what is no hill
  constexpr double kBelowTreeLine = 100;  // metres, from where on woods give way to heath
  double steep = glm::length(slope), rough = 0.5 * fractal_noise(Vec3(at.x, 0, at.y) / kRoughSize, 2);
  bool mountain =
      shape_.mountains > 0 && height > kAboveHills * shape_.relief && steep > kMountainSlope + 0.2 * rough;
  if (mountain || height > shape_.tree_line - kBelowTreeLine || steep > kRockSlope) return FarCover::mountain;
  if (wooded(parcel)) return FarCover::wood;
  if (edge_.outside(at) < kOpen) return FarCover::meadow;
  if (steep > kSteepField || parcel.seed.child("ploughed").unit() >= shape_.fields) {
    constexpr FarCover kGrass[] = {FarCover::meadow, FarCover::hay, FarCover::pasture};
    return kGrass[parcel.seed.child("grass").bits() % 3];
  }
  constexpr FarCover kCrops[] = {FarCover::wheat, FarCover::barley, FarCover::barley,
                                 FarCover::rape,  FarCover::earth,  FarCover::wheat};
  return kCrops[parcel.seed.child("crop").bits() % 6];
}

/// A road on either side of the near ground, which wanders about the main direction; villages lie on it.
void FarLand::found_villages() {
  constexpr double kFarthest = 2500;                         // metres along a road: farther ones are not seen
  constexpr double kNearestRoad = 260, kFarthestRoad = 480;  // metres past the near ground
  constexpr double kDiagonal = 1.42;                         // of a square, by its side
  constexpr double kBend = 120, kBendLength = 900;           // metres that a road strays, and on which length
  constexpr double kAside = 0.3;  // of a village along the road, by the way between two
  auto count = static_cast<int>(std::min(kFarthest, shape_.reach / 2) / shape_.villages);
  for (int side = 0; side < 2; ++side) {
    Seed road = seed_.child("road", static_cast<std::uint64_t>(side));
    double away = (edge_.radius * (edge_.square ? kDiagonal : 1) + road.range(kNearestRoad, kFarthestRoad)) *
                  (side ? 1 : -1);
    auto at = [&](double x) {
      double bend = kBend * noise(Vec3(x / kBendLength, road.range(0, 99), 3));
      return unturned(Vec2(x, away + bend));
    };
    for (int k = -count; k <= count; ++k) {
      Seed own = road.child("village", static_cast<std::uint64_t>(k + count));
      double x = (k + own.child("at").range(-kAside, kAside)) * shape_.villages;
      // The way from 5 m before it to 5 m behind.
      villages_.push_back({at(x), glm::normalize(at(x + 5) - at(x - 5)), own});
    }
  }
}

}  // namespace frond
