#include "export/bodies.h"

#include <algorithm>
#include <cmath>

#include "core/linear.h"
#include "core/noise.h"
#include "export/box_map.h"
#include "export/carry.h"
#include "export/materials.h"

namespace frond {

namespace {

constexpr double kBodyShare = 0.5;  // of an organism's triangles: what the bodies that it is may take

/// With about so large a share of its triangles, all where that is more than all.
Simplified laid_out(const Surface& body, double share) {
  Simplified fewer = drawn_with(body, share * static_cast<double>(body.triangle.size()));
  std::vector<std::uint32_t> corner;
  Simplified laid{box_mapped(fewer.surface, &corner), {}};
  for (std::uint32_t v : corner) laid.source.push_back(fewer.source[v]);
  return laid;
}

Simplified as_turned(const Surface& vessel) {
  Simplified whole = drawn_with(vessel, kAllTriangles);
  whole.surface.uv = on_vessel(std::move(whole.surface.uv));
  return whole;
}

/// Turned about its axis, with places on what is painted on it.
bool is_vessel(const Solid& solid) {
  return !solid.surface.uv.empty() && row_of(solid.material.matter).nature == Nature::vessel;
}

/// Laid out on its picture by itself.
bool is_laid(const Solid& solid) { return is_vessel(solid) || !solid.material.picture.empty(); }

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
             !is_laid(solid);
    };
    while (at < kinds.kin.size() && !alike(kinds.kin[at].material)) ++at;
    if (at == kinds.kin.size()) kinds.kin.push_back({m, Vec3(0)});
    kinds.kin[at].light = glm::max(kinds.kin[at].light, linear(m.color));
    kinds.of.push_back(at);
  }
  for (Kin& kin : kinds.kin) kin.material.color = srgb(kin.light);
  return kinds;
}

/// How much moss is on a place that faces so: a factor of the colour.
Vec3 mossy(const Material& m, Vec3 at, Vec3 normal, Vec3 light) {
  if (m.moss <= 0 || !is_rock(m.matter)) return Vec3(1);
  auto scale = static_cast<float>(1 / (2.4 * std::max(m.scale, 0.05)));
  double cover = 0.5 * normal.y + 0.25 + 0.22 * fractal_noise(at * scale, 3);
  double grown = smooth_step(0.80 - 0.45 * m.moss, 0.95 - 0.45 * m.moss, cover);
  Vec3 green = Vec3(0.10f, 0.14f, 0.03f) / glm::max(light, Vec3(0.05f));
  return glm::mix(Vec3(1), glm::min(green, Vec3(1)), static_cast<float>(grown));
}

/// What is in the valleys of a brain coral is of the second colour: a factor.
Vec3 wrought(const Material& m, float height, Vec3 light) {
  Vec3 valley = linear(m.second) / glm::max(light, Vec3(1e-4f));
  return glm::mix(glm::min(valley, Vec3(1)), Vec3(1), smooth_step(0.2f, 0.7f, height));
}

}  // namespace

std::vector<ExportPart> body_parts(Maker& maker, const Look& look, const Solids& solids,
                                   std::span<const Solids> keys) {
  Kinds kinds = kinds_of(solids);
  std::vector<ExportPart> parts(kinds.kin.size());
  double all = 0;
  for (std::uint16_t s : solids.shape) all += static_cast<double>(solids.shapes[s].surface.triangle.size());
  double share = maker.share() * std::min(1.0, kBodyShare * maker.options.detail / std::max(all, 1.0));
  std::vector<Simplified> laid;
  for (const Solid& solid : solids.shapes)
    laid.push_back(is_vessel(solid) ? as_turned(solid.surface)
                   : is_laid(solid)
                       ? drawn_with(solid.surface, share * static_cast<double>(solid.surface.triangle.size()))
                       : laid_out(solid.surface, share));
  std::vector<bool> used(kinds.kin.size(), false);
  for (std::uint16_t s : solids.shape) used[kinds.of[s]] = true;
  std::vector<Palette::Use> uses;
  for (std::size_t k = 0; k < kinds.kin.size(); ++k) {
    auto first = static_cast<std::size_t>(std::find(kinds.of.begin(), kinds.of.end(), k) - kinds.of.begin());
    const Solid& solid = solids.shapes[first];
    uses.push_back(used[k] ? maker.palette.body(look, kinds.kin[k].material,
                                                is_vessel(solid) ? &solid : nullptr, maker.name() + "_body")
                           : Palette::Use{});
    parts[k].material = uses[k].material;
  }
  for (std::size_t i = 0; i < solids.size(); ++i) {
    std::size_t s = solids.shape[i], k = kinds.of[s];
    const Surface& body = solids.shapes[s].surface;
    const Material& own = solids.shapes[s].material;
    Vec3 light = kinds.kin[k].light;
    Surface surface = laid[s].surface;
    Seed seed = Seed{33}.child(i);
    if (!is_laid(solids.shapes[s]))
      lay_picture(surface, uses[k].wide, uses[k].high,
                  solids.size() > 1 ? Vec2(seed.child(0).unit(), seed.child(1).unit()) : Vec2(0));
    std::size_t before = parts[k].surface.position.size();
    append_placed(parts[k].surface, surface, solids.position[i], solids.turn[i], solids.scale[i]);
    for (std::size_t key = 0; key < keys.size(); ++key)
      append_shift(parts[k], key, before, laid[s].of(keys[key].shapes[s].surface),
                   {0, solids.position[i], solids.turn[i], solids.scale[i]});
    Vec3 factor = linear(own.color) / glm::max(light, Vec3(1e-4f));
    bool valleys = own.matter == Matter::meander && !body.uv.empty();
    for (std::size_t v = 0; v < laid[s].source.size(); ++v) {
      std::size_t at = before + v;
      Vec3 tint = mossy(own, parts[k].surface.position[at], parts[k].surface.normal[at], linear(own.color));
      if (valleys) tint *= wrought(own, body.uv[laid[s].source[v]].x, linear(own.color));
      const std::vector<float>& left = solids.shapes[s].light;
      if (!left.empty()) tint *= starved(left[laid[s].source[v]], linear(own.color));
      parts[k].tint.push_back(tint_of(factor * tint));
    }
  }
  for (ExportPart& part : parts)
    if (std::ranges::all_of(part.tint, [](ExportTint t) { return t == ExportTint{255, 255, 255, 255}; }))
      part.tint.clear();
  return parts;
}

}  // namespace frond
