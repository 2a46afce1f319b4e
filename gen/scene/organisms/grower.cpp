#include "organisms/grower.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "organisms/organism.h"

namespace frond {

namespace {

constexpr float kNear = 0.1f;  // metres round a tree in which bodies count

Quat yaw_of(const Organism& organism, const Planting& planting) {
  const Place& place = organism.place;
  double turn = planting.turn + place.turn + place.turn_variation * planting.seed.child("turn").range(-1, 1);
  return glm::angleAxis(static_cast<float>(turn), Vec3(0, 1, 0));
}

/// On a slope as upright as `place` says, and leaning.
Placement placement_of(const Organism& organism, const Planting& planting) {
  Vec3 up = glm::mix(planting.normal, Vec3(0, 1, 0), static_cast<float>(organism.place.upright));
  bool slopes = planting.normal != Vec3(0, 1, 0) && glm::dot(up, up) > 1e-6f;
  Quat slope = slopes ? Quat(Vec3(0, 1, 0), glm::normalize(up)) : Quat(1, 0, 0, 0);
  return {planting.foot, lean_of(organism, planting.seed) * slope * yaw_of(organism, planting),
          size_of(organism, planting)};
}

/// Round the bodies that come near to a model at its place, in its own space; empty where none does.
Result<Detour> detour_near(const Model& model, const World& world, const Placement& p) {
  Bounds box;
  for (Vec3 at : model.skeleton.position) box.extend(p.foot + p.turn * (at * p.size), kNear);
  Result<std::shared_ptr<const Obstacles>> bodies = world.obstacles();
  if (!bodies) return bodies.errors();
  if (!(*bodies)->near(box)) return Detour();
  Detour detour = [obstacles = *bodies, p](Vec3 from, Vec3 to, float clearance) -> std::optional<Vec3> {
    Vec3 end = p.foot + p.turn * (to * p.size);
    std::optional<Vec3> way = obstacles->way(p.foot + p.turn * (from * p.size), end, clearance * p.size);
    if (!way || *way == end) return way ? std::optional(to) : way;
    return (glm::conjugate(p.turn) * (*way - p.foot)) / p.size;
  };
  return detour;
}

void follow_ground(Solids& solids, const World& world, float foot_height) {
  for (Vec3& p : solids.position) p.y += static_cast<float>(world.height({p.x, p.z})) - foot_height;
}

}  // namespace

Quat lean_of(const Organism& organism, Seed planting) {
  double toward = planting.child("toward").range(0, 2 * kPi);
  Vec3 axis(std::cos(toward), 0, std::sin(toward));
  return glm::angleAxis(static_cast<float>(organism.place.lean * planting.child("lean").unit()), axis);
}

float size_of(const Organism& organism, const Planting& planting) {
  return static_cast<float>(planting.size *
                            (1 + organism.place.size_variation * planting.seed.child("size").range(-1, 1)));
}

float depth_of(const Grower& grower, const Model& model) {
  if (model.skeleton.size() == 0) return 0;
  const GrowerTraits traits = grower.traits();
  float depth = traits.sunk * model.skeleton.radius[0];
  return traits.sunk_most > 0 ? std::min(depth, traits.sunk_most * model.skeleton.longest()) : depth;
}

double reach_of(const Organism& organism) {
  const Place& place = organism.place;
  double reach = glm::length(place.center) + place.radius;
  if (organism.count <= std::ssize(place.at)) reach = 0;  // none is scattered
  for (Vec2 at : place.at) reach = std::max<double>(reach, glm::length(at));
  return reach;
}

void apply_appearance(Specimen& specimen, const Appearance& appearance, const World& world, Seed seed) {
  specimen.look = appearance.look;
  specimen.brightness = 1 + appearance.variation * seed.child("brightness").range(-1, 1);
  specimen.motion = appearance.motion;
  specimen.motion.film_length = world.film_length();
  specimen.motion.growth = paced(appearance.motion.growth, length_of(specimen.model));
  specimen.motion.growth.start += appearance.motion.growth.stagger * seed.child("start").unit();
  specimen.motion.wave.phase += seed.child("phase").range(-0.6, 0.6);
  specimen.life.season = appearance.season;
  specimen.life.season_seed = seed.child("season");
  if (appearance.season) specimen.life.ground = world.ground();
}

std::vector<Result<Specimen>> LoneGrower::grow(std::span<const Bed> beds, const World& world,
                                               const Step& step) const {
  struct Task {
    const Bed& bed;
    const Planting& planting;
    std::shared_ptr<const Appearance> appearance;  // one for all of the bed
  };
  std::vector<Task> all;
  for (const Bed& bed : beds) {
    auto appearance = std::make_shared<const Appearance>(bed.organism->grower->appearance());
    for (const Planting& planting : bed.plantings) all.push_back({bed, planting, appearance});
  }
  auto grow_one = [&](const Task& task) -> Result<Specimen> {
    const auto& [bed, planting, appearance] = task;
    const auto& grower = grower_of<LoneGrower>(*bed.organism);
    const Organism& organism = *bed.organism;
    Seed seed = planting.seed.child("grow");
    Placement placement = placement_of(organism, planting);
    Result<Model> model = grower.grow_standing(world, planting, placement, seed);
    if (!model) return model.errors();
    if (model->solids.follow_ground) placement.turn = yaw_of(organism, planting);
    if (organism.place.raise <= 0) placement.foot.y -= depth_of(grower, *model) * placement.size;
    if (grower.traits().stage == GrowthStage::round_bodies) {
      Result<Detour> detour = detour_near(*model, world, placement);
      if (!detour) return detour.errors();
      if (*detour) model = grower.grow_round(*detour, seed);
    }
    if (!model) return model.errors();
    Specimen specimen{{organism.name, bed.entry}, std::move(*model)};
    specimen.placement = placement;
    transform(specimen.model, placement.foot, placement.turn, placement.size);
    if (specimen.model.solids.follow_ground && organism.place.raise == 0)
      follow_ground(specimen.model.solids, world, planting.foot.y);
    apply_appearance(specimen, *appearance, world, planting.seed);
    if (auto develop = grower.develop(specimen.motion, seed))
      specimen.life.develop = [develop = std::move(develop), placement](double time) {
        Result<Model> now = develop(time);
        if (now) transform(*now, placement.foot, placement.turn, placement.size);
        return now;
      };
    return specimen;
  };
  std::vector<Result<Specimen>> grown(all.size(), Error{});
  parallel_for(all.size(), [&](std::size_t i) {
    grown[i] = grow_one(all[i]);
    step();
  });
  return grown;
}

std::vector<Result<Specimen>> BedGrower::grow(std::span<const Bed> beds, const World& world,
                                              const Step& step) const {
  std::vector<Result<Specimen>> grown(beds.size(), Error{});
  parallel_for(beds.size(), [&](std::size_t i) {
    grown[i] = grower_of<BedGrower>(*beds[i].organism).grow_bed(beds[i], world);
    step();
  });
  return grown;
}

}  // namespace frond
