#include "export/sown.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/parallel.h"
#include "export/look.h"
#include "scene/copies.h"

namespace frond {

namespace {

constexpr double kGrains = 1000;  // along a model: what is finer is left out
constexpr double kLeaves = 6e4;   // triangles of leaves of one model at most, about

/// A model that has copies, and where they stand; stands of one species share theirs.
struct SownModel {
  const SownStand* stand = nullptr;
  int which = 0;
  std::vector<CastPlacement> copies;  // of no mesh yet
};

std::vector<SownModel> models_of(const Scene& scene) {
  std::vector<SownModel> models;
  std::map<std::string, std::size_t> index;  // by the model
  for (const SownStand& stand : scene.stands) {
    std::map<int, std::size_t> own;  // by its number in this stand
    for (std::size_t i = 0; i < stand.copies.size(); ++i) {
      int which = stand.copies.model[i];
      auto [at, fresh] = own.try_emplace(which);
      if (fresh) {
        at->second = index.try_emplace(copy_id(stand.organism, which), models.size()).first->second;
        if (at->second == models.size()) models.push_back({&stand, which, {}});
      }
      models[at->second].copies.push_back(
          {0, stand.copies.foot[i], glm::normalize(stand.copies.turn[i]), Vec3(stand.copies.scale[i])});
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
    const SownStand& stand = *models[i].stand;
    Result<Model> model = grow_copy(stand.organism, models[i].which);
    if (model)
      values[i] = visit(stand.dress.look, *model);
    else
      errors[i] = model.errors();
  });
  for (const Errors& list : errors)
    if (!list.empty()) return list;
  return values;
}

/// Edge of the box round a model, metres.
double size_of(const Model& model) {
  Vec3 low(std::numeric_limits<float>::max()), high = -low;
  auto reach = [&](const std::vector<Vec3>& places) {
    for (const Vec3& p : places) low = glm::min(low, p), high = glm::max(high, p);
  };
  reach(model.skeleton.position);
  reach(model.organs.position);
  reach(model.blades.surface.position);
  for (std::size_t i = 0; i < model.solids.size(); ++i)
    for (const Vec3& p : model.solids.shapes[model.solids.shape[i]].surface.position)
      reach({model.solids.position[i] + model.solids.turn[i] * (p * model.solids.scale[i])});
  return std::max<double>({high.x - low.x, high.y - low.y, high.z - low.z, 0.01});
}

/// A mesh of a model, of one material, which has no name of its own yet.
struct SownMesh {
  std::string part;
  CastMaterial material;
  Surface surface;
};

CastMaterial wood_material(const Look& look) {
  if (look.bark) return {"", look.bark->colors[0], bark_gloss(*look.bark), is_metal(*look.bark), false};
  if (look.skin) return {"", tinted(look.skin->tint, 1), 0.1, false, false};
  return {"", Bark{}.colors[0], 0.1, false, false};
}

/// The colours and the tissue of the leaves that a part is made of.
std::pair<std::vector<Color>, Tissue> leaf_look(const Look& look, const Model& model, const CopyPart& part) {
  if (part.kind == CopyPart::Kind::blade) return {look.blades.colors, Tissue::leaf};
  const Prototype& prototype = model.prototypes[part.which];
  Tissue tissue = prototype.parts[part.part].tissue;
  if (tissue == Tissue::heart) return {{prototype.second}, tissue};
  return {prototype.colors, tissue};
}

/// The triangles of leaves of one colour, each leaf's `uv` on its own 0..1. What has none is of the first.
Surface of_color(const Surface& leaves, std::size_t color, std::size_t colors) {
  Surface out;
  if (leaves.uv.empty()) return color == 0 ? leaves : out;
  std::vector<std::uint32_t> index(leaves.position.size(), UINT32_MAX);
  for (const auto& t : leaves.triangle) {
    if (color_index(static_cast<std::int32_t>(std::floor(leaves.uv[t[0]].x)), colors) != color) continue;
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t c = 0; c < 3; ++c) {
      std::uint32_t& at = index[t[c]];
      if (at == UINT32_MAX) {
        at = static_cast<std::uint32_t>(out.position.size());
        out.position.push_back(leaves.position[t[c]]);
        out.normal.push_back(leaves.normal[t[c]]);
        out.uv.push_back({leaves.uv[t[c]].x - std::floor(leaves.uv[t[c]].x), leaves.uv[t[c]].y});
      }
      corners[c] = at;
    }
    out.triangle.push_back(corners);
  }
  return out;
}

std::vector<SownMesh> meshes_of(const Look& look, const Model& model) {
  std::vector<SownMesh> meshes;
  double grain = size_of(model) / kGrains;
  for (CopyPart& part : copy_parts(look, model, {grain, kLeaves})) {
    if (part.kind == CopyPart::Kind::wood) {
      meshes.push_back({"wood", wood_material(look), std::move(part.surface)});
    } else if (part.kind == CopyPart::Kind::solid) {
      const Material& m = model.solids.shapes[part.which].material;
      meshes.push_back({fmt::format("solid_{}", part.which),
                        {"", m.color, m.gloss, false, false},
                        std::move(part.surface)});
    } else {
      auto [colors, tissue] = leaf_look(look, model, part);
      for (std::size_t k = 0; k < colors.size(); ++k)
        if (Surface leaves = of_color(part.surface, k, colors.size()); !leaves.triangle.empty())
          meshes.push_back(
              {fmt::format("{}_{}_{}_{}", part.kind == CopyPart::Kind::blade ? "blades" : "organ", part.which,
                           part.part, k),
               {"", colors[k], 0.2, false, is_leaf(tissue)},
               std::move(leaves)});
    }
  }
  return meshes;
}

}  // namespace

Errors add_sown(Cast& cast, const Scene& scene) {
  std::vector<SownModel> models = models_of(scene);
  auto meshes = each_grown<std::vector<SownMesh>>(models, meshes_of);
  if (!meshes) return meshes.errors();
  for (std::size_t m = 0; m < models.size(); ++m)
    for (SownMesh& mesh : (*meshes)[m]) {
      // The number of the mesh tells it from those of other organisms of that name.
      mesh.material.name = fmt::format("{}_{}_{}_{}", plain_name(models[m].stand->organism.name, "organism"),
                                       models[m].which, mesh.part, cast.meshes.size());
      for (CastPlacement copy : models[m].copies) {
        copy.mesh = cast.meshes.size();
        cast.placements.push_back(copy);
      }
      cast.meshes.push_back({mesh.material.name, std::move(mesh.surface), cast.materials.size()});
      cast.materials.push_back(std::move(mesh.material));
    }
  return {};
}

Result<std::vector<SownBranches>> sown_branches(const Scene& scene) {
  std::vector<SownModel> models = models_of(scene);
  auto grown =
      each_grown<Skeleton>(models, [](const Look&, Model& model) { return std::move(model.skeleton); });
  if (!grown) return grown.errors();
  std::vector<SownBranches> branches;
  for (std::size_t m = 0; m < models.size(); ++m)
    if ((*grown)[m].size() > 1) branches.push_back({std::move((*grown)[m]), std::move(models[m].copies)});
  return branches;
}

}  // namespace frond
