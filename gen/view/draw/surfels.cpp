#include "draw/surfels.h"

#include <cmath>
#include <map>
#include <mutex>

#include "draw/surfel_sampler.h"

namespace frond {

namespace {

constexpr int kFine = 4;  // parts of a surfel's side, to see what lies before one another in it

/// The sums of a surfel: whole numbers, which do not depend on the order in which they are added.
struct Sum {
  std::array<std::int64_t, 8> of{};                      // area; area times place, colour, bulk
  std::array<std::int64_t, kFine * kFine * kFine> in{};  // area in each part
};

struct IntoMap {
  float part;
  std::map<std::array<int, 4>, Sum>& sums;
  std::mutex& in_work;

  void add(Vec3 at, float area, Vec3 albedo, Facing, float bulk) const {
    auto fine = glm::ivec3(glm::floor(at / part)), k = glm::ivec3(glm::floor(Vec3(fine) / float{kFine}));
    glm::ivec3 in = fine - k * kFine;
    double quanta = area / (part * part) * 1e6;
    std::lock_guard lock(in_work);
    Sum& sum = sums[{k.x, k.y, k.z, bulk > 0 ? 1 : 0}];
    std::int64_t whole = std::llround(quanta);
    sum.of[0] += whole;
    sum.in[static_cast<std::size_t>((in.x * kFine + in.y) * kFine + in.z)] += whole;
    for (std::size_t c = 0; c < 3; ++c) {
      sum.of[1 + c] += std::llround(quanta * at[static_cast<int>(c)] * 1e3);
      sum.of[4 + c] += std::llround(quanta * albedo[static_cast<int>(c)] * 1e3);
    }
    sum.of[7] += std::llround(quanta * std::min(bulk, 100.0f) * 1e3);
  }
  float step(Vec3) const { return part; }
};

/// The share of its area that hides as much if nothing in it lies before another; `hides` of an area, that
/// much is in the way.
float apart(const Sum& sum, float hides) {
  float through = 0, all = 0;
  constexpr std::size_t kColumns = 3 * kFine * kFine;  // along three axes
  for (std::size_t along = 1; along < sum.in.size(); along *= kFine) {
    for (std::size_t i = 0; i < sum.in.size(); ++i) {
      if (i / along % kFine != 0) continue;
      std::int64_t column = 0;
      for (std::size_t k = 0; k < kFine; ++k) column += sum.in[i + k * along];
      float depth = hides * static_cast<float>(static_cast<double>(column) / 1e6);
      through += std::exp(-depth);
      all += depth;
    }
  }
  return -std::log(std::max(through / kColumns, 1e-6f)) / (all / kColumns);
}

float rounded(double value, int decimals) {
  double power = std::pow(10.0, decimals);
  return static_cast<float>(static_cast<double>(std::llround(value * power)) / power);
}

Surfel rounded(const Surfel& c) {
  auto all = [](Vec3 v) {
    return Vec3(rounded(v.x, kSurfelDecimals), rounded(v.y, kSurfelDecimals), rounded(v.z, kSurfelDecimals));
  };
  return {all(c.at), rounded(c.area, kSurfelAreaDecimals), rounded(c.wide, kSurfelDecimals), all(c.albedo),
          rounded(c.bulk, kSurfelDecimals)};
}

}  // namespace

std::vector<Surfel> surfels_of(const Look& look, const Model& model) {
  float tall = std::max({reach_of(model.skeleton.position), reach_of(model.organs.position),
                         reach_of(model.blades.surface.position)});
  if (tall == 0) tall = 1;
  float cell = std::max(tall / 24, 0.02f);
  std::map<std::array<int, 4>, Sum> sums;
  std::mutex in_work;
  Traits traits;
  traits.look = look;
  sample_surfels(IntoMap{cell / kFine, sums, in_work}, DrawList(traits, model));
  std::vector<Surfel> list;
  for (const auto& [key, sum] : sums) {
    if (sum.of[0] <= 0) continue;
    double total = static_cast<double>(sum.of[0]);
    auto share = [&](std::size_t i) {
      return static_cast<float>(static_cast<double>(sum.of[i]) / total / 1e3);
    };
    float area = static_cast<float>(total / 1e6) * cell * cell / (kFine * kFine);
    list.push_back(rounded({Vec3(share(1), share(2), share(3)), area * apart(sum, key[3] ? 0.25f : 0.5f),
                            cell, Vec3(share(4), share(5), share(6)), share(7)}));
  }
  return list;
}

}  // namespace frond
