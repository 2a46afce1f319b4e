#include "export/maker.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/linear.h"
#include "core/noise.h"
#include "export/box_map.h"
#include "export/look.h"
#include "export/pattern.h"
#include "geometry/far.h"

namespace frond {

namespace {

constexpr double kNear = 0.85;  // a share that is no less is as good as all

/// About so large a share of a part's triangles.
void make_coarser(CastPart& part, double share) {
  std::vector<std::uint32_t> kept;
  auto goal = static_cast<std::size_t>(share * static_cast<double>(part.surface.triangle.size()));
  part.surface = reduced(part.surface, goal, &kept);
  std::vector<CastTint> tint;
  for (std::size_t v = 0; !part.tint.empty() && v < part.surface.position.size(); ++v)
    tint.push_back(part.tint[kept.empty() ? v : kept[v]]);
  part.tint = std::move(tint);
}

double sum(const std::vector<CastPart>& parts, const auto& counted) {
  double triangles = 0;
  for (const CastPart& p : parts)
    if (counted(p)) triangles += static_cast<double>(p.surface.triangle.size());
  return triangles;
}

}  // namespace

double triangles_of(const std::vector<CastPart>& parts) {
  return sum(parts, [](const CastPart&) { return true; });
}

double solid_triangles(const Cast& cast, const std::vector<CastPart>& parts) {
  return sum(parts, [&](const CastPart& p) { return !cast.materials[p.material].leaf; });
}

CastTint tint_of(Vec3 light) {
  auto part = [](float x) { return static_cast<std::uint8_t>(std::lround(std::clamp(x, 0.0f, 1.0f) * 255)); };
  return {part(light.x), part(light.y), part(light.z), 255};
}

std::optional<std::size_t> Maker::mesh(const std::string& part, std::vector<CastPart> parts) {
  std::erase_if(parts, [](const CastPart& p) { return p.surface.triangle.empty(); });
  if (parts.empty()) return {};
  if (level == 0) {
    begun[part] = cast.meshes.size();
    cast.meshes.push_back({mesh_names.unique(name() + '_' + part), std::move(parts)});
    return cast.meshes.size() - 1;
  }
  auto of = begun.find(part);
  if (of == begun.end()) return {};
  CastMesh& mesh = cast.meshes[of->second];
  double factor = share() * solid_triangles(cast, mesh.parts) / std::max(1.0, solid_triangles(cast, parts));
  for (CastPart& p : parts)
    if (factor < kNear && !cast.materials[p.material].leaf) make_coarser(p, factor);
  mesh.coarser.push_back(std::move(parts));
  return {};
}

void Maker::stand(const std::string& part, std::vector<CastPart> parts) {
  for (CastPart& p : parts)
    for (Vec3& at : p.surface.position) at -= foot();
  if (auto made = mesh(part, std::move(parts))) place(*made, foot(), Quat(1, 0, 0, 0), Vec3(1));
}

std::map<std::string, std::vector<CastPart>> by_name(Maker& maker, const Look& look, const Model& model,
                                                     std::vector<LeafPart> parts) {
  std::map<std::string, std::vector<CastPart>> meshes;
  for (LeafPart& leaf : parts) {
    const Prototype& prototype = model.prototypes[leaf.prototype];
    std::string name = plain_name(prototype.name, "organ");
    auto lies = leaf.surface.uv.empty() ? Palette::Lies::nowhere
                : leaf.card             ? Palette::Lies::card
                                        : Palette::Lies::mesh;
    std::size_t material =
        maker.palette.organ(look, prototype, leaf.part, leaf.color, lies, maker.name() + '_' + name);
    std::vector<CastPart>& made = meshes[name];
    auto same = std::ranges::find(made, material, &CastPart::material);
    if (same == made.end())
      made.push_back({std::move(leaf.surface), material});
    else
      append(same->surface, leaf.surface);
  }
  return meshes;
}

namespace {

constexpr double kBodyShare = 0.5;  // of an organism's triangles: what the bodies that it is may take

/// About so large a share of a body's triangles, all where that is more than all.
Surface simpler(const Surface& surface, double share) {
  if (share >= 1) return surface;
  return reduced(surface, static_cast<std::size_t>(share * static_cast<double>(surface.triangle.size())));
}

bool is_stone(Matter m) {
  return m == Matter::granite || m == Matter::karst || m == Matter::basalt || m == Matter::ashlar ||
         m == Matter::bed || m == Matter::reef;
}

/// Turned about its axis, with places on what is painted on it.
bool is_vessel(const Solid& solid) {
  Matter m = solid.material.matter;
  return !solid.surface.uv.empty() && (m == Matter::ceramic || m == Matter::terracotta || m == Matter::glass);
}

/// Bodies that differ in little but their colour share a material of the brightest of these.
struct Kin {
  Material material;
  Vec3 light{0};  // the brightest, channel by channel
};

struct Kinds {
  std::vector<Kin> kin;
  std::vector<std::size_t> of;  // of each shape
};

Kinds kinds_of(const Solids& solids) {
  Kinds kinds;
  for (const Solid& solid : solids.shapes) {
    const Material& m = solid.material;
    std::size_t at = 0;
    auto near = [](double a, double b) {
      return std::abs(a - b) <= 0.25 * std::max(std::abs(a), std::abs(b));
    };
    auto alike = [&](const Material& o) {
      return m.matter == o.matter && near(m.scale, o.scale) && near(m.relief, o.relief) &&
             near(m.moss, o.moss) && near(m.gloss, o.gloss) && m.bands.empty() && o.bands.empty() &&
             !is_vessel(solid);
    };
    while (at < kinds.kin.size() && !alike(kinds.kin[at].material)) ++at;
    if (at == kinds.kin.size()) kinds.kin.push_back({m, Vec3(0)});
    kinds.kin[at].light = glm::max(kinds.kin[at].light, linear(m.color));
    kinds.of.push_back(at);
  }
  for (Kin& kin : kinds.kin)
    kin.material.color = {static_cast<float>(encoded(kin.light.x)), static_cast<float>(encoded(kin.light.y)),
                          static_cast<float>(encoded(kin.light.z))};
  return kinds;
}

/// How much moss is on a place that faces so: a factor of the colour.
Vec3 mossy(const Material& m, Vec3 at, Vec3 normal, Vec3 light) {
  if (m.moss <= 0 || !is_stone(m.matter)) return Vec3(1);
  auto scale = static_cast<float>(1 / (2.4 * std::max(m.scale, 0.05)));
  double cover = 0.5 * normal.y + 0.25 + 0.22 * fractal_noise(at * scale, 3);
  double grown = smooth_step(0.80 - 0.45 * m.moss, 0.95 - 0.45 * m.moss, cover);
  Vec3 green = Vec3(0.10f, 0.14f, 0.03f) / glm::max(light, Vec3(0.05f));
  return glm::mix(Vec3(1), glm::min(green, Vec3(1)), static_cast<float>(grown));
}

}  // namespace

std::vector<CastPart> body_parts(Maker& maker, const Solids& solids) {
  Kinds kinds = kinds_of(solids);
  std::vector<CastPart> parts(kinds.kin.size());
  std::vector<Palette::Use> uses;
  std::vector<Surface> laid;
  double all = 0;
  for (std::uint16_t s : solids.shape) all += static_cast<double>(solids.shapes[s].surface.triangle.size());
  double share = maker.share() * std::min(1.0, kBodyShare * maker.options.detail / std::max(all, 1.0));
  for (std::size_t s = 0; s < solids.shapes.size(); ++s) {
    const Solid& solid = solids.shapes[s];
    laid.push_back(is_vessel(solid) ? solid.surface : box_mapped(simpler(solid.surface, share)));
    if (is_vessel(solid))
      for (Vec2& at : laid.back().uv) at.y = on_vessel(at.y);
  }
  std::vector<bool> used(kinds.kin.size(), false);
  for (std::uint16_t s : solids.shape) used[kinds.of[s]] = true;
  for (std::size_t k = 0; k < kinds.kin.size(); ++k) {
    auto first = static_cast<std::size_t>(std::find(kinds.of.begin(), kinds.of.end(), k) - kinds.of.begin());
    uses.push_back(used[k] ? maker.palette.body(kinds.kin[k].material, is_vessel(solids.shapes[first]),
                                                maker.name() + "_body")
                           : Palette::Use{});
    parts[k].material = uses[k].material;
  }
  for (std::size_t i = 0; i < solids.size(); ++i) {
    std::size_t s = solids.shape[i], k = kinds.of[s];
    const Material& own = solids.shapes[s].material;
    const Kin& kin = kinds.kin[k];
    Surface surface = laid[s];
    Seed seed = Seed{33}.child(i);
    if (!is_vessel(solids.shapes[s]))
      lay_picture(surface, uses[k].wide, uses[k].high,
                  solids.size() > 1 ? Vec2(seed.child(0).unit(), seed.child(1).unit()) : Vec2(0));
    std::size_t before = parts[k].surface.position.size();
    append_placed(parts[k].surface, surface, solids.position[i], solids.turn[i], solids.scale[i]);
    Vec3 factor = linear(own.color) / glm::max(kin.light, Vec3(1e-4f));
    for (std::size_t v = before; v < parts[k].surface.position.size(); ++v)
      parts[k].tint.push_back(tint_of(
          factor * mossy(own, parts[k].surface.position[v], parts[k].surface.normal[v], linear(own.color))));
  }
  for (CastPart& part : parts)
    if (std::all_of(part.tint.begin(), part.tint.end(), [](CastTint t) {
          return t == CastTint{255, 255, 255, 255};
        }))
      part.tint.clear();
  return parts;
}

void Maker::add_bodies(const Solids& solids) {
  if (solids.size() == 0) return;
  if (!options.instances) return stand("body", body_parts(*this, solids));
  for (std::size_t s = 0; s < solids.shapes.size(); ++s) {
    Solids one;
    one.add_shape(solids.shapes[s]);
    one.place(0);
    if (std::find(solids.shape.begin(), solids.shape.end(), s) == solids.shape.end()) continue;
    auto made = mesh(fmt::format("body_{}", s), body_parts(*this, one));
    for (std::size_t i = 0; made && i < solids.size(); ++i)
      if (solids.shape[i] == s) place(*made, solids.position[i], solids.turn[i], solids.scale[i]);
  }
}

}  // namespace frond
