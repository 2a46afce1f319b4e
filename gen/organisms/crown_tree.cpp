#include "organisms/crown_tree.h"

#include <algorithm>
#include <cmath>

#include "geometry/smooth.h"

namespace frond {

namespace {

/// The leaves in all seasons.
LeafLook look_of(const TreeDress& dress) {
  return dress.season ? with_seasons(dress.leaves, *dress.season) : dress.leaves;
}

/// Puts a leaf on each site.
void put_leaves(Model& model, const std::vector<LeafSite>& sites, const TreeDress& dress, Vec3 size,
                Seed seed) {
  if (sites.empty()) return;
  const LeafLook& look = dress.leaves;
  model.prototypes.push_back(leaf_prototype(look_of(dress)));
  if (look.sprig) model.prototypes[0].name = "sprig";
  if (dress.season) add_blossom(model.prototypes, *dress.season);
  Organs& o = model.organs;
  o.reserve(sites.size());
  for (std::size_t i = 0; i < sites.size(); ++i) {
    const LeafSite& site = sites[i];
    Seed own = seed.child(i);
    auto tilt = [&](std::uint64_t k, Vec3 axis) {
      return glm::angleAxis(static_cast<float>(look.turn_variation * own.child(k).range(-1, 1)), axis);
    };
    auto vary = static_cast<float>(1 + look.size_variation * own.child(3).range(-1, 1));
    o.prototype.push_back(0);
    o.position.push_back(site.position);
    o.turn.push_back(
        glm::normalize(site.turn * tilt(0, Vec3(1, 0, 0)) * tilt(1, Vec3(0, 1, 0)) * tilt(2, Vec3(0, 0, 1))));
    o.scale.push_back(glm::max(size * (site.size * vary), Vec3(1e-5f)));
    o.node.push_back(site.node);
    o.birth.push_back(model.skeleton.birth[site.node]);
    o.color.push_back(static_cast<std::int32_t>(own.child(4).bits() % look.colors.size()));
    o.id.push_back(static_cast<std::uint32_t>(i));
  }
}

/// Each node half-way to the middle of its neighbours, which takes the corners of growth out (Runions et
/// al.).
void relax(Skeleton& s) {
  std::vector<Vec3> moved = s.position;
  std::vector<std::int32_t> next(s.size(), -1);
  for (std::size_t i = 1; i < s.size(); ++i)
    if (s.parent[i] == static_cast<std::int32_t>(i) - 1) next[i - 1] = static_cast<std::int32_t>(i);
  for (std::size_t i = 1; i < s.size(); ++i) {
    std::int32_t p = s.parent[i];
    if (p == Skeleton::kRoot || next[i] < 0) continue;
    moved[i] = s.position[i] * 0.5f + (s.position[p] + s.position[next[i]]) * 0.25f;
  }
  s.position = std::move(moved);
}

/// Sets how deep each node is: along the branch that carries most it stays, elsewhere it is one deeper.
void set_orders(Skeleton& s) {
  std::vector<std::uint32_t> above(s.size(), 1);
  std::vector<std::int32_t> main(s.size(), -1);
  for (std::size_t i = s.size(); i-- > 1;) {
    auto p = static_cast<std::size_t>(s.parent[i]);
    above[p] += above[i];
    if (main[p] < 0 || above[i] >= above[static_cast<std::size_t>(main[p])])
      main[p] = static_cast<std::int32_t>(i);
  }
  for (std::size_t i = 1; i < s.size(); ++i) {
    auto p = static_cast<std::size_t>(s.parent[i]);
    int deeper = main[p] == static_cast<std::int32_t>(i) ? 0 : 1;
    s.order[i] = static_cast<std::uint16_t>(std::min(s.order[p] + deeper, 65535));
  }
}

void measure(Skeleton& s) {
  for (std::size_t i = 0; i < s.size(); ++i) {
    std::int32_t p = s.parent[i];
    s.distance[i] = p == Skeleton::kRoot ? 0 : s.distance[p] + glm::distance(s.position[p], s.position[i]);
  }
  set_tip_distances(s);
}

}  // namespace

Result<Model> grow_weber_penn_tree(const WeberPennParams& params, Seed seed) {
  Result<Crown> crown = grow_weber_penn(params.tree, seed.child("tree"));
  if (!crown) return crown.errors();
  Model model;
  model.skeleton = std::move(crown->skeleton);
  // What the stalk takes is not part of the blade, whose length LeafScale is.
  const WeberPenn& tree = params.tree;
  LeafLook look = params.dress.leaves;
  auto length = static_cast<float>(tree.leaf_scale * (1 + std::max(tree.leaf_stem_length, 0.0)));
  double share = 0;
  LeafImage image = leaf_image(look, 0);
  std::vector<Vec2> rim = leaf_rim(image.outline, 40);
  for (Vec2 p : rim) share = std::max<double>(share, 2 * p.x);
  // As wide as LeafScaleX asks, unless it is a sprig, which has its own shape.
  float wide =
      look.sprig ? length : static_cast<float>(tree.leaf_scale_x * tree.leaf_scale / std::max(share, 0.05));
  put_leaves(model, crown->leaves, params.dress, Vec3(wide, length, length), seed.child("leaf"));
  return model;
}

Result<Envelope> envelope_of(const EnvelopeParams& p) {
  auto base = static_cast<float>(p.base), height = static_cast<float>(p.height);
  Vec3 size(p.width, p.height, p.depth > 0 ? p.depth : p.width);
  switch (p.kind) {
    case EnvelopeKind::ball:
      return Envelope(EllipsoidCrown{{0, base + height / 2, 0}, size * 0.5f});
    case EnvelopeKind::cone:
      return Envelope(ConeCrown{{0, base, 0}, p.height, p.width / 2, p.top * p.width / 2});
    case EnvelopeKind::cylinder:
      return Envelope(ConeCrown{{0, base, 0}, p.height, p.width / 2, p.width / 2});
    case EnvelopeKind::mesh: {
      if (p.file.empty()) return Error{"", "an envelope of the kind mesh needs a file"};
      MeshCrown crown{p.mesh};
      Envelope raw(crown);
      Vec3 low = raw.low(), high = raw.high(), middle = (low + high) * 0.5f;
      float factor = height / std::max(high.y - low.y, 1e-6f);
      for (Vec3& v : crown.surface.position)
        v = (v - Vec3(middle.x, low.y, middle.z)) * factor + Vec3(0, base, 0);
      return Envelope(std::move(crown));
    }
    case EnvelopeKind::outline: {
      if (p.outline) return Envelope(SilhouetteCrown{*p.outline, {0, base, 0}, p.height, p.depth});
      if (p.path.empty()) return Error{"", "an envelope of the kind outline needs a file or a path"};
      Result<std::vector<std::vector<Vec2>>> drawn = read_svg_path(p.path);
      if (!drawn) return drawn.errors();
      // SVG's y runs down.
      for (auto& o : *drawn)
        for (Vec2& v : o) v.y = -v.y;
      Result<Silhouette> outline = Silhouette::from_outlines(std::move(*drawn));
      if (!outline) return outline.errors();
      return Envelope(SilhouetteCrown{*outline, {0, base, 0}, p.height, p.depth});
    }
  }
  return Error{"", "no such envelope"};
}

Errors check_colonized(const ColonizedParams& params) {
  const EnvelopeParams& e = params.envelope;
  bool waits = !e.file.empty() && (e.kind == EnvelopeKind::mesh || e.kind == EnvelopeKind::outline);
  if (waits) return {};  // its file is read later
  Result<Envelope> envelope = envelope_of(e);
  return envelope ? Errors{} : envelope.errors();
}

Result<Model> grow_colonized_tree(const ColonizedParams& params, Seed seed) {
  Result<Envelope> envelope = envelope_of(params.envelope);
  if (!envelope) return envelope.errors();
  Result<Skeleton> coarse = colonize(*envelope, params.growth_into, seed.child("tree"));
  if (!coarse) return coarse.errors();
  set_orders(*coarse);
  order_branches(*coarse);
  relax(*coarse);
  relax(*coarse);
  measure(*coarse);
  Model model;
  model.skeleton = smooth(*coarse, params.smoothing);
  measure(model.skeleton);
  set_births(model.skeleton);
  set_girth(model.skeleton, params.thickness, 0.1f);
  if (params.leaf_reach > 0) {
    std::vector<LeafSite> sites = dress_tips(model.skeleton, params.leaf_reach, params.leaf_spacing,
                                             params.leaf_down, seed.child("sites"));
    auto size = static_cast<float>(params.dress.leaves.size);
    put_leaves(model, sites, params.dress, Vec3(size), seed.child("leaf"));
  }
  return model;
}

std::vector<Drawing> dress_drawings(const TreeDress& dress, bool leafy) {
  std::vector<Drawing> all;
  if (leafy) all = leaf_drawings(look_of(dress));
  if (dress.coat) all.push_back(bark_drawing(*dress.coat));
  return all;
}

}  // namespace frond
