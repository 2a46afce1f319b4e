#include "scene/copies.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

#include "core/bounds.h"
#include "core/content.h"
#include "geometry/far.h"
#include "geometry/tubes.h"
#include "motion/unfold.h"
#include "scene/colony_state.h"
#include "scene/copy_organs.h"
#include "world/other_barks.h"

namespace frond {

namespace {

constexpr std::uint64_t kShapes = 7;  // another number gives other shapes
constexpr float kRipe = 0.87f;        // share of its growth up to which the skin of a body is hardly paler

/// The seed of a model. It depends on nothing that its organism says, so that what is changed there changes
/// no more than it tells.
Seed copy_seed(const Organism& organism, int which) {
  const std::vector<int>& seeds = organism.sown->seeds;
  auto index = static_cast<std::size_t>(which);
  return Seed{index < seeds.size() ? static_cast<std::uint64_t>(seeds[index]) : index + 1};
}

/// Branches of a coral as tubes with rounded ends; u of their `uv` is how young they are, 1 at tips.
Surface skin_tubes(Skeleton bones, float grain, double young_length) {
  set_tip_distances(bones);
  TubeMesh mesh = closed_tubes(bones, bones.position, bones.radius, 2, 28, grain);
  auto length = static_cast<float>(std::max(young_length, 1e-6));
  for (std::size_t v = 0; v < mesh.node.size(); ++v)
    mesh.surface.uv[v] = {1 - smooth_step(0.0f, length, bones.to_tip[static_cast<std::size_t>(mesh.node[v])]),
                          0};
  return std::move(mesh.surface);
}

Surface merged_solid(const Solids& solids, std::size_t shape) {
  Surface out;
  for (std::size_t i = 0; i < solids.size(); ++i)
    if (solids.shape[i] == shape)
      append_placed(out, solids.shapes[shape].surface, solids.position[i], solids.turn[i], solids.scale[i]);
  return out;
}

/// The radius within which nineteen in twenty of some places are about the vertical through the origin.
float crown_of(const std::vector<Vec3>& places) {
  std::vector<float> radius;
  for (const Vec3& p : places) radius.push_back(glm::length(Vec2(p.x, p.z)));
  auto at = radius.begin() + std::ssize(radius) * 19 / 20;
  std::ranges::nth_element(radius, at);
  return *at;
}

/// Stretches bodies to a size, together.
void fit_to(Solids& solids, const ModelSize& size) {
  Bounds box = bounds_of(solids);
  float across = size.crown / std::max({box.high.x, -box.low.x, box.high.z, -box.low.z, 1e-3f}),
        up = size.height / std::max(box.high.y, 1e-3f);
  Solids fitted;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    Solid& shape = solids.shapes[solids.shape[i]];
    Solid own{.surface = shape.surface, .material = shape.material};
    for (std::size_t v = 0; v < own.surface.position.size(); ++v)
      own.surface.position[v] = Vec3(across, up, across) * solids.placed(i, shape.surface.position[v]);
    // What is fitted is of any age: no more of it has just grown than of others.
    if (is_of_reef(own.material.matter))
      for (Vec2& uv : own.surface.uv) uv.y = std::min(uv.y, kRipe);
    for (Vec3& n : own.surface.normal)
      n = glm::normalize(solids.turn[i] * (n / solids.scale[i]) / Vec3(across, up, across));
    fitted.place(fitted.add_shape(std::move(own)));
  }
  solids = std::move(fitted);
}

/// Stretches a plant to a size: its leaves keep their shape.
void fit_to(Model& model, const ModelSize& size) {
  if (model.solids.size() > 0) fit_to(model.solids, size);
  Skeleton& bones = model.skeleton;
  if (bones.size() < 2) return;
  float height = 1e-3f;
  for (const Vec3& p : bones.position) height = std::max(height, p.y);
  float across = size.crown / std::max(crown_of(bones.position), 1e-3f), up = size.height / height;
  float thick = size.stem / std::max(2 * bones.radius[0], 1e-5f);
  auto stretch = [&](std::vector<Vec3>& places) {
    for (Vec3& p : places) p *= Vec3(across, up, across);
  };
  stretch(bones.position), stretch(model.organs.position), stretch(model.blades.surface.position);
  // Twigs are as thick as they are on any tree.
  for (float& r : bones.radius) r *= std::lerp(1.0f, thick, std::min(1.0f, r / bones.radius[0]));
  for (Vec3& s : model.organs.scale) s *= std::clamp(std::cbrt(across * across * up), 0.7f, 1.6f);
}

}  // namespace

int level_for(double grain) {
  int level = 0;
  while (level + 1 < kLevelCount && kLevels[level + 1].grain <= grain) ++level;
  return level;
}

std::string copy_id(const Organism& organism, int which, bool bare) {
  Keys keys = organism.grower->keys();
  std::string id = fmt::format("{} {} {} {} {}{}", keys.shape, keys.look, copy_seed(organism, which).key,
                               organism.sown->crowd, organism.place.size_variation, bare ? " bare" : "");
  if (const auto& size = organism.sown->size)
    id += fmt::format(" {} {} {}", size->height, size->crown, size->stem);
  if (organism.sown->state != ColonyState::living)
    id += organism.sown->state == ColonyState::dead ? " dead" : " bleached";
  return made_id(id);
}

ColorShift tint_shift(const CopyTint& tint, int number) {
  // Steps that are no multiples of each other, so that the three do not go together.
  auto spread = [&](int step) { return 2.0 * ((number * step) % kTints + 0.5) / kTints - 1; };
  return {tint.hue * spread(5), 1 + tint.saturation * spread(7), 1 + tint.value * spread(1)};
}

namespace {

Seed model_seed(const Organism& organism, int which) {
  return copy_seed(organism, which).child("copy", kShapes);
}

}  // namespace

std::optional<Seasons> copy_seasons(const Organism& organism, const Film& film) {
  std::optional<Seasons> seasons = organism.grower->appearance().season;
  if (film.frames <= 1 || !seasons || seasons->at.constant()) return std::nullopt;
  if (seasons->evergreen && !seasons->blossom && !seasons->fruit && !seasons->flowering) return std::nullopt;
  return seasons;
}

Organs copy_organs(const Organism& organism, int which, const Model& full, const Seasons& seasons,
                   double time) {
  Organs now = full.organs;
  in_season(now, full.prototypes, seasons, time, model_seed(organism, which).child("season"));
  return now;
}

std::optional<Condition> copy_condition(const Organism& organism, int which) {
  if (!organism.courses.health && !organism.courses.tint && !organism.grower->traits().colony)
    return std::nullopt;
  return condition_of(organism.courses, organism.grower->appearance().look,
                      model_seed(organism, which).child("courses"));
}

Appearance copy_appearance(const Organism& organism) {
  Appearance appearance = organism.grower->appearance();
  add_other_barks(appearance.look.branches, edits_of(organism.edits, std::nullopt));
  if (auto& skin = appearance.look.branches.skin) skin = skin_in(*skin, organism.sown->state);
  return appearance;
}

Result<Model> grow_copy(const Organism& organism, int which, bool full_leaf) {
  Seed seed = model_seed(organism, which);
  Result<Model> model = organism.grower->grow_copy(organism, seed);
  if (!model) return model;
  const std::vector<Edit> edits = edits_of(organism.edits, std::nullopt);
  const Appearance appearance = organism.grower->appearance();
  color_barks(*model, edits, appearance.look.branches.own_colors());
  edit_model(*model, edits);
  if (appearance.season && !full_leaf) in_season(*model, *appearance.season, 0, seed.child("season"));
  if (organism.sown->size) fit_to(*model, *organism.sown->size);
  for (Solid& solid : model->solids.shapes)
    solid.material = material_in(solid.material, organism.sown->state);
  float depth = depth_of(*organism.grower, *model);
  for (auto* places : {&model->skeleton.position, &model->organs.position, &model->blades.surface.position})
    for (Vec3& p : *places) p.y -= depth;
  return model;
}

std::optional<Growth> copy_growth(const Organism& organism, const Film& film, int which) {
  Growth growth = organism.grower->appearance().motion.growth;
  if (film.frames <= 1 || growth.duration <= 0 || organism.grower->traits().develops(true))
    return std::nullopt;
  growth.start += growth.stagger * copy_seed(organism, which).child("start").unit();
  return growth;
}

std::optional<Model> grown_by(const Model& model, const Motion& motion, double time) {
  Motion growing = motion;
  growing.wave.amplitude = 0, growing.food = {}, growing.limbs = false, growing.flutter.amplitude = 0;
  growing.sway = nullptr;
  auto front = static_cast<float>(growth_front(growing.growth, time));
  if (front <= 0) return std::nullopt;
  if (static_cast<double>(front) >= 1 + growing.growth.ripen) return model;
  Pose pose;
  pose_skeleton(model.skeleton, growing, time, pose);
  Model now = posed_organs(model, growing, pose, time, front);
  // Nodes that are reached, and the tips that are on their way to the next.
  const Skeleton& all = model.skeleton;
  std::vector<std::int32_t> index(all.size(), Skeleton::kRoot);
  for (std::size_t i = 0; i < all.size(); ++i) {
    bool root = all.parent[i] == Skeleton::kRoot;
    auto below = root ? i : static_cast<std::size_t>(all.parent[i]);
    if (all.birth[below] > front) continue;
    index[i] = now.skeleton.add(pose.position[i], std::max(pose.radius[i], 1e-6f),
                                root ? Skeleton::kRoot : index[below], all.order[i]);
    now.skeleton.birth.back() = all.birth[i];
    if (!model.color.empty()) now.color.push_back(model.color[i]);
  }
  set_tip_distances(now.skeleton);
  now.blades.surface =
      posed_blades(all, pose, model.blades, unfold_time(growing), [](std::size_t) { return true; });
  now.solids = grown_to(model.solids, front);
  return now;
}

ModelBlocks::ModelBlocks(std::span<const Vec3> bits) {
  constexpr float kSide = 3, kUncut = 5;  // metres
  Bounds box = bits.empty() ? Bounds{Vec3(0), Vec3(0)} : bounds_of(bits);
  side_ = box.longest();
  bool cut = side_ > kUncut;
  if (cut) side_ = kSide;
  // The trunk stands in the middle of its blocks.
  low_ = cut ? Vec3(-0.5f, 0, -0.5f) * side_ : (box.low + box.high - side_) * 0.5f;
  std::set<std::array<int, 3>> cells;
  if (!cut) cells.insert({0, 0, 0});
  for (const Vec3& at : cut ? bits : std::span<const Vec3>{}) {
    glm::ivec3 cell(glm::floor((at - low_) / side_));
    cells.insert({cell.x, cell.y, cell.z});
  }
  for (auto [x, y, z] : cells) cells_.emplace_back(x, y, z);
}

int ModelBlocks::of(Vec3 at) const {
  int best = 0;
  float least = 1e30f;
  for (int i = 0; i < count(); ++i) {
    // By the largest of the three ways: its own cell comes before all others.
    Vec3 offset = glm::abs(at - middle(i));
    float far = std::max({offset.x, offset.y, offset.z});
    if (far < least) least = far, best = i;
  }
  return best;
}

Surface in_block(const CopyPart& part, int block) {
  std::vector<std::array<std::uint32_t, 3>> own;
  for (std::size_t t = 0; t < part.surface.triangle.size(); ++t)
    if (part.block[t] == block) own.push_back(part.surface.triangle[t]);
  return with_corners_of(part.surface, std::move(own));
}

std::vector<CopyPart> copy_parts(const Look& look, const Model& model, const CopyDetail& detail,
                                 const ModelBlocks* blocks, const Organs* now) {
  std::vector<CopyPart> parts;
  auto add = [&](CopyPart::Kind kind, std::size_t which, std::size_t part, Surface surface) {
    if (surface.triangle.empty()) return;
    std::vector<int> block;
    for (std::size_t t = 0; blocks && t < surface.triangle.size(); ++t)
      block.push_back(blocks->of(surface.position[surface.triangle[t][0]]));
    parts.push_back({kind, which, part, std::move(surface), std::move(block)});
  };
  if (model.skeleton.size() > 1) {
    auto fine = static_cast<float>(detail.grain);
    TubeShape shape;
    const std::optional<BarkCoat>& coat = look.branches.coat;
    if (coat) shape.wrap = coat->wrap, shape.aspect = coat->aspect;
    shape.side = std::max(coat ? coat->facet : 0.02, 4 * detail.grain);
    std::vector<std::int32_t> kept;
    const float tolerance = bark_changes_within(look.branches, model) ? -1 : 0.5f * fine;
    Skeleton bones = thinned(model.skeleton, 0.4f * fine, tolerance, &kept);
    if (look.branches.coral()) {
      add(CopyPart::Kind::wood, 0, 0, skin_tubes(std::move(bones), fine, look.branches.young_length()));
    } else {
      TubeMesh tubes = tube_mesh(bones, bones.position, bones.radius, {}, shape);
      for (std::int32_t& node : tubes.node) node = kept[static_cast<std::size_t>(node)];
      for (std::size_t k = 0; Surface & bark : by_bark(look.branches, model, tubes))
        add(CopyPart::Kind::wood, k++, 0, std::move(bark));
    }
  }
  // Fruit takes nothing from the leaves, and a small share beside them; others as their area says, and what
  // comes in its season only or is small a little.
  constexpr double kOfFruit = 8, kLeastShare = 0.1;
  CopyDetail each = detail, fruit = detail;
  fruit.leaves /= kOfFruit, fruit.solid = true;
  const std::vector<double> areas = organ_areas(model);
  const double area = std::reduce(areas.begin(), areas.end());
  each.cover = hiding_share(model, area);
  auto share = [&](double of) { return std::max(kLeastShare, area > 0 ? of / area : 0); };
  double shares = 0;
  for (double of : areas) shares += of > 0 ? share(of) : 0;
  for (std::size_t p = 0; p < model.prototypes.size(); ++p) {
    each.leaves = detail.leaves * share(areas[p]) / std::max(1.0, shares) /
                  static_cast<double>(std::max<std::size_t>(1, model.prototypes[p].parts.size()));
    std::vector<CopyPart> merged =
        merged_organs(model, p, is_fruit(model.prototypes[p]) ? fruit : each, blocks, now);
    for (std::size_t k = 0; k < merged.size(); ++k)
      if (!merged[k].surface.triangle.empty())
        parts.push_back(
            {CopyPart::Kind::organ, p, k, std::move(merged[k].surface), std::move(merged[k].block)});
  }
  add(CopyPart::Kind::blade, 0, 0, model.blades.surface);
  for (std::size_t s = 0; s < model.solids.shapes.size(); ++s)
    add(CopyPart::Kind::solid, s, 0, merged_solid(model.solids, s));
  return parts;
}

}  // namespace frond
