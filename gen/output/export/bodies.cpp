#include <algorithm>
#include <cmath>

#include "core/linear.h"
#include "core/noise.h"
#include "export/carry.h"
#include "export/parts.h"
#include "export/surfaces.h"

namespace frond {

namespace {

constexpr double kBodyShare = 0.5;  // of an organism's triangles: what the bodies that it is may take

/// With about so many triangles.
Simplified box_laid(const Surface& body, double triangles) {
  Simplified fewer = drawn_with(body, triangles);
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

/// Laid out on its picture by itself.
bool is_laid(const Solid& solid) { return is_vessel(solid) || !solid.material.picture.empty(); }

/// With about so large a share of its triangles, and places on its picture.
Simplified lay_out(const DrawnBody& body, double share) {
  double triangles = share * static_cast<double>(body.surface().triangle.size());
  if (is_vessel(*body.solid)) return as_turned(body.surface());
  return is_laid(*body.solid) ? drawn_with(body.surface(), triangles) : box_laid(body.surface(), triangles);
}

/// Bodies that differ in little but their colour share a material of the brightest of these.
struct Kin {
  Material material;
  const Solid* first;  // of them
  Vec3 light{0};       // the brightest, channel by channel
};

struct Kinds {
  std::vector<Kin> kin;
  std::vector<std::size_t> of;  // of each body
};

Kinds kinds_of(std::span<const DrawnBody> bodies) {
  Kinds kinds;
  for (const DrawnBody& body : bodies) {
    const Material& m = body.solid->material;
    std::size_t at = 0;
    auto near = [](double a, double b) {
      return std::abs(a - b) <= 0.25 * std::max(std::abs(a), std::abs(b));
    };
    auto alike = [&](const Material& o) {
      return m.matter == o.matter && near(m.scale, o.scale) && near(m.relief, o.relief) &&
             near(m.moss, o.moss) && near(m.gloss, o.gloss) && m.bands.empty() && o.bands.empty() &&
             !is_laid(*body.solid);
    };
    while (at < kinds.kin.size() && !alike(kinds.kin[at].material)) ++at;
    if (at == kinds.kin.size()) kinds.kin.push_back({m, body.solid});
    kinds.kin[at].light = glm::max(kinds.kin[at].light, linear(m.color));
    kinds.of.push_back(at);
  }
  for (Kin& kin : kinds.kin) kin.material.color = srgb(kin.light);
  return kinds;
}

/// How much moss is on a place that faces so: a factor of the colour.
Vec3 mossy(const Material& m, Vec3 at, Vec3 normal, Vec3 light) {
  double moss = m.moss * (m.moss_map ? m.moss_map->at(DVec3(at), DVec3(0), DVec3(0)) : 1);
  if (moss <= 0 || !is_rock(m.matter)) return Vec3(1);
  auto scale = static_cast<float>(1 / (2.4 * std::max(m.scale, 0.05)));
  double cover = 0.5 * normal.y + 0.25 + 0.22 * fractal_noise(at * scale, 3);
  double grown = smooth_step(0.80 - 0.45 * moss, 0.95 - 0.45 * moss, cover);
  Vec3 green = Vec3(0.10f, 0.14f, 0.03f) / glm::max(light, Vec3(0.05f));
  return glm::mix(Vec3(1), glm::min(green, Vec3(1)), static_cast<float>(grown));
}

/// What is in the valleys of a brain coral is of the second colour: a factor.
Vec3 wrought(const Material& m, float height, Vec3 light) {
  Vec3 valley = linear(m.second) / glm::max(light, Vec3(1e-4f));
  return glm::mix(glm::min(valley, Vec3(1)), Vec3(1), smooth_step(0.2f, 0.7f, height));
}

}  // namespace

std::vector<ExportPart> body_parts(Maker& maker, const Look& look, std::span<const DrawnBody> bodies,
                                   std::span<const Solids> keys) {
  double all = 0;
  std::size_t count = 0;
  for (const DrawnBody& body : bodies) {
    all += static_cast<double>(body.places.size() * body.surface().triangle.size());
    count += body.places.size();
  }
  double share = maker.share() * std::min(1.0, kBodyShare * maker.options.detail / std::max(all, 1.0));
  Kinds kinds = kinds_of(bodies);
  std::vector<ExportPart> parts;
  std::vector<Palette::Use> uses;
  for (const Kin& kin : kinds.kin) {
    const Solid* vessel = is_vessel(*kin.first) ? kin.first : nullptr;
    uses.push_back(maker.palette.body(look, kin.material, vessel, maker.name() + "_body"));
    parts.push_back({{}, uses.back().material});
  }
  std::uint64_t number = 0;
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    const DrawnBody& body = bodies[b];
    const Material& own = body.solid->material;
    const Palette::Use& use = uses[kinds.of[b]];
    ExportPart& part = parts[kinds.of[b]];
    Simplified laid = lay_out(body, share);
    Vec3 color = linear(own.color), factor = color / glm::max(kinds.kin[kinds.of[b]].light, Vec3(1e-4f));
    const std::vector<float>& left = body.solid->light;
    bool valleys = own.matter == Matter::meander && !body.surface().uv.empty();
    for (const OrganPlace& place : body.places) {
      Surface surface = laid.surface;
      Seed seed = Seed{33}.child(number++);
      if (!is_laid(*body.solid))
        lay_picture(surface, use.wide, use.high,
                    count > 1 ? Vec2(seed.child(0).unit(), seed.child(1).unit()) : Vec2(0));
      std::size_t before = part.surface.position.size();
      append_placed(part.surface, surface, place.at, place.turn, place.scale);
      for (std::size_t key = 0; key < keys.size(); ++key)
        append_shift(part, key, before, laid.of(keys[key].shapes[body.shape].surface),
                     {0, place.at, place.turn, place.scale});
      for (std::size_t v = 0; v < laid.source.size(); ++v) {
        Vec3 tint = mossy(own, part.surface.position[before + v], part.surface.normal[before + v], color);
        if (valleys) tint *= wrought(own, body.surface().uv[laid.source[v]].x, color);
        if (!left.empty()) tint *= starved(left[laid.source[v]], color);
        part.tint.push_back(tint_of(factor * tint));
      }
    }
  }
  for (ExportPart& part : parts)
    if (std::ranges::all_of(part.tint, [](ExportTint t) { return t == ExportTint{255, 255, 255, 255}; }))
      part.tint.clear();
  return parts;
}

}  // namespace frond
