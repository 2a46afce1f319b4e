#pragma once

#include <memory>

#include "organisms/grower.h"
#include "world/territory.h"

// Colonies: organisms that compete for space
// ==========================================
// Corals, sponges and the like grow beside each other and on rocks. A kind of colony is a ColonyGrower: it
// tells how far it would spread, and grows one colony at its place, asking its Surroundings how much room is
// left. All colonies grow at once, since room depends on claims only (world/territory.h).

namespace frond {

/// The surroundings of a colony, in the colony's own space: its foot at the origin, upright, before scaling.
class Surroundings {
 public:
  Surroundings() = default;  ///< nothing near
  Surroundings(const World& world, std::size_t claim, const Placement& placement);

  /// A lower bound of the distance to the border of its territory and to existing bodies, metres; negative
  /// beyond. Bodies farther than `within` are ignored.
  float room(Vec3 at, float within) const;
  /// A lower bound of the distance to the border of the colony's territory alone, metres; negative beyond.
  float border(Vec3 at) const;
  /// The nearest point and outward normal on a body or, if none is within reach, on the ground.
  struct Hold {
    Vec3 at{0}, normal{0, 1, 0};
  };
  Hold hold(Vec3 at, float within) const;
  /// The share of the sky, 0..1, left open by bodies and by fully grown neighbours.
  float light(Vec3 at) const;
  /// A point of the world in the colony's space.
  Vec3 inside(Vec3 at) const {
    return (glm::conjugate(placement_.turn) * (at - placement_.foot)) / placement_.size;
  }

 private:
  Vec3 outside(Vec3 at) const { return placement_.foot + placement_.turn * (at * placement_.size); }

  const World* world_ = nullptr;
  std::shared_ptr<const TriangleSurface> host_;
  std::size_t claim_ = SIZE_MAX;
  Placement placement_;
};

/// A grower of organisms that compete for space.
class ColonyGrower : public LoneGrower {
 public:
  /// Grows one, upright, its foot at the origin.
  virtual Result<Model> grow_at(const Surroundings& around, Seed seed) const = 0;

  Result<Model> grow_alone(Seed seed) const final { return grow_at(Surroundings(), seed); }
  Result<Model> grow_standing(const World& world, const Planting& planting, const Placement& placement,
                              Seed seed) const final {
    return grow_at(Surroundings(world, planting.claim, placement), seed);
  }

 protected:
  /// The traits of a colony, with those that are the kind's own.
  static GrowerTraits colony(GrowerTraits own) {
    own.stage = GrowthStage::in_space, own.colony = true;
    return own;
  }
};

/// Bends branches away from neighbours' territories and existing bodies, and ends those that would enter
/// them. Segments keep their lengths. Nothing changes where there is room.
void keep_to_room(Skeleton& skeleton, const Surroundings& around);

}  // namespace frond
