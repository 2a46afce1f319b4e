#include <algorithm>
#include <cmath>

#include "appearance/describe.h"
#include "appearance/picture_bounds.h"
#include "organisms/colonized/colonized.h"
#include "organisms/kinds.h"

namespace frond {

inline constexpr Choice<EnvelopeKind> kEnvelopeKinds[] = {
    {"ball", EnvelopeKind::ball, "a ball, pressed to its height, width and depth"},
    {"cone", EnvelopeKind::cone, "a cone, or a frustum"},
    {"cylinder", EnvelopeKind::cylinder, "a cylinder"},
    {"mesh", EnvelopeKind::mesh, "the inside of a closed mesh"},
    {"outline", EnvelopeKind::outline, "a silhouette, turned or with a depth"}};

void describe(Properties& v, EnvelopeParams& e) {
  v.choice("shape", e.kind, kEnvelopeKinds, "Shape of the room that the crown fills");
  v.number("base", e.base, metres(0, 500), "Height of the crown's foot above the ground");
  v.number("height", e.height, metres(0.01, 500), "Height of the crown alone");
  v.number("width", e.width, metres(0.01, 500), "Width of a ball, cone or cylinder; an outline has its own");
  v.number("depth", e.depth, metres(0, 500),
           "Depth from front to back; 0 makes it as deep as wide and turns an outline about its middle");
  v.number("top", e.top, {.min = 0, .max = 10},
           "Width of a cone's top as a share of its foot. Needs \"shape\": \"cone\"");
  v.file(
      "file", e.file, [&](const NamedFile& file) { return load_envelope(file, e); },
      "A mesh (OBJ, PLY, STL, GLB), or an SVG or a picture for an outline, named as seen from the preset's "
      "folder",
      e.kind == EnvelopeKind::mesh || e.kind == EnvelopeKind::outline);
  v.text("path", e.path, "SVG path data of the silhouette. Needs \"shape\": \"outline\"");
}

void describe(Properties& v, Colonization& c) {
  v.integer("attractors", c.attractors, {.min = 1, .max = 2e6},
            "Number of points in the room that branches grow toward");
  v.number("influence", c.influence, metres(0.001, 1000), "Distance from which a point attracts branches");
  v.number("kill", c.kill, metres(0.001, 1000),
           "Distance at which a branch has reached a point, which is gone then");
  v.number("step", c.step, metres(0.001, 100), "Length of a segment");
  v.number("tropism", c.tropism, {.min = -2, .max = 2}, "Upward pull on branches; negative pulls them down");
  v.number("jitter", c.jitter, kShare, "Random part of each direction");
  v.number("crowding", c.crowding, {.min = -1, .max = 1},
           "Where points are denser: -1 inside, 0 evenly, 1 at the rim");
  v.integer("most_nodes", c.most_nodes, {.min = 10, .max = 4e6},
            "Number of nodes at which growth ends in any case");
}

void describe(Properties& v, ColonizedParams& p) {
  v.object("envelope", p.envelope, "The room that the crown fills");
  v.object("colonize", p.growth_into, "How branches find their way");
  v.object(
      "guide", p.guide,
      "Lines that its first limbs follow, from the foot; what hangs off them grows by the kind's own laws");
  v.object("thickness", p.thickness, "Thickness of the branches");
  v.integer("smoothing", p.smoothing, {.min = 1, .max = 16},
            "Number of nodes that each segment is rounded with");
  describe(v, p.along);
  v.number("leaf_reach", p.leaf_reach, metres(0, 100),
           "Distance from a tip within which leaves stand; 0 leaves it bare");
  v.number("leaf_spacing", p.leaf_spacing, metres(0.001, 100), "Distance along a branch from leaf to leaf");
  v.angle("leaf_down", p.leaf_down, {.min = 0, .max = 180}, "Angle between a branch and its leaves");
  describe(v, p.appearance);
}

namespace {

class ColonizedGrower final : public Described<ColonizedParams, LoneGrower> {
 public:
  static constexpr std::string_view kLeading[] = {
      "envelope/shape",      "envelope/base", "envelope/height",  "envelope/width",  "envelope/top",
      "colonize/attractors", "colonize/kill", "colonize/tropism", "colonize/jitter", "thickness/exponent",
      "leaves/shape",        "leaves/size",   "leaves/colors"};

  GrowerTraits traits() const override {
    return {.stage = GrowthStage::round_bodies,
            .branches = true,
            .rebuilt = params.appearance.season ? Rebuilt::always : Rebuilt::never,
            .tallest = params.envelope.base + params.envelope.height,
            .sunk = params.guide.empty() ? 1.0f : 0.0f};  // whose places are given stands where they say
  }
  Review review() const override {
    Errors errors = check_colonized(params);
    if (errors.empty()) errors = season_faults(params.appearance.season);
    return {errors.empty() ? check_pictures(params.appearance) : errors};
  }
  Result<SizeEstimate> estimate_size(Seed) const override {
    // Of the points no more count than have room beside each other, and many are taken by the way.
    const Colonization& how = params.growth_into;
    const EnvelopeParams& e = params.envelope;
    double room = e.width * e.height * (e.depth > 0 ? e.depth : e.width) / std::pow(how.kill, 3);
    constexpr double kCount = 0.8;  // of the points, or of those that have room
    constexpr double kLeafy = 0.5;  // of the length of all branches
    double nodes = std::min({kCount * how.attractors, kCount * room, static_cast<double>(how.most_nodes)});
    SizeEstimate tree;
    tree.nodes = (nodes + e.base / how.step) * params.smoothing;
    double length = tree.nodes * how.step / params.smoothing;
    if (params.leaf_reach > 0) tree.organs = tree.parts = kLeafy * length / params.leaf_spacing;
    tree.nodes_a_second = kTreeNodesASecond;
    return tree;
  }
  Appearance appearance() const override { return tree_appearance(params.appearance, params.leaf_reach > 0); }
  Result<Model> grow_alone(Seed seed) const override { return grow_colonized_tree(params, seed); }
  Result<Model> grow_round(const Detour& detour, Seed seed) const override {
    return grow_colonized_tree(params, seed, detour);
  }
};

}  // namespace

Kind<Organism> colonized_kind() {
  return make_grower<ColonizedGrower>("colonized", "A tree that fills an envelope");
}

}  // namespace frond
