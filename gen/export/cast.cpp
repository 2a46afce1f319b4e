#include "export/cast.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "export/look.h"
#include "export/sown.h"
#include "field/cubes.h"
#include "geometry/tubes.h"
#include "motion/unfold.h"

namespace frond {

namespace {

/// Takes the meshes of one organism to a cast.
class Caster {
 public:
  Caster(Cast& cast, const Specimen& b, std::size_t index, double time, const CastOptions& options)
      : cast_(cast), b_(b), options_(options) {
    name_ = fmt::format("{}_{}", plain_name(b.name, "organism"), index);
    pose_specimen(b, time, pose_);
  }

  Errors add() {
    if (b_.look.skin || b_.look.bark)
      if (Errors errors = add_branches(); !errors.empty()) return errors;
    add_organs();
    add_blades();
    add_solids();
    return {};
  }

 private:
  std::size_t material(std::string name, Color color, double gloss, bool leaf) {
    cast_.materials.push_back({name_ + '_' + name, color, gloss, false, leaf});
    return cast_.materials.size() - 1;
  }

  void stand(std::string name, Surface&& surface, std::size_t made_of) {
    if (surface.triangle.empty()) return;
    cast_.placements.push_back({cast_.meshes.size()});
    cast_.meshes.push_back({name_ + '_' + name, std::move(surface), made_of});
  }

  Errors add_branches() {
    if (b_.style.build == Build::sweeps) {
      TubeMesh tubes =
          closed_tubes(b_.model.skeleton, pose_.position, pose_.radius, pose_.front, options_.sides);
      add_by_color(std::move(tubes.surface), tubes.node);
      return {};
    }
    Result<FusedMesh> mesh = body_mesh(b_, pose_);
    if (!mesh) return mesh.errors();
    add_by_color(std::move(mesh->surface), mesh->node);
    return {};
  }

  /// Specimen of several colours are parted by the colour of each triangle's first vertex.
  void add_by_color(Surface&& surface, const std::vector<std::int32_t>& node) {
    if (!b_.look.bark)
      return stand("branches", std::move(surface),
                   material("skin", tinted(b_.look.skin->tint, b_.brightness), 0.1, false));
    const Bark& bark = *b_.look.bark;
    auto bark_material = [&](std::size_t k) {
      std::size_t made_of =
          material(fmt::format("bark_{}", k), scaled(bark.colors[k], b_.brightness), bark_gloss(bark), false);
      cast_.materials[made_of].metal = is_metal(bark);
      return made_of;
    };
    if (b_.model.color.empty() || bark.colors.size() == 1)
      return stand("branches", std::move(surface), bark_material(0));
    for (std::size_t k = 0; k < bark.colors.size(); ++k) {
      Surface part;
      std::vector<std::uint32_t> index(surface.position.size(), UINT32_MAX);
      for (const auto& t : surface.triangle) {
        if (color_index(b_.model.color[static_cast<std::size_t>(node[t[0]])], bark.colors.size()) != k)
          continue;
        std::array<std::uint32_t, 3> corners{};
        for (std::size_t c = 0; c < 3; ++c) corners[c] = copied(surface, t[c], index, part);
        part.triangle.push_back(corners);
      }
      if (!part.triangle.empty()) stand(fmt::format("branches_{}", k), std::move(part), bark_material(k));
    }
  }

  static std::uint32_t copied(const Surface& from, std::uint32_t v, std::vector<std::uint32_t>& index,
                              Surface& to) {
    if (index[v] == UINT32_MAX) {
      index[v] = static_cast<std::uint32_t>(to.position.size());
      to.position.push_back(from.position[v]);
      to.normal.push_back(from.normal[v]);
      if (!from.uv.empty()) to.uv.push_back(from.uv[v]);
    }
    return index[v];
  }

  void add_organs() {
    // One mesh for each part and colour of a prototype that is there, placed as often as it occurs.
    std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>> meshes;
    for (std::size_t i = 0; i < b_.model.organs.size(); ++i) {
      float size = unfolded(b_.model.organs.birth[i], pose_.front, unfold_time(b_.motion));
      if (size < kUnfoldedLeast) continue;
      std::size_t which = b_.model.organs.prototype[i];
      const Prototype& prototype = b_.model.prototypes[which];
      std::size_t color = color_index(b_.model.organs.color[i], prototype.colors.size());
      auto [at, fresh] = meshes.try_emplace({which, color});
      if (fresh)
        for (std::size_t part = 0; part < prototype.parts.size(); ++part)
          if (!prototype.parts[part].surface.triangle.empty())
            at->second.push_back(organ_mesh(which, color, part));
      CastPlacement placement{0, organ_place(b_.model.skeleton, pose_, b_.model.organs, i),
                              glm::normalize(organ_turn(pose_, b_.model.organs, i)),
                              b_.model.organs.scale[i] * size};
      for (std::size_t mesh : at->second) placement.mesh = mesh, cast_.placements.push_back(placement);
    }
  }

  std::size_t organ_mesh(std::size_t which, std::size_t color, std::size_t part) {
    const Prototype& prototype = b_.model.prototypes[which];
    const OrganPart& shape = prototype.parts[part];
    Color paint = shape.tissue == Tissue::heart ? prototype.second : prototype.colors[color];
    std::string name = fmt::format("{}_{}_{}_{}", plain_name(prototype.name, "organ"), which, color, part);
    cast_.meshes.push_back(
        {name_ + '_' + name, shape.surface, material(name, paint, 0.2, is_leaf(shape.tissue))});
    return cast_.meshes.size() - 1;
  }

  void add_blades() {
    const BladeLook& look = b_.look.blades;
    for (std::size_t k = 0; b_.model.blades.size() > 0 && k < look.colors.size(); ++k) {
      Surface surface = posed_blades(
          b_.model.skeleton, pose_, b_.model.blades, b_.motion.growth.ripen,
          [&](std::size_t i) { return color_index(b_.model.blades.color[i], look.colors.size()) == k; });
      if (surface.triangle.empty()) continue;
      std::string name = fmt::format("blades_{}", k);
      stand(name, std::move(surface), material(name, look.colors[k], 0.2, true));
    }
  }

  void add_solids() {
    std::vector<std::size_t> mesh(b_.model.solids.shapes.size(), SIZE_MAX);
    for (std::size_t s = 0; s < b_.model.solids.shapes.size(); ++s) {
      const Solid& solid = b_.model.solids.shapes[s];
      if (solid.surface.triangle.empty()) continue;
      std::string name = fmt::format("solid_{}", s);
      mesh[s] = cast_.meshes.size();
      cast_.meshes.push_back({name_ + '_' + name, solid.surface,
                              material(name, solid.material.color, solid.material.gloss, false)});
    }
    for (std::size_t i = 0; i < b_.model.solids.size(); ++i)
      if (mesh[b_.model.solids.shape[i]] != SIZE_MAX)
        cast_.placements.push_back({mesh[b_.model.solids.shape[i]], b_.model.solids.position[i],
                                    b_.model.solids.turn[i], b_.model.solids.scale[i]});
  }

  Cast& cast_;
  const Specimen& b_;
  const CastOptions& options_;
  std::string name_;
  Pose pose_;
};

void count(CastSize& size, const Surface& surface, double times, bool fresh) {
  auto vertices = static_cast<double>(surface.position.size());
  auto triangles = static_cast<double>(surface.triangle.size());
  if (fresh) size.vertices += vertices, size.triangles += triangles;
  size.all_vertices += vertices * times, size.all_triangles += triangles * times;
}

/// Of the branches of one organism.
void count_branches(CastSize& size, const Specimen& b, const CastOptions& options) {
  double vertices = 0, triangles = 0;
  auto nodes = static_cast<double>(b.model.skeleton.size());
  if (b.style.build == Build::sweeps) {
    double ends = 0;
    for (std::size_t i = 1; i < b.model.skeleton.size(); ++i)
      ends += b.model.skeleton.parent[i] != static_cast<std::int32_t>(i) - 1;
    vertices = (nodes + 4 * ends) * (options.sides + 1);
    triangles = (nodes + 4 * ends) * options.sides * 2;
  } else {
    // A block that the surface passes has about a square of its side in it, and somewhat more aslant.
    double blocks = foresee_volume(boughs_of(b.model.skeleton, 0), b.style.voxel).blocks;
    vertices = blocks * 64, triangles = 2 * vertices;
  }
  size.vertices += vertices, size.triangles += triangles;
  size.all_vertices += vertices, size.all_triangles += triangles;
  size.placements += 1;
}

}  // namespace

CastSize size_of(const Cast& cast) {
  CastSize size;
  for (const CastMesh& mesh : cast.meshes) count(size, mesh.surface, 0, true);
  for (const CastPlacement& p : cast.placements) count(size, cast.meshes[p.mesh].surface, 1, false);
  size.placements = static_cast<double>(cast.placements.size());
  return size;
}

CastSize foresee_cast(const Scene& scene, const CastOptions& options) {
  CastSize size;
  for (const Specimen& b : scene.specimens) {
    if ((b.look.skin || b.look.bark) && b.model.skeleton.size() > 1) count_branches(size, b, options);
    std::vector<bool> seen(b.model.prototypes.size());
    for (std::uint16_t which : b.model.organs.prototype) {
      for (const OrganPart& part : b.model.prototypes[which].parts)
        count(size, part.surface, 1, !seen[which]);
      size.placements += static_cast<double>(b.model.prototypes[which].parts.size());
      seen[which] = true;
    }
    count(size, b.model.blades.surface, 1, true);
    for (const Solid& solid : b.model.solids.shapes) count(size, solid.surface, 0, true);
    for (std::uint16_t which : b.model.solids.shape)
      count(size, b.model.solids.shapes[which].surface, 1, false);
    size.placements += static_cast<double>(b.model.solids.size()) + 1;
  }
  return size;
}

Result<FusedMesh> body_mesh(const Specimen& specimen, const Pose& pose) {
  const Style& style = specimen.style;
  Boughs boughs;
  add_boughs(boughs, specimen.model.skeleton, pose.position, pose.radius, pose.front,
             static_cast<float>(style.blend));
  VolumeOptions volume{style.voxel, style.adaptivity, style.limit};
  if (style.build == Build::fused) return fuse(boughs, volume);
  Result<Cubes> cubes = cubes_of(boughs, volume);
  if (!cubes) return cubes.errors();
  FusedMesh mesh;
  std::vector<std::uint32_t> cube;
  mesh.surface = cubes_surface(*cubes, cube);
  // Each face has four corners of its own.
  for (std::uint32_t c : cube) mesh.node.insert(mesh.node.end(), 4, cubes->node[c]);
  return mesh;
}

Result<Cast> cast_scene(const Scene& scene, double time, const CastOptions& options) {
  Cast cast;
  for (std::size_t i = 0; i < scene.specimens.size(); ++i) {
    const Specimen& b = scene.specimens[i];
    Errors errors;
    if (b.life.changes()) {
      Result<Specimen> now = developed(b, time);
      errors = now ? Caster(cast, *now, i, time, options).add() : now.errors();
    } else {
      errors = Caster(cast, b, i, time, options).add();
    }
    if (!errors.empty()) return errors;
  }
  if (Errors errors = add_sown(cast, scene); !errors.empty()) return errors;
  if (cast.placements.empty())
    return Error{"", "nothing grows or stands at that frame: there is nothing to write"};
  return cast;
}

Surface placed(const CastMesh& mesh, const CastPlacement& placement) {
  Surface surface;
  append_placed(surface, mesh.surface, placement.at, placement.turn, placement.scale);
  return surface;
}

}  // namespace frond
