#include "try/engine/lit_tree.h"

#include <algorithm>
#include <cmath>

#include "core/bounds.h"
#include "try/engine/answers.h"

namespace frond {

namespace {

constexpr int kMostNeedles = 16;    // of a sprig
constexpr float kDiamond = 1.3f;    // by which a leaf of two triangles is wider, to cover as much
constexpr double kFieldCells = 40;  // of a field of light along the tree

/// What casts shade, and how far it is in shade itself, for light that falls along one direction.
class OneLight {
 public:
  OneLight(const std::vector<Shade>& shades, const LightLaw& law, Vec3 from, float ground_half)
      : turn_(from, Vec3(0, 1, 0)), field_(law) {
    std::vector<Shade> turned = shades;
    for (Shade& shade : turned) shade.at = turn_ * shade.at;
    float floor = 0;
    for (float x : {-ground_half, ground_half})
      for (float z : {-ground_half, ground_half}) floor = std::min(floor, (turn_ * Vec3(x, 0, z)).y);
    field_.cast(turned, floor);
  }

  float at(Vec3 place) const { return std::exp(-field_.shadow(turn_ * place)); }

 private:
  Quat turn_;
  LightField field_;
};

/// Each leaf of a sprig, whose rows of three points run from u = 0 to u = 1, as two triangles.
Surface diamonds(const Surface& sprig) {
  Surface few;
  std::size_t foot = 0, widest = 0;
  for (std::size_t row = 0; row + 2 < sprig.position.size(); row += 3) {
    if (sprig.uv[row].x == 0) foot = widest = row;
    if (sprig.uv[row + 2].y > sprig.uv[widest + 2].y) widest = row;
    if (sprig.uv[row].x < 1) continue;
    auto base = static_cast<std::uint32_t>(few.position.size());
    Vec3 middle = sprig.position[widest + 1];
    for (Vec3 at : {sprig.position[foot + 1], middle + kDiamond * (sprig.position[widest] - middle),
                    middle + kDiamond * (sprig.position[widest + 2] - middle), sprig.position[row + 1]})
      few.position.push_back(at);
    few.triangle.push_back({base, base + 2, base + 3}), few.triangle.push_back({base, base + 3, base + 1});
  }
  set_normals(few);
  return few;
}

/// The corners of a surface, place and normal.
std::vector<float> corners_of(const Surface& surface) {
  std::vector<float> corners;
  for (const auto& triangle : surface.triangle)
    for (std::uint32_t corner : triangle) {
      put(corners, surface.position[corner]);
      put(corners, surface.normal[corner]);
    }
  return corners;
}

/// What is seen of an organ: its first part.
Surface shape_of(const Prototype& organ) {
  const OrganPart& part = organ.parts[0];
  bool drawn = organ.name == "sprig" && part.pictures.empty();
  return drawn ? diamonds(part.surface) : part.surface;
}

std::vector<Shade> shades_of_model(const Model& model, const std::vector<Surface>& shapes,
                                   const LightLaw& law) {
  std::vector<Shade> shades;
  std::vector<double> areas;
  for (const Surface& shape : shapes) areas.push_back(area(shape));
  const Organs& o = model.organs;
  for (std::size_t i = 0; i < o.size(); ++i)
    shades.push_back(
        {o.position[i], shade_amount(law, areas[o.prototype[i]] * o.scale[i].x * o.scale[i].x, 0)});
  const Skeleton& s = model.skeleton;
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (s.parent[i] == Skeleton::kRoot) continue;
    Vec3 below = s.position[static_cast<std::size_t>(s.parent[i])];
    double side = 2 * s.radius[i] * glm::distance(below, s.position[i]);
    shades.push_back({(below + s.position[i]) * 0.5f, shade_amount(law, 2 * side, 0)});
  }
  return shades;
}

/// The colour of a branch of that radius: bark on thick ones, the plain surface on twigs.
Color branch_color(const TreeParams& params, float radius) {
  const Color& twig = params.bark.colors[0];
  if (!params.coat) return twig;
  const BarkImage& bark = params.coat->image;
  auto thin = static_cast<float>(std::max(params.coat->twigs, 0.004));
  return mixed(twig, mixed(bark.color, bark.second, 0.25f), smooth_step(0.7f * thin, 2 * thin, radius));
}

}  // namespace

void make_few_triangles(Foliage& leaves) {
  SprigShape& sprig = leaves.sprig;
  if (sprig.kind == SprigKind::needles && sprig.leaves > kMostNeedles) {
    sprig.width *= static_cast<double>(sprig.leaves) / kMostNeedles;
    sprig.leaves = kMostNeedles;
  }
  if (leaves.picture) leaves.picture->detail = 3, leaves.picture->width *= kDiamond;
}

LitTree lit_tree(const Model& model, const TreeParams& params, Vec3 sun) {
  LitTree lit;
  std::vector<Surface> shapes;
  for (const Prototype& organ : model.prototypes) shapes.push_back(shape_of(organ));
  for (const Surface& shape : shapes) lit.shapes.push_back(corners_of(shape));
  Bounds bounds = bounds_of(model);
  float extent = std::max({bounds.high.y, bounds.high.x - bounds.low.x, bounds.high.z - bounds.low.z, 0.5f});
  LightLaw law;
  // A sprig hardly shades itself where a cell is as large.
  law.voxel = std::max(extent / kFieldCells, params.leaves.size);
  law.base = 1.005;
  std::vector<Shade> shades = shades_of_model(model, shapes, law);
  lit.ground_half = 1.5f * extent;
  OneLight direct(shades, law, sun, lit.ground_half), sky(shades, law, Vec3(0, 1, 0), lit.ground_half);
  auto put_light = [&](std::vector<float>& out, Vec3 at) {
    out.push_back(direct.at(at)), out.push_back(sky.at(at));
  };

  const Skeleton& s = model.skeleton;
  for (std::size_t i = 0; i < s.size(); ++i) {
    if (s.parent[i] == Skeleton::kRoot) continue;
    auto below = static_cast<std::size_t>(s.parent[i]);
    put(lit.segments, s.position[below]), lit.segments.push_back(s.radius[below]);
    put(lit.segments, s.position[i]), lit.segments.push_back(s.radius[i]);
    put_color(lit.segments, branch_color(params, s.radius[i]));
    put_light(lit.segments, s.position[i]);
  }
  lit.organs.resize(shapes.size());
  const Organs& o = model.organs;
  for (std::size_t i = 0; i < o.size(); ++i) {
    const Prototype& organ = model.prototypes[o.prototype[i]];
    std::vector<float>& out = lit.organs[o.prototype[i]];
    put(out, o.position[i]);
    put(out, {o.turn[i].x, o.turn[i].y, o.turn[i].z}), out.push_back(o.turn[i].w);
    out.push_back(o.scale[i].x);
    put_color(out, organ.colors[color_index(o.color[i], organ.colors.size())]);
    put_light(out, o.position[i]);
  }
  for (int row = 0; row < kGroundSide; ++row)
    for (int column = 0; column < kGroundSide; ++column) {
      auto along = [&](int k) {
        return lit.ground_half * (2.0f * static_cast<float>(k) / (kGroundSide - 1) - 1);
      };
      put_light(lit.ground, Vec3(along(column), 0, along(row)));
    }
  return lit;
}

}  // namespace frond
