#include "export/cast.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "export/box_map.h"
#include "export/look.h"
#include "export/maker.h"
#include "export/sown.h"
#include "field/cubes.h"
#include "geometry/far.h"
#include "geometry/tubes.h"
#include "motion/unfold.h"

namespace frond {

namespace {

constexpr double kWoodShare = 0.4;                          // of an organism's triangles, at most
constexpr double kFirstGrain = 1.0 / 6000, kCoarser = 1.4;  // of its size, where branches are too many

/// The lowest place that it grows from, or the middle of what it stands on.
Vec3 foot_of(const Model& model) {
  Vec3 foot(0, std::numeric_limits<float>::max(), 0);
  for (std::size_t i = 0; i < model.skeleton.size(); ++i)
    if (model.skeleton.parent[i] == Skeleton::kRoot && model.skeleton.position[i].y < foot.y)
      foot = model.skeleton.position[i];
  if (model.skeleton.size() > 0) return foot;
  Vec3 low(std::numeric_limits<float>::max()), high = -low;
  auto hold = [&](Vec3 p) { low = glm::min(low, p), high = glm::max(high, p); };
  for (std::size_t i = 0; i < model.solids.size(); ++i)
    for (const Vec3& p : model.solids.shapes[model.solids.shape[i]].surface.position)
      hold(model.solids.position[i] + model.solids.turn[i] * (p * model.solids.scale[i]));
  for (const Vec3& p : model.organs.position) hold(p);
  for (const Vec3& p : model.blades.surface.position) hold(p);
  return low.x > high.x ? Vec3(0) : Vec3(0.5f * (low.x + high.x), low.y, 0.5f * (low.z + high.z));
}

/// The organs that are there, where a pose has them.
Model posed_organs(const Specimen& b, const Pose& pose) {
  Model posed;
  posed.prototypes = b.model.prototypes;
  const Organs& o = b.model.organs;
  for (std::size_t i = 0; i < o.size(); ++i) {
    float size = unfolded(o.birth[i], pose.front, unfold_time(b.motion));
    if (size < kUnfoldedLeast) continue;
    posed.organs.prototype.push_back(o.prototype[i]);
    posed.organs.position.push_back(organ_place(b.model.skeleton, pose, o, i));
    posed.organs.turn.push_back(glm::normalize(organ_turn(pose, o, i)));
    posed.organs.scale.push_back(o.scale[i] * size);
    posed.organs.color.push_back(o.color[i]);
    posed.organs.id.push_back(o.id[i]);
  }
  return posed;
}

/// The brightness of the cube that holds a place, in sides.
CastTint brightness_at(Vec3 at) {
  Vec3 cube = glm::floor(at + 0.5f);
  Seed seed = Seed{34};
  for (int axis = 0; axis < 3; ++axis)
    seed = seed.child(static_cast<std::uint64_t>(static_cast<std::int64_t>(cube[axis])));
  auto byte = static_cast<std::uint8_t>(185 + seed.unit() * 70);
  return {byte, byte, byte, 255};
}

/// Takes the meshes of one organism to a cast.
class Caster {
 public:
  Caster(Maker& maker, const Specimen& b, double time) : maker_(maker), options_(maker.options), b_(b) {
    pose_specimen(b, time, pose_);
    maker_.begin(plain_name(b.name, "organism"), foot_of(b.model));
  }

  Errors add() {
    if (b_.look.skin || b_.look.bark)
      if (Errors errors = add_branches(); !errors.empty()) return errors;
    add_organs();
    add_blades();
    maker_.add_bodies(b_.model.solids);
    return {};
  }

 private:
  Errors add_branches() {
    if (b_.style.build == Build::sweeps) {
      b_.look.coat ? add_coated() : add_tubes();
      return {};
    }
    Result<FusedMesh> mesh = body_mesh(b_, pose_);
    if (!mesh) return mesh.errors();
    if (b_.style.build == Build::voxels) return add_cubes(std::move(*mesh)), Errors{};
    std::vector<CastPart> parts = by_color(std::move(mesh->surface), mesh->node);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      Palette::Use use = branches(k);
      parts[k].surface = box_mapped(parts[k].surface);
      lay_picture(parts[k].surface, use.wide, use.high);
      parts[k].material = use.material;
    }
    maker_.stand("branches", std::move(parts));
    return {};
  }

  Palette::Use branches(std::size_t color) {
    std::string name = maker_.name() + "_branches";
    return maker_.palette.branches(b_.look, b_.brightness, color, name);
  }

  /// Branches with less in them until they have so few triangles; a skeleton that still grows stays as it is.
  template <class Mesh>
  auto fitting(const Mesh& mesh_of) {
    Skeleton posed = b_.model.skeleton;
    posed.position = pose_.position;
    posed.radius = pose_.radius;
    auto made = mesh_of(posed, 0.0f);
    bool colored = b_.look.bark && b_.look.bark->colors.size() > 1 && !b_.model.color.empty();
    if (pose_.front <= 1 || posed.size() < 2 || colored) return made;
    Vec3 low = posed.position[0], high = low;
    for (const Vec3& p : posed.position) low = glm::min(low, p), high = glm::max(high, p);
    float grain = static_cast<float>(kFirstGrain) * glm::distance(low, high);
    while (static_cast<double>(triangles(made)) > kWoodShare * options_.detail &&
           grain < 0.05f * glm::distance(low, high)) {
      made = mesh_of(thinned(posed, 0.4f * grain, 0.5f * grain), grain);
      grain *= static_cast<float>(kCoarser);
    }
    return made;
  }
  static std::size_t triangles(const Surface& s) { return s.triangle.size(); }
  static std::size_t triangles(const TubeMesh& m) { return m.surface.triangle.size(); }

  void add_coated() {
    const BarkCoat& coat = *b_.look.coat;
    TubeShape shape{.wrap = coat.wrap,
                    .aspect = coat.aspect,
                    .side = coat.facet,
                    .lobes = b_.look.lobes,
                    .lobe_depth = b_.look.lobe_depth};
    Surface wood = fitting([&](const Skeleton& posed, float grain) {
      if (grain == 0) {
        shape.girth = b_.model.girth;
        return tube_surface(b_.model.skeleton, pose_.position, pose_.radius, pose_.turn, shape);
      }
      shape.girth = {};
      shape.side = std::max(coat.facet, 4.0 * static_cast<double>(grain));
      return tube_surface(posed, shape);
    });
    std::vector<CastPart> parts(1);
    parts[0] = {std::move(wood), branches(0).material};
    maker_.stand("branches", std::move(parts));
  }

  void add_tubes() {
    int sides = options_.sides;
    TubeMesh tubes = fitting([&](const Skeleton& posed, float grain) {
      if (grain == 0)
        return wrapped(b_.model.skeleton, pose_.position, pose_.radius, pose_.front, options_.sides);
      sides = std::max(std::min(options_.sides, 5), sides - 1);
      return wrapped(posed, posed.position, posed.radius, 2, sides);
    });
    std::vector<CastPart> parts = by_color(std::move(tubes.surface), tubes.node);
    for (std::size_t k = 0; k < parts.size(); ++k)
      if (!parts[k].surface.triangle.empty()) parts[k].material = branches(k).material;
    maker_.stand("branches", std::move(parts));
  }

  /// Closed tubes, a picture going a whole number of times round each branch.
  TubeMesh wrapped(const Skeleton& rest, const std::vector<Vec3>& position, const std::vector<float>& radius,
                   float front, int sides) {
    TubeMesh mesh = closed_tubes(rest, position, radius, front, sides);
    auto [wide, high] = Palette::picture_size(b_.look);
    std::vector<float> wraps(rest.size(), 1);
    for (std::size_t i = 1; i < rest.size(); ++i) {
      bool goes_on =
          rest.parent[i] == static_cast<std::int32_t>(i) - 1 && rest.parent[i - 1] != Skeleton::kRoot;
      wraps[i] = goes_on ? wraps[i - 1]
                         : static_cast<float>(std::max(
                               1.0, std::round(2 * kPi * static_cast<double>(rest.radius[i]) / wide)));
    }
    for (std::size_t v = 0; v < mesh.node.size(); ++v) {
      Vec2& at = mesh.surface.uv[v];
      at = {at.x * wraps[static_cast<std::size_t>(mesh.node[v])], at.y / static_cast<float>(high)};
    }
    return mesh;
  }

  /// Branches of several colours are parted by the colour of each triangle's first vertex.
  std::vector<CastPart> by_color(Surface&& surface, const std::vector<std::int32_t>& node) {
    std::size_t colors = b_.look.bark ? b_.look.bark->colors.size() : 1;
    std::vector<CastPart> parts(colors);
    if (b_.model.color.empty() || colors == 1) {
      parts[0].surface = std::move(surface);
      return parts;
    }
    std::vector<std::vector<std::uint32_t>> index(
        colors, std::vector<std::uint32_t>(surface.position.size(), UINT32_MAX));
    for (const auto& t : surface.triangle) {
      std::size_t k = color_index(b_.model.color[static_cast<std::size_t>(node[t[0]])], colors);
      std::array<std::uint32_t, 3> corners{};
      for (std::size_t c = 0; c < 3; ++c) corners[c] = copied(surface, t[c], index[k], parts[k].surface);
      parts[k].surface.triangle.push_back(corners);
    }
    return parts;
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

  /// Each face of a cube shows a picture of a face; cubes differ a little in brightness.
  void add_cubes(FusedMesh&& mesh) {
    std::vector<CastPart> parts = by_color(std::move(mesh.surface), mesh.node);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      Surface& s = parts[k].surface;
      if (s.triangle.empty()) continue;
      double side = b_.style.voxel;
      s = box_mapped(s);
      lay_picture(s, side, side, Vec2(0.5f));
      parts[k].material =
          maker_.palette.cubes(b_.look, b_.brightness, k, maker_.name() + "_branches").material;
      for (std::size_t v = 0; v < s.position.size(); ++v) {
        // The middle of the cube tells its brightness: half a side below the face, less than that from a
        // corner.
        Vec3 at = s.position[v] / static_cast<float>(side) - 0.5f * s.normal[v];
        parts[k].tint.push_back(brightness_at(at));
      }
    }
    maker_.stand("branches", std::move(parts));
  }

  void add_organs() {
    if (b_.model.organs.size() == 0) return;
    Model posed = posed_organs(b_, pose_);
    if (options_.instances) return add_instances(posed);
    // What the branches have left.
    double left = options_.detail;
    if (b_.model.skeleton.size() > 1 && !maker_.cast.placements.empty() &&
        maker_.cast.placements.back().group + 1 == maker_.cast.groups.size())
      for (const CastPart& part : maker_.cast.meshes[maker_.cast.placements.back().mesh].parts)
        left -= static_cast<double>(part.surface.triangle.size());
    left = std::max(left, (1 - kWoodShare) * options_.detail);
    maker_.add_foliage(b_.look, posed, foliage_parts(b_.look, posed, left));
  }

  /// One mesh for each colour of a prototype that is there, placed as often as it occurs.
  void add_instances(const Model& posed) {
    std::map<std::pair<std::size_t, std::size_t>, std::optional<std::size_t>> meshes;
    const Organs& o = posed.organs;
    for (std::size_t i = 0; i < o.size(); ++i) {
      const Prototype& prototype = posed.prototypes[o.prototype[i]];
      std::size_t color = color_index(o.color[i], prototype.colors.size());
      auto [at, fresh] = meshes.try_emplace({o.prototype[i], color});
      if (fresh) {
        std::vector<CastPart> parts;
        std::string name = plain_name(prototype.name, "organ");
        for (std::size_t part = 0; part < prototype.parts.size(); ++part)
          if (const Surface& surface = prototype.parts[part].surface; !surface.triangle.empty())
            parts.push_back({surface, maker_.palette.organ(
                                          b_.look, prototype, part, color,
                                          surface.uv.empty() ? Palette::Lies::nowhere : Palette::Lies::mesh,
                                          maker_.name() + '_' + name)});
        at->second = maker_.mesh(name, std::move(parts));
      }
      if (at->second) maker_.place(*at->second, o.position[i], o.turn[i], o.scale[i]);
    }
  }

  void add_blades() {
    const BladeLook& look = b_.look.blades;
    std::vector<CastPart> parts;
    for (std::size_t k = 0; b_.model.blades.size() > 0 && k < look.colors.size(); ++k) {
      Surface surface = posed_blades(
          b_.model.skeleton, pose_, b_.model.blades, b_.motion.growth.ripen,
          [&](std::size_t i) { return color_index(b_.model.blades.color[i], look.colors.size()) == k; });
      if (surface.triangle.empty()) continue;
      parts.push_back({std::move(surface), maker_.palette.blade(look, k, maker_.name() + "_blades")});
    }
    maker_.stand("blades", std::move(parts));
  }

  Maker& maker_;
  const CastOptions& options_;
  const Specimen& b_;
  Pose pose_;
};

}  // namespace

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
  Maker maker{cast, options};
  for (const Specimen& b : scene.specimens) {
    Errors errors;
    if (b.life.changes()) {
      Result<Specimen> now = developed(b, time);
      errors = now ? Caster(maker, *now, time).add() : now.errors();
    } else {
      errors = Caster(maker, b, time).add();
    }
    if (!errors.empty()) return errors;
  }
  if (Errors errors = add_sown(maker, scene); !errors.empty()) return errors;
  if (cast.placements.empty())
    return Error{"", "nothing grows or stands at that frame: there is nothing to write"};
  return cast;
}

Surface placed(const CastPart& part, const CastPlacement& placement) {
  Surface surface;
  append_placed(surface, part.surface, placement.at, placement.turn, placement.scale);
  return surface;
}

}  // namespace frond
