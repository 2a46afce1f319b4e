#include "organisms/colonized/colonized.h"

#include <algorithm>

#include "crown/aside.h"
#include "geometry/mesh_file.h"
#include "geometry/smooth.h"
#include "images/read_picture.h"
#include "pruning/address.h"

namespace frond {

namespace {

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

/// Outlines of an SVG, whose y runs down.
Result<Silhouette> upright(std::vector<std::vector<Vec2>> drawn) {
  for (auto& outline : drawn)
    for (Vec2& p : outline) p.y = -p.y;
  return Silhouette::from_outlines(std::move(drawn));
}

Result<Silhouette> silhouette_of(const NamedFile& file) {
  if (file.path.extension() == ".svg") {
    Result<std::vector<std::vector<Vec2>>> drawn = read_svg(file.text);
    return drawn ? upright(std::move(*drawn)) : drawn.errors();
  }
  Result<Raster> picture = read_picture(file.text);
  if (!picture) return Error{file.path.string(), picture.errors().front().what + ", or an SVG"};
  return Silhouette::from_picture(*picture);
}

/// The envelope of a room; an error if something is missing.
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
      Result<Silhouette> outline = upright(std::move(*drawn));
      if (!outline) return outline.errors();
      return Envelope(SilhouetteCrown{*outline, {0, base, 0}, p.height, p.depth});
    }
  }
  return Error{"", "no such envelope"};
}

/// What rounding has brought nearer to bodies than its thickness, moved off them.
void bend_round(Skeleton& skeleton, const Detour& detour) {
  Crown bare{std::move(skeleton), {}};
  bend_aside(bare, detour);
  skeleton = std::move(bare.skeleton);
  set_tip_distances(skeleton);
  set_births(skeleton);
}

/// By the place where branches leave their parent.
void shape_branches(Skeleton& s, const BranchesAlong& by) {
  if (by.even()) return;
  ShapedAlong to = shape_along(s.parent, axis_nodes(s), s.position, s.radius, by);
  s.position = std::move(to.position);
  for (std::size_t i = 0; i < s.size(); ++i) s.radius[i] *= to.radius[i];
  set_distances(s);
  set_tip_distances(s);
  set_births(s);
}

}  // namespace

Errors check_colonized(const ColonizedParams& params) {
  Result<Envelope> envelope = envelope_of(params.envelope);
  return envelope ? check_guide(params.guide) : envelope.errors();
}

Result<Model> grow_colonized_tree(const ColonizedParams& params, Seed seed, const Detour& detour) {
  Result<Envelope> envelope = envelope_of(params.envelope);
  if (!envelope) return envelope.errors();
  Result<GuideAxes> guides = axes_of_guide(params.guide);
  if (!guides) return guides.errors();
  Colonization how = params.growth_into;
  how.detour = detour;
  Result<Skeleton> coarse = colonize(*envelope, how, seed.child("tree"), *guides);
  if (!coarse) return coarse.errors();
  set_orders(*coarse);
  order_branches(*coarse);
  relax(*coarse);
  relax(*coarse);
  set_distances(*coarse);
  set_tip_distances(*coarse);
  Model model;
  model.skeleton = smooth(*coarse, params.smoothing);
  set_distances(model.skeleton);
  set_tip_distances(model.skeleton);
  set_births(model.skeleton);
  set_girth(model.skeleton, params.thickness, 0.1f);
  shape_branches(model.skeleton, params.along);
  if (detour) bend_round(model.skeleton, detour);
  if (params.leaf_reach > 0) {
    std::vector<LeafSite> sites = leaf_sites_near_tips(model.skeleton, params.leaf_reach, params.leaf_spacing,
                                                       params.leaf_down, seed.child("sites"));
    auto size = static_cast<float>(params.appearance.leaves.size);
    put_leaves(model, sites, params.appearance, Vec3(size), seed.child("leaf"));
  }
  return model;
}

Errors load_envelope(const NamedFile& file, EnvelopeParams& envelope) {
  if (envelope.kind == EnvelopeKind::mesh) return load_unit_mesh(file, envelope.mesh);
  Result<Silhouette> outline = silhouette_of(file);
  if (!outline) return outline.errors();
  envelope.outline = std::move(*outline);
  return {};
}

}  // namespace frond
