#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/bounds.h"
#include "core/parallel.h"
#include "core/printable.h"
#include "export/parts.h"
#include "scene/copies.h"

namespace frond {

namespace {

constexpr double kGrains = 1000;     // along a model: what is finer is left out
constexpr double kLeafShare = 0.25;  // of the detail of one that stands alone: what a model's leaves may take

/// A model that has copies, and where they stand; sets of one species share theirs.
struct SownModel {
  const CopySet* copy_set = nullptr;
  int which = 0;
  std::vector<ExportPlacement> copies;  // of no mesh yet
};

std::vector<SownModel> models_of(const Scene& scene, double time) {
  std::vector<SownModel> models;
  std::map<std::string, std::size_t> index;  // by the model
  for (const CopySet& set : scene.copy_sets) {
    std::map<int, std::size_t> own;  // by its number in this set
    for (std::size_t i = 0; i < set.copies.size(); ++i) {
      if (!set.copies.there(i, time)) continue;
      int which = set.copies.model[i];
      auto [at, fresh] = own.try_emplace(which);
      if (fresh) {
        at->second = index.try_emplace(copy_id(set.organism, which), models.size()).first->second;
        if (at->second == models.size()) models.push_back({&set, which, {}});
      }
      models[at->second].copies.push_back(
          {0, set.copies.foot[i], glm::normalize(set.copies.turn_at(i, time)), set.copies.scale_at(i, time)});
    }
  }
  return models;
}

/// What visit(look, model) gives for each of the models, several at a time.
template <class Value, class Visit>
Result<std::vector<Value>> each_grown(const std::vector<SownModel>& models, const Visit& visit) {
  std::vector<Value> values(models.size());
  std::vector<Errors> errors(models.size());
  parallel_for(models.size(), [&](std::size_t i) {
    const CopySet& set = *models[i].copy_set;
    Result<Model> model = grow_copy(set.organism, models[i].which);
    if (model)
      values[i] = visit(set.appearance.look, *model);
    else
      errors[i] = model.errors();
  });
  for (const Errors& list : errors)
    if (!list.empty()) return list;
  return values;
}

/// Edge of the box round a model, metres.
double size_of(const Model& model) {
  Bounds box = bounds_of(model);
  return box.empty() ? 0.01 : std::max<double>(box.longest(), 0.01);
}

/// A model as it is drawn, its foliage aside.
struct SownShape {
  Model model;
  std::vector<CopyPart> parts;
  std::vector<LeafPart> foliage;
};

/// With so many grains along it.
SownShape shape_of(const Look& look, Model model, double grains, const FoliageDetail& detail) {
  SownShape made;
  double grain = size_of(model) / grains;
  made.foliage = foliage_parts(look, model, detail);
  model.organs = {};
  made.parts = copy_parts(look, model, {grain, detail.triangles});
  made.model.prototypes = std::move(model.prototypes);
  made.model.solids = std::move(model.solids);
  return made;
}

/// At each level of detail.
std::vector<SownShape> shapes_of(const Look& look, const Model& model, const ExportOptions& options) {
  bool seen = options.pixels > 0;
  double grains = seen ? options.pixels : kGrains;
  FoliageDetail detail{options.detail * (seen ? 1 : kLeafShare), options.texture > 0};
  std::vector<SownShape> levels;
  for (int level = 0; level < options.levels; ++level) {
    levels.push_back(shape_of(look, model, grains * std::pow(kCoarser, 0.5 * level), detail));
    if (level == 0) {
      detail.most = most_larger(levels[0].foliage);
      detail.triangles = 0;
      for (const LeafPart& part : levels[0].foliage)
        detail.triangles += static_cast<double>(part.surface.triangle.size());
    }
    detail.triangles *= kCoarser;
  }
  return levels;
}

/// All of one model as one mesh.
std::vector<ExportPart> parts_of(Maker& maker, const Look& look, SownShape& shape) {
  std::vector<ExportPart> parts;
  for (CopyPart& part : shape.parts) {
    if (part.kind == CopyPart::Kind::wood) {
      Look worn = look;
      if (!worn.branches.drawn()) worn.branches.bark = Bark{};
      std::size_t wood =
          maker.palette.branches(worn, 1, worn.branches.color_of(part.which), maker.name() + "_branches")
              .material;
      parts.push_back({std::move(part.surface), wood});
    } else if (part.kind == CopyPart::Kind::blade) {
      parts.push_back(
          {std::move(part.surface), maker.palette.blade(look.blades, 0, maker.name() + "_blades")});
    }
  }
  for (auto& [own, made] : by_name(maker, look, shape.model, std::move(shape.foliage)))
    std::move(made.begin(), made.end(), std::back_inserter(parts));
  for (ExportPart& body : body_parts(maker, look, still_bodies(shape.model.solids, {})))
    parts.push_back(std::move(body));
  return parts;
}

}  // namespace

Errors add_sown(Maker& maker, const Scene& scene, double time) {
  std::vector<SownModel> models = models_of(scene, time);
  auto shapes = each_grown<std::vector<SownShape>>(
      models, [&](const Look& look, Model& model) { return shapes_of(look, model, maker.options); });
  if (!shapes) return shapes.errors();
  for (std::size_t m = 0; m < models.size(); ++m) {
    const CopySet& set = *models[m].copy_set;
    if (m == 0 || &set != models[m - 1].copy_set)
      maker.begin(plain_name(set.organism.name, "organism"), Vec3(0), true);
    std::optional<std::size_t> mesh;
    maker.begun.clear();
    for (SownShape& shape : (*shapes)[m]) {
      if (maker.whole_is_crossed()) break;
      auto made = maker.mesh(std::to_string(models[m].which), parts_of(maker, set.appearance.look, shape));
      if (maker.level++ == 0) mesh = made;
    }
    maker.level = 0;
    for (const ExportPlacement& copy : models[m].copies)
      if (mesh) maker.place(*mesh, copy.at, copy.turn, copy.scale);
  }
  return {};
}

Result<std::vector<SownBranches>> sown_branches(const Scene& scene, double time) {
  std::vector<SownModel> models = models_of(scene, time);
  auto grown =
      each_grown<Skeleton>(models, [](const Look&, Model& model) { return std::move(model.skeleton); });
  if (!grown) return grown.errors();
  std::vector<SownBranches> branches;
  for (std::size_t m = 0; m < models.size(); ++m)
    if ((*grown)[m].size() > 1) branches.push_back({std::move((*grown)[m]), std::move(models[m].copies)});
  return branches;
}

}  // namespace frond
