#include "organisms/colony.h"

#include <algorithm>

namespace frond {

Surroundings::Surroundings(const World& world, std::size_t claim, const Placement& placement)
    : world_(&world), claim_(claim), placement_(placement) {
  if (Result<std::shared_ptr<const TriangleSurface>> host = world.host({}, "")) host_ = *host;
}

float Surroundings::room(Vec3 at, float within) const {
  if (!world_) return Territories::kOpen;
  Vec3 place = outside(at);
  float room = world_->territories().room(claim_, place);
  if (host_)
    if (auto contact = host_->closest(DVec3(place), within * placement_.size))
      room = std::min(room, static_cast<float>(contact->inside ? -contact->distance : contact->distance));
  return room / placement_.size;
}

float Surroundings::border(Vec3 at) const {
  return world_ ? world_->territories().room(claim_, outside(at)) / placement_.size : Territories::kOpen;
}

float Surroundings::light(Vec3 at) const {
  if (!world_) return 1;
  Vec3 place = outside(at);
  return static_cast<float>(world_->open_sky(DVec3(place))) * world_->territories().sky(claim_, place);
}

Surroundings::Hold Surroundings::hold(Vec3 at, float within) const {
  if (!world_) return {{at.x, 0, at.z}, {0, 1, 0}};
  Vec3 place = outside(at);
  Quat back = glm::conjugate(placement_.turn);
  if (host_)
    if (auto contact = host_->closest(DVec3(place), within * placement_.size)) {
      Vec3 normal = back * Vec3(contact->normal);
      return {inside(Vec3(contact->point)), contact->inside ? -normal : normal};
    }
  auto height = [&](float x, float z) { return static_cast<float>(world_->height({x, z})); };
  constexpr float kStep = 0.02f;
  Vec3 slope(height(place.x - kStep, place.z) - height(place.x + kStep, place.z), 2 * kStep,
             height(place.x, place.z - kStep) - height(place.x, place.z + kStep));
  return {inside({place.x, height(place.x, place.z), place.z}), back * glm::normalize(slope)};
}

}  // namespace frond
