#include "organisms/colony.h"

#include <algorithm>

#include "core/parallel.h"
#include "organisms/organism.h"

namespace frond {

namespace {

Stance stance_of(const Organism& organism, const Planting& planting) {
  const Place& place = organism.place;
  double turn = place.turn + place.turn_variation * planting.seed.child("turn").range(-1, 1);
  Quat yaw = glm::angleAxis(static_cast<float>(turn), Vec3(0, 1, 0));
  Vec3 up = glm::mix(planting.normal, Vec3(0, 1, 0), static_cast<float>(place.upright));
  Quat slope = glm::dot(up, up) > 1e-6f ? Quat(Vec3(0, 1, 0), glm::normalize(up)) : Quat(1, 0, 0, 0);
  return {planting.foot, lean_of(organism, planting.seed) * slope * yaw, size_of(organism, planting.seed)};
}

}  // namespace

Surroundings::Surroundings(const World& world, std::size_t claim, Vec3 foot, Quat turn, float size)
    : world_(&world), claim_(claim), foot_(foot), turn_(turn), size_(size) {
  if (Result<std::shared_ptr<const Host>> host = world.host({}, "")) host_ = *host;
}

float Surroundings::room(Vec3 at, float within) const {
  if (!world_) return Territories::kOpen;
  Vec3 place = outside(at);
  float room = world_->territories().room(claim_, place);
  if (host_)
    if (auto contact = host_->closest(DVec3(place), within * size_))
      room = std::min(room, static_cast<float>(contact->inside ? -contact->distance : contact->distance));
  return room / size_;
}

float Surroundings::border(Vec3 at) const {
  return world_ ? world_->territories().room(claim_, outside(at)) / size_ : Territories::kOpen;
}

Surroundings::Hold Surroundings::hold(Vec3 at, float within) const {
  if (!world_) return {{at.x, 0, at.z}, {0, 1, 0}};
  Vec3 place = outside(at);
  Quat back = glm::conjugate(turn_);
  if (host_)
    if (auto contact = host_->closest(DVec3(place), within * size_)) {
      Vec3 normal = back * Vec3(contact->normal);
      return {inside(Vec3(contact->point)), contact->inside ? -normal : normal};
    }
  auto height = [&](float x, float z) { return static_cast<float>(world_->height({x, z})); };
  constexpr float kStep = 0.02f;
  Vec3 slope(height(place.x - kStep, place.z) - height(place.x + kStep, place.z), 2 * kStep,
             height(place.x, place.z - kStep) - height(place.x, place.z + kStep));
  return {inside({place.x, height(place.x, place.z), place.z}), back * glm::normalize(slope)};
}

float Surroundings::above_ground(Vec3 at) const {
  if (!world_) return at.y;
  Vec3 place = outside(at);
  return (place.y - static_cast<float>(world_->height({place.x, place.z}))) / size_;
}

std::vector<Result<Specimen>> ColonyGrower::grow(std::span<const Bed> beds, const World& world,
                                                 const Step& step) const {
  struct Task {
    const Bed& bed;
    const Planting& planting;
    std::shared_ptr<const Dress> dress;  // one for all of the bed
  };
  std::vector<Task> all;
  for (const Bed& bed : beds) {
    auto dress = std::make_shared<const Dress>(bed.organism->grower->dress());
    for (const Planting& planting : bed.plantings) all.push_back({bed, planting, dress});
  }
  std::vector<Result<Specimen>> grown(all.size(), Error{});
  parallel_for(all.size(), [&](std::size_t i) {
    const auto& [bed, planting, dress] = all[i];
    const auto& grower = static_cast<const ColonyGrower&>(*bed.organism->grower);
    Stance stance = stance_of(*bed.organism, planting);
    Surroundings around(world, planting.claim, stance.foot, stance.turn, stance.size);
    Result<Model> model = grower.grow_at(around, planting.seed.child("grow"));
    if (model) {
      Specimen specimen{{bed.organism->name, bed.entry}, std::move(*model)};
      Vec3 sunk(0, bed.organism->place.raise > 0 ? 0 : grower.copy_depth(specimen.model) * stance.size, 0);
      put(specimen.model, stance.foot - sunk, stance.turn, stance.size);
      put_on(specimen, *dress, world, planting.seed);
      grown[i] = std::move(specimen);
    } else {
      grown[i] = model.errors();
    }
    step();
  });
  return grown;
}

}  // namespace frond
