#include "draw/twig_plan.h"

#include <algorithm>
#include <cmath>

#include "core/bounds.h"
#include "core/parallel.h"
#include "draw/eyes.h"
#include "draw/twig_kinds.h"

namespace frond {

namespace {

constexpr std::size_t kManyPlaces = 200;                      // twigs, likewise
constexpr std::uint32_t kLeastOrgans = 1, kMostOrgans = 120;  // on a twig that is replaced
constexpr double kOrganPixels = 8;                            // the longest organ of one
constexpr double kThickPixels = 0.6;                          // its radius at the joint
constexpr std::size_t kMostEyes = 200;                        // that are asked how near they come

/// Whether a plant keeps its shape but for what the wind does, and wears nothing that lies on its twigs.
bool keeps_shape(const Specimen& b) {
  const Life& life = b.life;
  return b.look.branches.plant() && b.style.build == Build::sweeps && b.motion.growth.duration <= 0 &&
         !b.motion.food.pulls() && !life.changes() && !life.hanging && !life.fall && !b.load &&
         b.model.blades.size() == 0 && b.model.light.empty() && b.model.organs.loose.empty();
}

/// Whether all leaves that it bears are broad ones of pictures: needles made few would be a veil.
bool bears_pictures(const Model& model) {
  std::vector<char> borne(model.prototypes.size());
  for (std::uint16_t which : model.organs.prototype) borne[which] = 1;
  for (std::size_t p = 0; p < borne.size(); ++p)
    for (const OrganPart& part : model.prototypes[p].parts)
      if (borne[p] && is_leaf(part.tissue) && part.pictures.empty()) return false;
  return true;
}

/// What grows from a node and beyond it.
struct Bough {
  std::uint32_t organs = 0;
  float organ = 0;  // metres, the reach of the largest
  Bounds box;       // of its nodes and organs
};

std::vector<Bough> boughs_of(const Model& model) {
  const Skeleton& s = model.skeleton;
  std::vector<Bough> boughs(s.size());
  std::vector<float> reach;
  for (const Prototype& prototype : model.prototypes) reach.push_back(reach_of(prototype));
  for (std::size_t i = 0; i < s.size(); ++i) boughs[i].box.extend(s.position[i]);
  for (std::size_t i = 0; i < model.organs.size(); ++i) {
    if (model.organs.node[i] == Skeleton::kRoot) continue;
    Bough& bough = boughs[static_cast<std::size_t>(model.organs.node[i])];
    Vec3 scale = model.organs.scale[i];
    ++bough.organs;
    bough.organ =
        std::max(bough.organ, reach[model.organs.prototype[i]] * std::max({scale.x, scale.y, scale.z}));
    bough.box.extend(model.organs.position[i]);
  }
  for (std::size_t i = s.size(); i-- > 0;) {
    if (s.parent[i] == Skeleton::kRoot) continue;
    Bough& below = boughs[static_cast<std::size_t>(s.parent[i])];
    below.organs += boughs[i].organs;
    below.organ = std::max(below.organ, boughs[i].organ);
    below.box.extend(boughs[i].box.low), below.box.extend(boughs[i].box.high);
  }
  return boughs;
}

/// Cuts a plant into limbs and twigs as large as they may be. Gives the first node of the twig that each node
/// is on, kRoot for limbs, and notes the least pixel at any twig.
std::vector<std::int32_t> cut_twigs(const Model& model, const std::vector<Eye>& eyes, double longest,
                                    double& grain) {
  const Skeleton& s = model.skeleton;
  std::vector<Bough> boughs = boughs_of(model);
  double widest = 0;  // metres of a pixel, anywhere
  for (const Eye& eye : eyes)
    for (Vec3 corner : {boughs[0].box.low, boughs[0].box.high})
      widest = std::max(widest, eye.pixel * static_cast<double>(glm::distance(eye.at, corner) +
                                                                glm::length(boughs[0].box.size())));
  std::vector<std::int32_t> twig(s.size(), Skeleton::kRoot);
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (s.parent[i] == Skeleton::kRoot) continue;
    auto below = static_cast<std::size_t>(s.parent[i]);
    if ((twig[i] = twig[below]) != Skeleton::kRoot || boughs[i].organs < kLeastOrgans ||
        boughs[i].organs > kMostOrgans)
      continue;
    Bounds box = boughs[i].box;
    box.extend(s.position[below]);
    auto length = static_cast<double>(box.longest());
    if (length > longest * widest) continue;
    double pixel = nearest_pixel(eyes, box.middle(), glm::length(box.size()) / 2);
    if (length > longest * pixel || static_cast<double>(boughs[i].organ) > kOrganPixels * pixel ||
        static_cast<double>(s.radius[i]) > kThickPixels * pixel)
      continue;
    twig[i] = static_cast<std::int32_t>(i);
    grain = std::min(grain, pixel);
  }
  return twig;
}

/// The branches that no twig is on.
void set_limbs(TwigPlan& plan, const Model& model, const std::vector<std::int32_t>& twig) {
  const Skeleton& s = model.skeleton;
  std::vector<std::int32_t> index(s.size(), Skeleton::kRoot);
  Skeleton& limbs = plan.limbs.skeleton;
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (twig[i] != Skeleton::kRoot) continue;
    std::int32_t below = s.parent[i];
    index[i] =
        limbs.add(s.position[i], s.radius[i],
                  below == Skeleton::kRoot ? below : index[static_cast<std::size_t>(below)], s.order[i]);
    limbs.distance.back() = s.distance[i], limbs.to_tip.back() = s.to_tip[i], limbs.birth.back() = s.birth[i];
    plan.origin.push_back(static_cast<std::int32_t>(i));
    if (!model.color.empty()) plan.limbs.color.push_back(model.color[i]);
    if (!model.girth.empty()) plan.limbs.girth.push_back(model.girth[i]);
  }
}

}  // namespace

std::shared_ptr<const TwigPlan> twig_plan(const Specimen& plant, const std::vector<Eye>& eyes,
                                          double longest) {
  const Model& model = plant.model;
  if (longest <= 0 || eyes.empty() || model.organs.size() < kManyOrgans || !keeps_shape(plant) ||
      !bears_pictures(model))
    return nullptr;
  double grain = 1e30;
  std::vector<std::int32_t> twig = cut_twigs(model, eyes, longest, grain);
  auto plan = std::make_shared<TwigPlan>();
  plan->grain = grain;
  std::vector<std::uint32_t> place(twig.size());  // of what begins at a node
  for (std::size_t i = 0; i < twig.size(); ++i) {
    if (twig[i] != static_cast<std::int32_t>(i)) continue;
    place[i] = static_cast<std::uint32_t>(plan->places.size());
    plan->places.push_back({.node = twig[i]});
  }
  if (plan->places.size() < kManyPlaces) return nullptr;
  std::vector<std::vector<std::uint32_t>> organs(plan->places.size());
  plan->replaced.resize(model.organs.size());
  for (std::size_t i = 0; i < model.organs.size(); ++i) {
    std::int32_t node = model.organs.node[i], first = node < 0 ? node : twig[static_cast<std::size_t>(node)];
    if (first == Skeleton::kRoot) continue;
    plan->replaced[i] = 1;
    organs[place[static_cast<std::size_t>(first)]].push_back(static_cast<std::uint32_t>(i));
  }
  std::vector<TwigTraits> traits(organs.size());
  parallel_for(organs.size(),
               [&](std::size_t k) { traits[k] = traits_of(model, plan->places[k].node, organs[k]); });
  std::vector<std::uint32_t> kept = choose_kinds(traits), kind = nearest_kinds(traits, kept);
  std::vector<std::uint32_t> of_place(organs.size(), static_cast<std::uint32_t>(kept.size()));
  for (std::uint32_t k = 0; k < kept.size(); ++k) {
    plan->palette.push_back({plan->places[kept[k]].node, {}, organs[kept[k]]});
    of_place[kept[k]] = k;
  }
  for (std::size_t i = 0; i < twig.size(); ++i) {
    if (twig[i] == Skeleton::kRoot) continue;
    if (std::uint32_t k = of_place[place[static_cast<std::size_t>(twig[i])]]; k < kept.size())
      plan->palette[k].nodes.push_back(static_cast<std::int32_t>(i));
  }
  for (std::size_t k = 0; k < organs.size(); ++k) {
    const TwigTraits &own = traits[k], &other = traits[kept[kind[k]]];
    TwigPlan::Place& here = plan->places[k];
    here.organ = organs[k].front();
    here.kept = kind[k];
    here.scale = scale_between(other, own);
    here.turn = glm::normalize(own.axes * glm::conjugate(other.axes));
  }
  set_limbs(*plan, model, twig);
  return plan;
}

std::vector<std::shared_ptr<const TwigPlan>> twig_plans(const Scene& scene) {
  std::vector<std::shared_ptr<const TwigPlan>> plans(scene.specimens.size());
  if (scene.film.twigs <= 0) return plans;
  std::vector<Eye> all = different_eyes(scene), some;
  for (std::size_t k = 0; k < all.size(); k += 1 + all.size() / kMostEyes) some.push_back(all[k]);
  for (std::size_t i = 0; i < plans.size(); ++i)
    plans[i] = twig_plan(scene.specimens[i], some, scene.film.twigs);
  return plans;
}

}  // namespace frond
