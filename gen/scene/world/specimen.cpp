#include "world/specimen.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/bytes.h"
#include "world/other_barks.h"

namespace frond {

namespace {

void put_skeleton(Skeleton& s, Vec3 foot, Quat turn, float size) {
  for (std::size_t i = 0; i < s.size(); ++i) {
    s.position[i] = foot + turn * (s.position[i] * size);
    s.radius[i] *= size;
    s.distance[i] *= size;
    s.to_tip[i] *= size;
  }
}

void put_places(std::vector<Vec3>& places, Vec3 foot, Quat turn, float size) {
  for (Vec3& p : places) p = foot + turn * (p * size);
}

void put_surface(Surface& surface, Vec3 foot, Quat turn, float size) {
  put_places(surface.position, foot, turn, size);
  for (Vec3& n : surface.normal) n = turn * n;
}

/// Placements of organs or of solids.
template <class Placed>
void put_placed(Placed& placed, Vec3 foot, Quat turn, float size) {
  put_places(placed.position, foot, turn, size);
  for (Quat& own : placed.turn) own = glm::normalize(turn * own);
  for (Vec3& scale : placed.scale) scale *= size;
}

void pose_falling(const Specimen& specimen, double time, Pose& pose) {
  const Life& life = specimen.life;
  Motion calmed = specimen.motion;
  calmed.wave.amplitude *= life.fall->sway(time);
  calmed.exposure *= life.fall->sway(time);
  pose_skeleton(specimen.model.skeleton, calmed, time, pose);
  auto ground = [&](double x, double z) { return (*life.ground)(x, z); };
  turn_fallen(*life.fall, specimen.model.skeleton, time, ground, pose);
}

}  // namespace

std::size_t bytes_of(const Specimen& specimen) {
  const Life& life = specimen.life;
  std::size_t bytes = bytes_of(specimen.model) + bytes_of(specimen.name) + life.held;
  if (life.ground) bytes += life.ground->bytes();
  if (const auto& sway = specimen.motion.sway)
    bytes += bytes_of(sway->give) + bytes_of(sway->second) + bytes_of(sway->limb) + bytes_of(sway->limbs) +
             bytes_of(sway->response);
  if (const auto& h = life.hanging) {
    const Strands& s = h->strands;
    bytes += bytes_of(s.skeleton) + bytes_of(s.normal) + bytes_of(s.contact) + bytes_of(s.age) +
             bytes_of(s.hanging) + bytes_of(s.room) + bytes_of(s.of) + bytes_of(s.strands);
    if (h->paths) bytes += bytes_of(h->paths->node) + bytes_of(h->paths->tilt);
  }
  return bytes;
}

void transform(Model& model, Vec3 foot, Quat turn, float size) {
  put_skeleton(model.skeleton, foot, turn, size);
  for (float& girth : model.girth) girth *= size;
  put_placed(model.organs, foot, turn, size);
  put_placed(model.solids, foot, turn, size);
  put_surface(model.hull, foot, turn, size);
  put_places(model.blades.foot, foot, turn, size);
  put_surface(model.blades.surface, foot, turn, size);
}

void edit_specimen(Specimen& specimen, std::span<const Edit> edits) {
  if (edits.empty()) return;
  Life& life = specimen.life;
  BranchLook& worn = specimen.look.branches;
  add_other_barks(worn, edits);
  if (life.edit) {
    const auto edit = std::exchange(life.edit, {});
    edit(specimen, edits);
    life.edit = {};
    return;
  }
  const Placement& placed = specimen.placement;
  std::vector<Edit> here(edits.begin(), edits.end());
  for (Edit& edit : here)
    if (edit.bend) *edit.bend = placed.turn * (*edit.bend * placed.size);
  const std::size_t colors = worn.own_colors();
  color_barks(specimen.model, here, colors);
  std::vector<float> levers = edit_model(specimen.model, here);
  if (life.develop)
    life.develop = [develop = life.develop, here = std::move(here), levers = std::move(levers),
                    colors](double time) {
      Result<Model> now = develop(time);
      if (now) color_barks(*now, here, colors), edit_model(*now, here, levers);
      return now;
    };
}

void set_courses(Specimen& specimen, const Courses& courses, Seed seed) {
  std::optional<Condition> condition = condition_of(courses, specimen.look, seed);
  if (!condition) return;
  Life& life = specimen.life;
  lay_turf(*condition, specimen.model.solids);
  // It is copied for each frame: what its bodies were as they grew is left out where no film sees that.
  if (specimen.motion.growth.duration <= 0)
    for (Solid& solid : specimen.model.solids.shapes) solid.past.clear();
  add_ailing(specimen.model, specimen.look, courses);
  if (life.develop)
    life.develop = [develop = life.develop, worn = specimen.look, courses](double time) {
      Result<Model> now = develop(time);
      if (now) add_ailing(*now, worn, courses);
      return now;
    };
  specimen.look = ail_look(specimen.look, courses);
  life.condition = std::move(condition);
}

Surface skin_of(const Model& model) {
  Surface skin = model.hull.triangle.empty() ? merged(model.solids) : model.hull;
  skin.uv.clear();
  return skin;
}

void set_wind(Specimen& specimen, std::shared_ptr<const WindField> wind) {
  Motion& motion = specimen.motion;
  motion.sway = std::make_shared<const Sway>(
      sway_of(specimen.model, motion.wood.value_or(SwayWood{}), std::move(wind)));
}

Result<std::shared_ptr<const Specimen>> developed(const Specimen& specimen, double time) {
  const Life& life = specimen.life;
  if (!life.changes()) return std::shared_ptr<const Specimen>(std::shared_ptr<void>(), &specimen);
  Result<Model> model = life.develop ? life.develop(time) : specimen.model;
  if (!model) return model.errors();
  Specimen now{specimen, std::move(*model)};
  if (life.develop) now.motion.growth = {};  // it is revealed already
  GroundAt ground;
  if (life.ground) ground = [&](double x, double z) { return (*life.ground)(x, z); };
  if (life.season)
    in_season(now.model.organs, now.model.prototypes, *life.season, time, life.season_seed, ground);
  if (life.condition) {
    put_in(now.model, *life.condition, time, ground);
    now.look = look_at(specimen.look, *life.condition, time), now.shift = life.condition->shift(time);
  }
  if (const auto& sway = specimen.motion.sway) set_wind(now, sway->wind);
  return std::make_shared<const Specimen>(std::move(now));
}

void pose_specimen(const Specimen& specimen, double time, Pose& pose) {
  const Skeleton& rest = specimen.model.skeleton;
  if (specimen.life.fall && specimen.life.ground) return pose_falling(specimen, time, pose);
  const std::optional<Hanging>& hanging = specimen.life.hanging;
  bool swings = hanging && std::ranges::any_of(hanging->strands.hanging, [](auto held) { return held != 0; });
  if (!swings) return pose_skeleton(rest, specimen.motion, time, pose);
  // A creeper is revealed along strands that the wind has moved.
  std::vector<Quat> turn;
  Skeleton moved = rest;
  if (hanging->paths)
    swing_strands(hanging->strands, *hanging->paths, time, moved.position, turn);
  else
    swing_strands(hanging->strands, hanging->breeze, time, moved.position, turn);
  pose_skeleton(moved, specimen.motion, time, pose);
  for (std::size_t i = 0; i < turn.size(); ++i) pose.turn[i] = pose.turn[i] * turn[i];
}

std::vector<Vec3> fallen_nodes(const Specimen& specimen) {
  Pose pose;
  if (const auto& fall = specimen.life.fall) pose_specimen(specimen, fall->start + fall->length(), pose);
  return pose.position;
}

std::string Specimen::find_fault() const {
  if (std::string fault = model.find_fault(); !fault.empty()) return fault;
  if (!std::isfinite(brightness) || brightness <= 0) return "its brightness is no factor";
  if (model.skeleton.size() > 1 && style.voxel <= 0) return "its style has no voxel";
  if (look.branches.skin && look.branches.bark) return "its branches have both a skin and a bark";
  return {};
}

}  // namespace frond
