#include "export/export_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/bounds.h"
#include "core/printable.h"
#include "draw/draw_list.h"
#include "export/carry.h"
#include "export/parts.h"
#include "motion/unfold.h"
#include "scene/copies.h"

namespace frond {

namespace {

constexpr double kWoodShare = 0.4;  // of an organism's triangles, at most
constexpr double kTreeHeight = 20;  // metres, of the trees that the levels of forests are made for

/// The lowest place that it grows from, or the middle of what it stands on.
Vec3 foot_of(const Model& model) {
  Vec3 foot(0, std::numeric_limits<float>::max(), 0);
  for (std::size_t i = 0; i < model.skeleton.size(); ++i)
    if (model.skeleton.parent[i] == Skeleton::kRoot && model.skeleton.position[i].y < foot.y)
      foot = model.skeleton.position[i];
  if (model.skeleton.size() > 0) return foot;
  Bounds box = bounds_of(model);
  return box.empty() ? Vec3(0) : box.foot();
}

/// Takes the meshes of one organism to an exported scene.
class SceneExporter {
 public:
  /// `swarm`: what it is at the keys but the last, where that is organs elsewhere or bodies in other shapes.
  SceneExporter(Maker& maker, const Specimen& b, double time, std::vector<Model> swarm)
      : maker_(maker),
        options_(maker.options),
        b_(b),
        time_(time),
        drawn_(b, time),
        pose_(drawn_.pose),
        swarm_(std::move(swarm)) {
    if (swarm_.empty()) keys_.resize(std::max<std::size_t>(options_.keys.size(), 1) - 1);
    for (std::size_t k = 0; k < keys_.size(); ++k) pose_specimen(b, options_.keys[k], keys_[k]);
    maker_.begin(plain_name(b.name, "organism"), foot_of(b.model));
  }

  Errors add() {
    for (maker_.level = 0; maker_.level < options_.levels; ++maker_.level) {
      if (maker_.whole_is_crossed()) break;
      // At coarser levels wood may have what leaves do not take of their share.
      if (maker_.level > 0) add_organs();
      if (drawn_.branches)
        if (Errors errors = add_branches(); !errors.empty()) return errors;
      if (maker_.level == 0) add_organs();
      add_blades();
      add_bodies();
    }
    maker_.level = 0;
    return {};
  }

 private:
  Errors add_branches() {
    double spare = maker_.level == 0 ? 0 : std::max(0.0, maker_.share() * leaves_ - now_leaves_);
    double most = maker_.level == 0 ? kWoodShare * options_.detail : maker_.share() * wood_ + spare;
    maker_.spare = spare;
    Result<std::vector<BranchPart>> made = branch_parts(maker_, *drawn_.branches, most);
    if (!made) return made.errors();
    std::vector<ExportPart> parts;
    for (auto& [part, node] : *made) {
      for (const Pose& key : keys_)
        part.shifts.push_back(carried_on(b_.model.skeleton, pose_, key, part.surface, node));
      parts.push_back(std::move(part));
    }
    if (maker_.level == 0) wood_ = triangles_of(parts);
    add_in_place("branches", std::move(parts));
    maker_.spare = 0;
    return {};
  }

  void add_in_place(const std::string& part, std::vector<ExportPart> parts) {
    leave_out_still(parts);
    maker_.add_in_place(part, std::move(parts));
  }

  void add_organs() {
    if (b_.model.organs.size() == 0) return;
    if (options_.instances) return add_instances();
    Model posed = posed_organs(b_.model, b_.motion, pose_, time_, pose_.front);
    // What the branches have left.
    double most = std::max(options_.detail - wood_, (1 - kWoodShare) * options_.detail);
    if (maker_.level > 0) most = maker_.share() * leaves_;
    FoliageDetail detail{most, options_.texture > 0, !options_.keys.empty()};
    if (maker_.level > 0) detail.most = most_;
    auto foliage = [&](const Model& model) {
      std::vector<LeafPart> parts = foliage_parts(b_.look, model, detail);
      if (maker_.level == 0) most_ = most_larger(parts);
      return by_name(maker_, b_.look, model, std::move(parts));
    };
    std::map<std::string, std::vector<ExportPart>> meshes =
        swarm_.empty() ? foliage(posed) : swarm_parts(maker_, b_.look, posed, swarm_, most);
    for (std::size_t key = 0; key < keys_.size(); ++key) {
      auto others = foliage(posed_organs(b_.model, b_.motion, keys_[key], options_.keys[key], pose_.front));
      for (auto& [name, parts] : meshes)
        for (std::size_t k = 0; k < parts.size(); ++k)
          parts[k].shifts.push_back(shift_between(parts[k].surface, others[name][k].surface));
    }
    now_leaves_ = 0;
    for (auto& [name, parts] : meshes) {
      now_leaves_ += triangles_of(parts);
      add_in_place(name, std::move(parts));
    }
    if (maker_.level == 0) leaves_ = now_leaves_;
  }

  /// One mesh for each colour of a prototype that is there, placed as often as it occurs.
  void add_instances() {
    std::map<std::pair<std::size_t, std::size_t>, std::optional<std::size_t>> meshes;
    for (const OrganGroup& group : drawn_.organs.groups) {
      const Prototype& prototype = b_.model.prototypes[group.prototype];
      auto [at, fresh] = meshes.try_emplace({group.prototype, group.color});
      if (fresh) {
        std::vector<ExportPart> parts;
        std::string name = plain_name(prototype.name, "organ");
        for (std::size_t part = 0; part < prototype.parts.size(); ++part)
          if (const Surface& surface = prototype.parts[part].surface; !surface.triangle.empty())
            parts.push_back({surface, maker_.palette.organ(
                                          b_.look, prototype, part, group.color,
                                          surface.uv.empty() ? Palette::Lies::nowhere : Palette::Lies::mesh,
                                          maker_.name() + '_' + name)});
        at->second = maker_.mesh(name, std::move(parts));
      }
      if (!at->second) continue;
      for (const OrganPlace& place : drawn_.organs.places(group))
        maker_.place(*at->second, place.at, glm::normalize(place.turn), place.scale);
    }
  }

  void add_bodies() {
    std::vector<Solids> keys;
    for (const Model& then : swarm_) keys.push_back(then.solids);
    bool grow = !drawn_.bodies.empty() && drawn_.bodies.back().now;  // those that grow come last
    for (std::size_t k = 0; grow && k < keys_.size(); ++k)
      keys.push_back(grown_to(b_.model.solids, keys_[k].front));
    maker_.add_bodies(b_.look, drawn_.bodies, keys);
  }

  void add_blades() {
    const BladeLook& look = b_.look.blades;
    std::vector<ExportPart> parts;
    for (std::size_t k = 0; b_.model.blades.size() > 0 && k < look.colors.size(); ++k) {
      auto posed = [&](const Pose& pose, float least) {
        return posed_blades(
            b_.model.skeleton, pose, b_.model.blades, b_.motion.growth.ripen,
            [&](std::size_t i) {
              return color_index(b_.model.blades.color[i], look.colors.size()) == k &&
                     unfolded(b_.model.blades.birth[i], pose_.front, b_.motion.growth.ripen) >=
                         kUnfoldedLeast;
            },
            least);
      };
      Surface surface = posed(pose_, kUnfoldedLeast);
      if (surface.triangle.empty()) continue;
      ExportPart part{std::move(surface), maker_.palette.blade(look, k, maker_.name() + "_blades")};
      for (const Pose& key : keys_) part.shifts.push_back(shift_between(part.surface, posed(key, 0)));
      if (maker_.level > 0) make_fewer(part.surface);
      parts.push_back(std::move(part));
    }
    add_in_place("blades", std::move(parts));
  }

  /// Fewer blades, of two triangles each, none of which is much larger than the first level's.
  void make_fewer(Surface& blades) {
    double most = maker_.share() * static_cast<double>(blades.triangle.size());
    Bounds box = bounds_of(blades.position);
    std::vector<LeafPart> parts{{0, 0, 0, false, {}}};
    parts[0].surface = fewer_leaves(blades, most, kLargerLeaves * longest_edge(blades));
    keep_in_box(parts, box);
    blades = std::move(parts[0].surface);
  }

  Maker& maker_;
  const ExportOptions& options_;
  const Specimen& b_;
  double time_;  // seconds
  DrawList drawn_;
  const Pose& pose_;
  std::vector<Pose> keys_;  // none of a swarm
  std::vector<Model> swarm_;
  double wood_ = 0, leaves_ = 0;            // triangles at the first level
  double now_leaves_ = 0;                   // and of leaves at this one
  std::map<std::size_t, LeafSize> most_{};  // that leaves of coarser levels may be large
};

/// What a swarm is at the keys but the last.
Result<std::vector<Model>> swarm_of(const Specimen& b, const Specimen& now, const std::vector<double>& keys) {
  std::vector<Model> swarm;
  for (std::size_t k = 0; k + 1 < keys.size(); ++k) {
    auto then = developed(b, keys[k]);
    if (!then) return then.errors();
    if (!is_same_swarm(now.model, (*then)->model))
      return error_at("",
                      "{} changes its shape with its seasons, its years or the steps of its grammar, which "
                      "one mesh cannot follow: export single frames, with --frame",
                      b.name);
    swarm.push_back((*then)->model);
  }
  return swarm;
}

}  // namespace

double detail_seen(double pixels) {
  double grain = kTreeHeight / pixels;
  const CopyDetail* last = kLevels + kLevelCount - 1;
  if (grain <= kLevels->grain) return kLevels->leaves / (1 - kWoodShare);
  // Beyond the coarsest as many as there are pixels along it.
  if (grain >= last->grain) return last->leaves * last->grain / grain / (1 - kWoodShare);
  const CopyDetail* level = kLevels + level_for(grain);
  double share = std::log(grain / level[0].grain) / std::log(level[1].grain / level[0].grain);
  return level[0].leaves * std::pow(level[1].leaves / level[0].leaves, share) / (1 - kWoodShare);
}

Result<ExportScene> export_scene(const Scene& scene, double time, const ExportOptions& options) {
  ExportScene exported;
  ExportOptions own = options;
  if (!own.keys.empty() || own.instances) own.levels = 1;  // only one mesh moves, or is placed many times
  Maker maker{exported, own};
  for (const Specimen& b : scene.specimens) {
    std::size_t before = exported.placements.size();
    auto now = developed(b, time);
    if (!now) return now.errors();
    Result<std::vector<Model>> swarm = std::vector<Model>{};
    if (b.life.reshapes()) swarm = swarm_of(b, **now, options.keys);
    if (!swarm) return swarm.errors();
    if (Errors errors = SceneExporter(maker, **now, time, std::move(*swarm)).add(); !errors.empty())
      return errors;
    std::string name = b.name.empty() ? fmt::format("organism {}", b.entry) : b.name;
    if (exported.placements.size() == before && b.entry != Specimen::kNoEntry &&
        std::ranges::find(exported.absent, name) == exported.absent.end())
      exported.absent.push_back(name);
  }
  if (Errors errors = add_sown(maker, scene, time); !errors.empty()) return errors;
  // What has not begun to grow becomes an empty file, so that a series of frames has one for each.
  if (exported.placements.empty() && exported.absent.empty())
    return Error{"", "nothing grows or stands at that frame: there is nothing to write"};
  if (!options.keys.empty() && std::ranges::none_of(exported.meshes, &ExportMesh::moves))
    return Error{"", "nothing moves from the first of those frames to the last"};
  if (Errors errors = maker.palette.make_pictures(); !errors.empty()) return errors;
  if (Errors errors = add_crossed_levels(maker); !errors.empty()) return errors;
  for (double time_of : options.keys) exported.keys.push_back(time_of - options.keys[0]);
  return exported;
}

Surface placed(const ExportPart& part, const ExportPlacement& placement) {
  Surface surface;
  append_placed(surface, part.surface, placement.at, placement.turn, placement.scale);
  return surface;
}

}  // namespace frond
