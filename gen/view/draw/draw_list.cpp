#include "draw/draw_list.h"

namespace frond {

namespace {

constexpr double kLeafGloss = 0.2, kLightThroughLeaf = 0.35, kGlassOpacity = 0.35;

Pose pose_at(const Specimen& specimen, double time) {
  Pose pose;
  pose_specimen(specimen, time, pose);
  return pose;
}

Pose rest_pose(const Skeleton& rest) {
  Pose pose{rest.position, rest.radius, std::vector<Quat>(rest.size(), Quat(1, 0, 0, 0))};
  pose.front = 2;
  return pose;
}

}  // namespace

PlainLook plain_look(const Prototype& organ, std::size_t part, std::size_t color) {
  const OrganPart& shape = organ.parts[part];
  PlainLook look{shape.tissue == Tissue::heart ? organ.second : organ.colors[color], kLeafGloss};
  if (organ.luster) look.gloss = organ.luster->gloss;
  if (is_leaf(shape.tissue))
    look.both_sides = true, look.light_through = organ.luster ? organ.luster->through : kLightThroughLeaf;
  if (!shape.pictures.empty()) look.picture = shape.pictures[color % shape.pictures.size()];
  return look;
}

PlainLook plain_look(const BladeLook& blades, std::size_t color) {
  return {blades.colors[color], kLeafGloss, true, kLightThroughLeaf};
}

PlainLook plain_look(const Material& body) {
  return {.color = body.color,
          .gloss = body.gloss,
          .opacity = body.matter == Matter::glass ? kGlassOpacity : 1,
          .picture = body.picture};
}

DrawList::DrawList(const Specimen& specimen, double time, const Solids& solids, const TwigPlan* plan)
    : DrawList(specimen, specimen.model, pose_at(specimen, time), time, solids, plan) {
  if (plan) twigs.emplace(*plan, specimen, pose, time);
}

DrawList::DrawList(const Traits& own, const Model& at_rest)
    : DrawList(own, at_rest, rest_pose(at_rest.skeleton), 0, at_rest.solids, nullptr) {}

DrawList::DrawList(const Traits& own, const Model& grown, Pose posed, double time, const Solids& solids,
                   const TwigPlan* plan)
    : traits(own),
      model(grown),
      pose(std::move(posed)),
      organs(traits, model, pose, time,
             plan ? std::span<const char>(plan->replaced) : std::span<const char>()),
      blades(drawn_blades(traits, model, pose)),
      bodies(still_bodies(solids, traits.motion.growth)) {
  if (plan) limbs = pose_of_limbs(*plan, pose);
  if (traits.look.branches.drawn())
    branches.emplace(DrawnBranches{traits, plan ? plan->limbs : model, plan ? *limbs : pose});
  for (DrawnBody& body : growing_bodies(solids, traits.motion.growth, time))
    bodies.push_back(std::move(body));
}

}  // namespace frond
