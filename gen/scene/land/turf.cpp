#include "land/turf.h"

#include <algorithm>
#include <cmath>

#include "core/discrete_distribution.h"
#include "land/herb.h"

namespace frond {

namespace {

/// How a kind of grass differs: shares of the length of the lawn's blades.
struct GrassHabit {
  double least, most;  // its length
  double thin, broad;  // its width
  double straight, hanging;
  int tuft;  // blades that come from one place; 1: all over
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

constexpr double kWidestClover = 0.017;  // metres, a leaflet's length
constexpr double kWidestFlower = 0.015;  // metres, the radius of a head

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
    float spread = static_cast<float>(0.22 * shape_.blade);
    return place(middle) + Vec3(number(own, 1, -spread, spread), 0, number(own, 2, -spread, spread));
  }

  /// A few come up in bare earth all the same, the more the nearer to its rim.
  bool comes_up(Vec3 at, const Seed& own) const {
    float away = glm::length(at);
    if (bare_ <= 0 || away <= 0) return bare_ <= 0;
    double place = away / (bare_ * earth_reach(at / away, own_));
    return own.child(11).unit() < 0.03 + smooth_step(0.35, 1.1, place);
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
        grow_rosette(blade, lawn, 0.22f, 0.10f, 6);
        return grow_head(blade, lawn, Bloom::daisy, own);
      case MeadowPlant::buttercup:
        return grow_buttercup(blade, lawn, own);
      case MeadowPlant::plantain:
        grow_rosette(blade, lawn, 0.75f, 0.15f, 6);
        blade.length = lawn * number(own, 4, 1.0, 1.6), blade.droop *= 0.3f, blade.width = 0.02f * lawn;
        add_spike(turf_.flowers, blade, 0.16f * lawn);
        return add_blade(turf_.blades, blade);
    }
  }

  /// One of the flowers that come up anywhere: white ones in one patch, yellow ones in another.
  void grow_flower(BladeOfGrass blade, float lawn, const Seed& own) {
    bool white = seed_.child("white").unit() + 0.5 * own.child(12).unit() < 0.75;
    grow_head(blade, lawn, white ? Bloom::daisy : Bloom::buttercup, own);
  }

  void grow_head(BladeOfGrass blade, float lawn, Bloom kind, const Seed& own) {
    blade.droop *= 0.25f, blade.width = lawn * 0.024f;
    blade.length = lawn * number(own, 4, 0.8, 1.25);
    float radius = static_cast<float>(std::min(0.12 * lawn, kWidestFlower)) * number(own, 8, 0.75, 1.15);
    add_head(turf_.flowers, blade, radius, kind);
    add_blade(turf_.blades, blade);
  }

  void grow_clover(BladeOfGrass blade, float lawn, const Seed& own) {
    float leaflet = static_cast<float>(std::min(0.18 * lawn, kWidestClover)) * number(own, 8, 0.7, 1.15);
    blade.length = lawn * number(own, 4, 0.32, 0.72), blade.droop *= 0.6f, blade.width = 0.014f * lawn;
    bool head = shape_.flowers > 0 && own.child(13).unit() < 0.05;
    if (head)
      blade.length *= 1.35f, add_clover_head(turf_.flowers, blade, 0.75f * leaflet);
    else
      add_trefoil(turf_.leaves, blade, leaflet, HerbPart::clover);
    add_blade(turf_.blades, blade);
  }

  void grow_buttercup(const BladeOfGrass& blade, float lawn, const Seed& own) {
    BladeOfGrass leaf = blade;
    leaf.length = lawn * number(own, 14, 0.3, 0.6), leaf.width = 0.014f * lawn;
    add_trefoil(turf_.leaves, leaf, 0.22f * lawn, HerbPart::herb);
    add_blade(turf_.blades, leaf);
    grow_head(blade, lawn * 1.15f, Bloom::buttercup, own);
  }

  void grow_rosette(const BladeOfGrass& blade, float lawn, float length, float width, int leaves) {
    for (int i = 0; i < leaves; ++i) {
      BladeOfGrass leaf = blade;
      float turn = 2.4f * static_cast<float>(i) + 6 * blade.own;
      leaf.toward = Vec3(std::cos(turn), 0, std::sin(turn));
      leaf.across = Vec3(-leaf.toward.z, 0, leaf.toward.x);
      leaf.length = lawn * length * (0.75f + 0.25f * std::cos(5 * turn)), leaf.width = lawn * width;
      leaf.droop = 0.35f;
      leaf.root.y += 0.04f * lawn;
      add_rosette_leaf(turf_.leaves, leaf, length > 0.5f ? 1.3f : 0.5f);
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
