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
  std::array<std::int64_t, 8> of{};  // area; area times place, colour, bulk

  /// Areas in parts of a square of that side; returns how many.
  std::int64_t add(Vec3 at, float area, Vec3 albedo, float bulk, float side) {
    double quanta = area / (side * side) * 1e6;
    std::int64_t whole = std::llround(quanta);
    of[0] += whole;
    for (std::size_t c = 0; c < 3; ++c) {
      of[1 + c] += std::llround(quanta * at[static_cast<int>(c)] * 1e3);
      of[4 + c] += std::llround(quanta * albedo[static_cast<int>(c)] * 1e3);
    }
    of[7] += std::llround(quanta * std::min(bulk, 100.0f) * 1e3);
    return whole;
  }
  /// What they are of, in a cube so wide; its area is not above 0 where nothing was added.
  Surfel surfel(float side, float wide) const {
    double total = std::max(static_cast<double>(of[0]), 1.0);
    auto share = [&](std::size_t i) { return static_cast<float>(static_cast<double>(of[i]) / total / 1e3); };
    float area = static_cast<float>(static_cast<double>(of[0]) / 1e6) * side * side;
    Surfel surfel;
    surfel.at = Vec3(share(1), share(2), share(3));
    surfel.area = area;
    surfel.wide = wide;
    surfel.albedo = Vec3(share(4), share(5), share(6));
    surfel.bulk = share(7);
    return surfel;
  }
};

/// The sum of a cube.
struct CubeSum : Sum {
  std::array<std::int64_t, kFine * kFine * kFine> in{};  // area in each part
};

struct IntoMap {
  float part;
  std::map<std::array<int, 4>, CubeSum>& sums;
  std::mutex& in_work;

  void add(Vec3 at, float area, Vec3 albedo, Facing, float bulk) const {
    auto fine = glm::ivec3(glm::floor(at / part)), k = glm::ivec3(glm::floor(Vec3(fine) / float{kFine}));
    glm::ivec3 in = fine - k * kFine;
    std::lock_guard lock(in_work);
    CubeSum& sum = sums[{k.x, k.y, k.z, bulk > 0 ? 1 : 0}];
    sum.in[static_cast<std::size_t>((in.x * kFine + in.y) * kFine + in.z)] +=
        sum.add(at, area, albedo, bulk, part);
  }
  float step(Vec3) const { return part; }
};

/// The share of its area that hides as much if nothing in it lies before another; `hides` of an area, that
/// much is in the way.
float apart(const CubeSum& sum, float hides) {
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

Surfel rounded(Surfel c) {
  for (int i = 0; i < 3; ++i) {
    c.at[i] = rounded(c.at[i], kSurfelDecimals);
    c.albedo[i] = rounded(c.albedo[i], kSurfelDecimals);
  }
  c.area = rounded(c.area, kSurfelAreaDecimals);
  c.wide = rounded(c.wide, kSurfelDecimals);
  c.bulk = rounded(c.bulk, kSurfelDecimals);
  return c;
}

/// Side of the cubes of a model's surfels, metres.
float cube_of(const Model& model) {
  float tall = std::max({reach_of(model.skeleton.position), reach_of(model.organs.position),
                         reach_of(model.blades.surface.position)});
  return std::max((tall == 0 ? 1 : tall) / 24, 0.02f);
}

DrawList drawn(const Look& look, const Model& model) {
  Traits traits;
  traits.look = look;
  return DrawList(traits, model);
}

/// The finer surfels of one.
struct Finer {
  Surfel* surfel = nullptr;
  float side = 0;                          // of their cubes, metres; 0: it has none
  std::map<std::array<int, 4>, Sum> sums;  // by cube and facing
  std::mutex in_work;
};

/// How fine a model is sampled in cubes and round them, metres.
struct Steps {
  float cell = 1, finest = 1;
  int round = 0;  // cubes that its pieces may reach beyond the one that they begin in
  std::map<std::array<int, 3>, float> in{};

  void add(glm::ivec3 cube, float step) {
    finest = std::min(finest, step);
    for (int x = -round; x <= round; ++x)
      for (int y = -round; y <= round; ++y)
        for (int z = -round; z <= round; ++z) {
          float& least = in.try_emplace({cube.x + x, cube.y + y, cube.z + z}, cell).first->second;
          least = std::min(least, step);
        }
  }
  float at(Vec3 place) const {
    if (round == 0) return finest;
    glm::ivec3 cube(glm::floor(place / cell));
    auto found = in.find({cube.x, cube.y, cube.z});
    return found == in.end() ? cell : found->second;
  }
};

/// Of a model whose pieces are no longer than one or two cubes; of others all is sampled as finely.
Steps steps_of(const Model& model, float cell) {
  constexpr int kMost = 2;
  float longest = model.solids.shapes.empty() && model.blades.surface.triangle.empty() ? 0 : 1e6f;
  for (std::size_t i = 0; i < model.skeleton.size(); ++i)
    if (std::int32_t parent = model.skeleton.parent[i]; parent >= 0)
      longest = std::max(longest, glm::distance(model.skeleton.position[i],
                                                model.skeleton.position[static_cast<std::size_t>(parent)]));
  for (const Vec3& scale : model.organs.scale) longest = std::max({longest, scale.x, scale.y, scale.z});
  int round = 1 + static_cast<int>(longest / cell);
  return {cell, cell, round <= kMost ? round : 0};
}

struct IntoFiner {
  float cell;
  const Steps& steps;
  std::map<std::array<int, 4>, Finer>& all;  // by cube, and whether it is of bodies

  void add(Vec3 at, float area, Vec3 albedo, Facing facing, float bulk) const {
    Finer* finer = of(at, bulk > 0 ? 1 : 0);
    if (!finer || finer->side == 0) return;
    glm::ivec3 k(glm::floor(at / finer->side));
    std::lock_guard lock(finer->in_work);
    finer->sums[{k.x, k.y, k.z, facing}].add(at, area, albedo, bulk, finer->side);
  }
  float step(Vec3 at) const { return steps.at(at); }

 private:
  /// The surfel that stands for what is there: of its cube, or the nearest of the cubes next to it, as what
  /// is thin lies on its axis in coarse surfels and round it in finer ones.
  Finer* of(Vec3 at, int body) const {
    glm::ivec3 cube(glm::floor(at / cell));
    if (auto own = all.find({cube.x, cube.y, cube.z, body}); own != all.end()) return &own->second;
    Finer* nearest = nullptr;
    for (int i = 0; i < 27; ++i) {
      auto found = all.find({cube.x + i % 3 - 1, cube.y + i / 3 % 3 - 1, cube.z + i / 9 - 1, body});
      if (found != all.end() &&
          (!nearest || glm::distance(at, found->second.surfel->at) < glm::distance(at, nearest->surfel->at)))
        nearest = &found->second;
    }
    return nearest;
  }
};

}  // namespace

std::vector<Surfel> surfels_of(const Look& look, const Model& model) {
  float cell = cube_of(model);
  std::map<std::array<int, 4>, CubeSum> sums;
  std::mutex in_work;
  sample_surfels(IntoMap{cell / kFine, sums, in_work}, drawn(look, model));
  std::vector<Surfel> list;
  for (const auto& [key, sum] : sums) {
    if (sum.of[0] <= 0) continue;
    Surfel surfel = sum.surfel(cell / kFine, cell);
    surfel.area *= apart(sum, key[3] ? 0.25f : 0.5f);
    list.push_back(rounded(std::move(surfel)));
  }
  return list;
}

void refine(std::vector<Surfel>& surfels, const std::vector<int>& halvings, const Look& look,
            const Model& model) {
  constexpr float kStep = 0.5f;  // of the side of a cube
  float cell = cube_of(model);
  Steps steps = steps_of(model, cell);
  std::map<std::array<int, 4>, Finer> all;
  for (std::size_t i = 0; i < surfels.size(); ++i) {
    Surfel& surfel = surfels[i];
    surfel.halvings = halvings[i];
    surfel.finer.clear();
    glm::ivec3 cube(glm::floor(surfel.at / cell));
    Finer& one = all[{cube.x, cube.y, cube.z, surfel.bulk > 0 ? 1 : 0}];
    one.surfel = &surfel;
    one.side = halvings[i] > 0 ? std::ldexp(cell, -halvings[i]) : 0;
    if (halvings[i] > 0) steps.add(cube, kStep * one.side);
  }
  if (std::ranges::all_of(halvings, [](int times) { return times == 0; })) return;
  sample_surfels(IntoFiner{cell, steps, all}, drawn(look, model));
  for (const auto& [cube, one] : all)
    for (const auto& [key, sum] : one.sums) {
      if (sum.of[0] <= 0) continue;
      Surfel finer = rounded(sum.surfel(one.side, one.side));
      finer.facing = static_cast<Facing>(key[3]);
      one.surfel->finer.push_back(std::move(finer));
    }
}

}  // namespace frond
