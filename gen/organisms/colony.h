#pragma once

#include <memory>

#include "accretion/accretion.h"
#include "organisms/grower.h"
#include "world/territory.h"

// Colonies: what grows for space
// ==============================
// Corals, sponges and their like grow one beside another, and on rocks. A kind of them is a ColonyGrower: it
// says how far one of its kind would spread, and grows one where it stands, asking its Surroundings how much
// room is left. All of them grow at once, since room depends on claims alone (world/territory.h).

namespace frond {

/// Where a colony grows, asked in the colony's own space: its foot at the origin, upright, not yet sized.
class Surroundings {
 public:
  Surroundings() = default;  ///< nothing near
  Surroundings(const World& world, std::size_t claim, const Placement& placement);

  /// Metres to the border of its territory and to the bodies that stand, the nearer of them, at least; less
  /// than 0 beyond. `within`: farther bodies do not count.
  float room(Vec3 at, float within) const;
  /// The same to the border of its territory alone.
  float border(Vec3 at) const;
  /// The nearest place on a body or, where there is none within reach, on the ground, and what is outward
  /// there.
  struct Hold {
    Vec3 at{0}, normal{0, 1, 0};
  };
  Hold hold(Vec3 at, float within) const;
  /// The share of the sky that bodies, and neighbours when they are grown, leave open, 0..1.
  float light(Vec3 at) const;
  /// A place of the world, as it is measured here.
  Vec3 inside(Vec3 at) const {
    return (glm::conjugate(placement_.turn) * (at - placement_.foot)) / placement_.size;
  }

 private:
  Vec3 outside(Vec3 at) const { return placement_.foot + placement_.turn * (at * placement_.size); }

  const World* world_ = nullptr;
  std::shared_ptr<const Host> host_;
  std::size_t claim_ = SIZE_MAX;
  Placement placement_;
};

/// What fights for space with its like.
class ColonyGrower : public LoneGrower {
 public:
  /// Grows one, upright, its foot at the origin.
  virtual Result<Model> grow_at(const Surroundings& around, Seed seed) const = 0;

  GrowthStage stage() const final { return GrowthStage::in_space; }
  Result<Model> grow_alone(Seed seed) const final { return grow_at(Surroundings(), seed); }
  std::function<Result<Model>(double)> develop(const Motion&, Seed) const override { return {}; }
  bool develops(bool) const override { return false; }
  std::optional<Result<Grammar>> grammar() const override { return std::nullopt; }
  Result<Model> grow_standing(const World& world, const Planting& planting, const Placement& placement,
                              Seed seed) const final {
    return grow_at(Surroundings(world, planting.claim, placement), seed);
  }
};

/// A colony that is a body; its parameters have `across`, `height` and `growth`.
template <class Params>
class BodyColony : public Described<Params, ColonyGrower> {
 public:
  double tallest() const override { return this->params.height; }
  Dress dress() const override {
    Dress dress;
    dress.motion.growth = this->params.growth;
    return dress;
  }
  bool branches() const override { return false; }
  std::optional<Spread> spread() const override {
    return Spread{static_cast<float>(this->params.across / 2), static_cast<float>(this->params.height)};
  }
};

/// What a skin that grows by layers has round it.
AccretionWorld accretion_world(const Surroundings& around);

/// A body of one living skin, with where its vertices were before, see Solid::past.
Model model_of(Surface skin, std::vector<std::vector<Vec3>> past, const Material& material);

}  // namespace frond
