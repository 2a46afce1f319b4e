#include "land/turf.h"

#include <algorithm>
#include <cmath>

#include "core/discrete_distribution.h"
#include "land/herb.h"

namespace frond {

namespace {

// Lengths and widths below are shares of the length of the lawn's blades, by eye.

/// How a kind of grass differs.
struct GrassHabit {
  double least, most;        // its length
  double thin, broad;        // its width
  double straight, hanging;  // its droop
  int tuft;                  // blades that come from one place; 1: all over
};

GrassHabit habit_of(MeadowPlant kind) {
  switch (kind) {
    case MeadowPlant::fescue:
      return {0.40, 0.95, 0.013, 0.026, 0.15, 0.9, 16};
    case MeadowPlant::cocksfoot:
      return {0.75, 1.40, 0.060, 0.095, 0.25, 0.85, 9};
    case MeadowPlant::panicle:
      return {1.25, 1.85, 0.012, 0.018, 0.05, 0.28, 4};
    case MeadowPlant::clover:
    case MeadowPlant::daisy:
    case MeadowPlant::buttercup:
    case MeadowPlant::plantain:
    case MeadowPlant::grass:
      break;
  }
  return {0.45, 1.15, 0.035, 0.070, 0.10, 0.75, 1};
}

/// A stalk that bears something.
struct Stalk {
  float droop;  // by that of a blade
  float width;
  double least, most;  // its length
};
constexpr Stalk kHeadStalk{0.25f, 0.024f, 0.8, 1.25}, kSpikeStalk{0.3f, 0.02f, 1.0, 1.6},
    kCloverStalk{0.6f, 0.014f, 0.32, 0.72};

/// Leaves round the foot of a flower.
struct Rosette {
  int leaves;
  float length, width;
  float rise;  // as of add_rosette_leaf()
};
constexpr Rosette kDaisyLeaves{6, 0.22f, 0.10f, 0.5f}, kPlantainLeaves{6, 0.75f, 0.15f, 1.3f};

constexpr float kSpike = 0.16f;                                 // length of a plantain's
constexpr double kCloverLeaflet = 0.18, kWidestClover = 0.017;  // a leaflet's length, and metres at most
constexpr double kFlowerHead = 0.12, kWidestFlower = 0.015;     // a head's radius, and metres at most

/// Sows one patch.
class Sower {
 public:
  Sower(const TurfShape& shape, Seed seed) : shape_(shape), seed_(seed) {
    for (const Sward& s : shape.sward) lots_.add(s.share);
    if (shape.thin) {
      bare_ = static_cast<float>(shape.side * seed.child("bare").range(0.22, 0.32));
      own_ = static_cast<float>(seed.child("own").unit());
      add_earth(turf_.leaves, bare_, own_);
    }
  }

  Turf sown() {
    auto count = static_cast<std::uint64_t>(std::max(0.0, shape_.density * shape_.side * shape_.side));
    for (std::uint64_t i = 0; i < count; ++i) sow(seed_.child(i));
    return std::move(turf_);
  }

 private:
  static float number(const Seed& own, std::uint64_t k, double low, double high) {
    return static_cast<float>(own.child(k).range(low, high));
  }

  Sward drawn(const Seed& own) const {
    return shape_.sward.empty() ? Sward{} : shape_.sward[lots_.drawn(own.child(9).unit())];
  }

  /// Blades of a tuft stand close together; the places of tufts belong to the patch.
  Vec3 root(const Seed& own, const Sward& plant, int tuft) const {
    auto place = [&](const Seed& from) {
      double side = shape_.side / 2, blend = shape_.blend / 2;
      return Vec3(number(from, 1, -side, side) + number(from, 15, -blend, blend), 0,
                  number(from, 2, -side, side) + number(from, 16, -blend, blend));
    };
    if (tuft <= 1 || lots_.sum() <= 0) return place(own);
    double blades = shape_.density * shape_.side * shape_.side * plant.share / lots_.sum();
    auto tufts = static_cast<std::uint64_t>(std::max(1.0, blades / tuft));
    Seed middle =
        seed_.child("tuft", static_cast<std::uint64_t>(plant.kind)).child(own.child(10).bits() % tufts);
    constexpr double kTuftRadius = 0.22;  // half the side of a square
    float spread = static_cast<float>(kTuftRadius * shape_.blade);
    return place(middle) + Vec3(number(own, 1, -spread, spread), 0, number(own, 2, -spread, spread));
  }

  /// A few come up in bare earth all the same, the more the nearer to its rim.
  bool comes_up(Vec3 at, const Seed& own) const {
    float away = glm::length(at);
    if (bare_ <= 0 || away <= 0) return bare_ <= 0;
    double place = away / (bare_ * earth_reach(at / away, own_));
    constexpr double kAnywhere = 0.03;             // share that comes up even in its middle
    constexpr double kFirst = 0.35, kAllUp = 1.1;  // shares of the way to the rim
    return own.child(11).unit() < kAnywhere + smooth_step(kFirst, kAllUp, place);
  }

  void sow(const Seed& own) {
    Sward plant = drawn(own);
    GrassHabit habit = habit_of(plant.kind);
    auto lawn = static_cast<float>(shape_.blade * plant.height);
    BladeOfGrass blade;
    float angle = number(own, 0, 0, 2 * kPi);
    blade.root = root(own, plant, habit.tuft);
    if (!comes_up(blade.root, own)) return;
    blade.toward = Vec3(std::cos(angle), 0, std::sin(angle));
    blade.across = Vec3(-blade.toward.z, 0, blade.toward.x);
    blade.own = number(own, 3, 0, 1);
    blade.length = lawn * number(own, 4, habit.least, habit.most);
    blade.droop = number(own, 5, habit.straight, habit.hanging);
    blade.width = lawn * number(own, 6, habit.thin, habit.broad);
    if (own.child(7).unit() < shape_.flowers) return grow_flower(blade, lawn, own);
    switch (plant.kind) {
      case MeadowPlant::grass:
      case MeadowPlant::fescue:
      case MeadowPlant::cocksfoot:
        return add_blade(turf_.blades, blade);
      case MeadowPlant::panicle:
        add_panicle(turf_.flowers, blade, blade.length * number(own, 8, 0.16, 0.26));
        return add_blade(turf_.blades, blade);
      case MeadowPlant::clover:
        return grow_clover(blade, lawn, own);
      case MeadowPlant::daisy:
        grow_rosette(blade, lawn, kDaisyLeaves);
        return grow_head(blade, lawn, Bloom::daisy, own);
      case MeadowPlant::buttercup:
        return grow_buttercup(blade, lawn, own);
      case MeadowPlant::plantain:
        grow_rosette(blade, lawn, kPlantainLeaves);
        make_stalk(blade, kSpikeStalk, lawn, own);
        add_spike(turf_.flowers, blade, kSpike * lawn);
        return add_blade(turf_.blades, blade);
    }
  }

  /// Makes a stalk of a blade.
  static void make_stalk(BladeOfGrass& blade, const Stalk& stalk, float lawn, const Seed& own) {
    blade.droop *= stalk.droop, blade.width = stalk.width * lawn;
    blade.length = lawn * number(own, 4, stalk.least, stalk.most);
  }

  /// One of the flowers that come up anywhere: white ones in one patch, yellow ones in another.
  void grow_flower(BladeOfGrass blade, float lawn, const Seed& own) {
    bool white = seed_.child("white").unit() + 0.5 * own.child(12).unit() < 0.75;
    grow_head(blade, lawn, white ? Bloom::daisy : Bloom::buttercup, own);
  }

  void grow_head(BladeOfGrass blade, float lawn, Bloom kind, const Seed& own) {
    make_stalk(blade, kHeadStalk, lawn, own);
    float radius =
        static_cast<float>(std::min(kFlowerHead * lawn, kWidestFlower)) * number(own, 8, 0.75, 1.15);
    add_head(turf_.flowers, blade, radius, kind);
    add_blade(turf_.blades, blade);
  }

  void grow_clover(BladeOfGrass blade, float lawn, const Seed& own) {
    float leaflet =
        static_cast<float>(std::min(kCloverLeaflet * lawn, kWidestClover)) * number(own, 8, 0.7, 1.15);
    make_stalk(blade, kCloverStalk, lawn, own);
    constexpr double kHeads = 0.05;                          // share of stalks with a head instead of a leaf
    constexpr float kHeadsAbove = 1.35f, kHeadSize = 0.75f;  // by the leaves' height, by a leaflet's length
    bool head = shape_.flowers > 0 && own.child(13).unit() < kHeads;
    if (head)
      blade.length *= kHeadsAbove, add_clover_head(turf_.flowers, blade, kHeadSize * leaflet);
    else
      add_trefoil(turf_.leaves, blade, leaflet, HerbPart::clover);
    add_blade(turf_.blades, blade);
  }

  void grow_buttercup(const BladeOfGrass& blade, float lawn, const Seed& own) {
    BladeOfGrass leaf = blade;
    constexpr float kLeafStalk = 0.014f, kLeaflet = 0.22f;  // the width of the one, the length of the other
    constexpr float kTaller = 1.15f;                        // flowers than those that come up anywhere
    leaf.length = lawn * number(own, 14, 0.3, 0.6), leaf.width = kLeafStalk * lawn;
    add_trefoil(turf_.leaves, leaf, kLeaflet * lawn, HerbPart::herb);
    add_blade(turf_.blades, leaf);
    grow_head(blade, lawn * kTaller, Bloom::buttercup, own);
  }

  void grow_rosette(const BladeOfGrass& blade, float lawn, const Rosette& rosette) {
    constexpr float kTurn = 2.4f;  // radians from leaf to leaf: the golden angle
    constexpr float kDroop = 0.35f;
    constexpr float kStem = 0.04f;  // of the lawn, from the ground to the leaves
    for (int i = 0; i < rosette.leaves; ++i) {
      BladeOfGrass leaf = blade;
      float turn = kTurn * static_cast<float>(i) + 6 * blade.own;
      leaf.toward = Vec3(std::cos(turn), 0, std::sin(turn));
      leaf.across = Vec3(-leaf.toward.z, 0, leaf.toward.x);
      leaf.length = lawn * rosette.length * (0.75f + 0.25f * std::cos(5 * turn));
      leaf.width = lawn * rosette.width;
      leaf.droop = kDroop;
      leaf.root.y += kStem * lawn;
      add_rosette_leaf(turf_.leaves, leaf, rosette.rise);
    }
  }

  const TurfShape& shape_;
  Seed seed_;
  Turf turf_;
  DiscreteDistribution lots_;  // of the sward
  float bare_ = 0, own_ = 0;
};

}  // namespace

Turf turf_surface(const TurfShape& shape, Seed seed) { return Sower(shape, seed).sown(); }

}  // namespace frond
