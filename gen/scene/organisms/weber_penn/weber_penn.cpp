#include "organisms/weber_penn/weber_penn.h"

#include <algorithm>
#include <cmath>

#include "appearance/describe.h"
#include "appearance/picture_bounds.h"
#include "crown/arbaro.h"
#include "organisms/kinds.h"

namespace frond {

Result<Model> grow_weber_penn_tree(const WeberPennParams& params, Seed seed, const Detour& detour) {
  WeberPenn led = params.tree;
  Result<GuideAxes> guides = axes_of_guide(params.guide);
  if (!guides) return guides.errors();
  led.guides = std::move(*guides);
  led.detour = detour;
  Result<Crown> crown = grow_weber_penn(led, seed.child("tree"));
  if (!crown) return crown.errors();
  Model model;
  model.skeleton = std::move(crown->skeleton);
  // What the stalk takes is not part of the blade, whose length LeafScale is.
  const WeberPenn& tree = params.tree;
  LeafLook look = params.appearance.leaves;
  auto length = static_cast<float>(tree.leaf_scale * (1 + std::max(tree.leaf_stem_length, 0.0)));
  double share = 0;
  LeafImage image = leaf_image(look, 0);
  std::vector<Vec2> rim = leaf_rim(image.outline, 40);
  for (Vec2 p : rim) share = std::max<double>(share, 2 * p.x);
  // As wide as LeafScaleX asks, unless it is a sprig, which has its own shape.
  float wide =
      look.sprig ? length : static_cast<float>(tree.leaf_scale_x * tree.leaf_scale / std::max(share, 0.05));
  put_leaves(model, crown->leaves, params.appearance, Vec3(wide, length, length), seed.child("leaf"));
  return model;
}

inline constexpr Choice<CrownShape> kCrownShapes[] = {
    {"conical", CrownShape::conical, "long branches below"},
    {"spherical", CrownShape::spherical, "long branches in the middle"},
    {"hemispherical", CrownShape::hemispherical, "a dome"},
    {"cylindrical", CrownShape::cylindrical, "all as long"},
    {"tapered_cylindrical", CrownShape::tapered_cylindrical, "a little shorter toward the top"},
    {"flame", CrownShape::flame, "longest low, drawn out to a point"},
    {"inverse_conical", CrownShape::inverse_conical, "long branches at the top"},
    {"tend_flame", CrownShape::tend_flame, "between a flame and a cylinder"},
    {"envelope", CrownShape::envelope, "as the pruning's envelope"}};

void describe(Properties& v, StemLevel& s) {
  constexpr Range kAngle{.min = -3600, .max = 3600};
  v.angle("down_angle", s.down_angle, kAngle, "Angle between a stem and its parent");
  v.angle("down_angle_v", s.down_angle_v, kAngle,
          "Random change of down_angle; negative makes it fall by so much from the parent's base to its top");
  v.angle("rotate", s.rotate, kAngle,
          "Angle about the parent from one stem to the next; negative turns to and fro");
  v.angle("rotate_v", s.rotate_v, kAngle, "Random change of rotate");
  v.number("branches", s.branches, {.min = 0, .max = 2000},
           "Number of stems of this level on one of the level below, shared with its clones");
  v.number("branch_dist", s.branch_dist, {.min = 0, .max = 100},
           "How stems are distributed: 0 in whorls at each segment, 1 evenly, more a whorl every so many "
           "segments");
  v.number("length", s.length, {.min = 0, .max = 100},
           "Length as a share of the parent's; of the trunk as a share of the scale");
  v.number("length_v", s.length_v, {.min = 0, .max = 100}, "Random change of the length");
  v.number("taper", s.taper, {.min = 0, .max = 3},
           "How the stem tapers: 0 a cylinder, 1 to a point, 2 a round end, 3 pearls");
  v.number("seg_splits", s.seg_splits, {.min = 0, .max = 4},
           "Number of clones that split off at each segment");
  v.angle("split_angle", s.split_angle, {.min = 0, .max = 180}, "Angle between a stem and its clone");
  v.angle("split_angle_v", s.split_angle_v, {.min = 0, .max = 180}, "Random change of split_angle");
  v.integer("curve_res", s.curve_res, {.min = 1, .max = 200}, "Number of segments of a stem");
  v.angle("curve", s.curve, kAngle, "Angle by which a stem bends over its length");
  v.angle("curve_back", s.curve_back, kAngle, "Angle by which its upper half bends instead");
  v.angle("curve_v", s.curve_v, kAngle,
          "Random bending over the length; negative makes a helix of that slope");
  v.curve(
      "angle_along", s.angle_along,
      "Factor of down_angle by the place on the parent, from 0 at its foot to 1 at its tip; of the leaves "
      "as well that a stem of the level before bears");
  v.curve("length_along", s.length_along, "Factor of the length by the place on the parent, as angle_along");
  v.curve(
      "radius_along", s.radius_along,
      "Factor of the radius by the place on the parent, as angle_along; no stem is thicker than its parent "
      "there");
  v.curve("branches_along", s.branches_along,
          "How densely stems stand by the place on the parent, as angle_along; their number stays");
}

void describe(Properties& v, Pruning& p) {
  v.number("ratio", p.ratio, kShare,
           "How strictly branches are cut to the envelope: 0 not at all, 1 nothing stands out of it");
  v.number("width", p.width, {.min = 0, .max = 10}, "Radius of the envelope as a share of the scale");
  v.number("width_peak", p.width_peak, kShare, "Where the envelope is widest: 0 at its foot, 1 at its top");
  v.number("power_low", p.power_low, {.min = 0, .max = 100},
           "Bulge of the envelope below its widest place: 1 is straight, less is rounder");
  v.number("power_high", p.power_high, {.min = 0, .max = 100},
           "Bulge of the envelope above its widest place: 1 is straight, less is rounder");
}

void describe(Properties& v, WeberPenn& t) {
  v.choice("shape", t.shape, kCrownShapes, "How long branches are by their height on the trunk");
  v.number("cone_top", t.cone_top, kShare,
           "Length of the topmost branches as a share of the longest. Needs \"shape\": \"conical\"");
  v.number("base_size", t.base_size, kShare,
           "Share of the tree's height, from the ground, that bears no branches");
  v.number("scale", t.scale, metres(0.01, 500), "Height of the tree, about");
  v.number("scale_v", t.scale_v, metres(0, 500), "Random change of the scale");
  v.number("z_scale", t.z_scale, {.min = 0.05, .max = 20}, "Factor of the height alone");
  v.number("z_scale_v", t.z_scale_v, {.min = 0, .max = 20}, "Random change of z_scale");
  v.integer("levels", t.levels, {.min = 1, .max = 9}, "Number of levels of stems, the trunk included");
  v.number("ratio", t.ratio, {.min = 0.0001, .max = 1}, "Radius of the trunk as a share of its length");
  v.number("ratio_power", t.ratio_power, {.min = -10, .max = 10}, "How fast radii fall with length");
  v.number("flare", t.flare, {.min = -1, .max = 10},
           "How much wider the foot is than the stem above it, as a share");
  v.integer("lobes", t.lobes, {.min = 0, .max = 100},
            "Number of lobes of the trunk's cross-section. Needs a coat");
  v.number("lobe_depth", t.lobe_depth, {.min = 0, .max = 0.9}, "Depth of a lobe as a share of the radius");
  v.number("trunk_scale", t.trunk_scale, {.min = 0.01, .max = 20}, "Factor of the trunk's radius");
  v.number("trunk_scale_v", t.trunk_scale_v, {.min = 0, .max = 20}, "Random change of trunk_scale");
  v.integer("base_splits", t.base_splits, {.min = 0, .max = 20},
            "Number of clones that split off above the trunk's first segment");
  v.integer("trunks", t.trunks, {.min = 1, .max = 1000}, "Number of trunks that stand beside each other");
  v.number("trunk_spread", t.trunk_spread, metres(0, 100),
           "Distance from the middle at which trunks stand, at most");
  v.object("trunk", t.level[0], "The trunk, level 0");
  v.object("branches", t.level[1], "The branches on the trunk, level 1");
  v.object("twigs", t.level[2], "The twigs on branches, level 2");
  v.object("shoots", t.level[3], "The shoots on twigs, level 3 and all beyond");
  v.number("leaves", t.leaves, {.min = -2000, .max = 2000},
           "Number of leaves on one stem of the last level and on each clone; negative sets them as a fan at "
           "its end");
  v.choice("leaf_distribution", t.leaf_distribution, kCrownShapes,
           "How leaves are distributed over the level that bears them");
  v.number("leaf_scale", t.leaf_scale, metres(0.001, 20), "Length of a leaf");
  v.number("leaf_scale_x", t.leaf_scale_x, {.min = 0.01, .max = 10},
           "Width of a leaf as a share of its length");
  v.number("leaf_bend", t.leaf_bend, kShare, "How far leaves turn to the light");
  v.number("leaf_stem_length", t.leaf_stem_length, {.min = -1, .max = 10},
           "Length of a leaf's stalk as a share of the leaf's");
  v.number("leaf_quality", t.leaf_quality, {.min = 0.01, .max = 1},
           "Share of the leaves that are drawn; they are enlarged to make up");
  v.number("attraction_up", t.attraction_up, {.min = -20, .max = 20},
           "Upward pull on twigs and shoots; negative lets them hang");
  v.object("pruning", t.pruning, "The envelope that branches are cut to");
  v.integer("smoothing", t.smoothing, {.min = 1, .max = 16},
            "Number of nodes that each segment is rounded with");
}

void describe(Properties& v, WeberPennParams& p) {
  v.object("tree", p.tree, "The shape of the tree");
  v.object("guide", p.guide,
           "Lines that the first trunk follows, its forks as clones that split off, from the foot; what "
           "hangs off them grows by the kind's own laws");
  v.file(
      "arbaro", p.arbaro,
      [&](const NamedFile& file) -> Errors {
        Result<ArbaroSpecies> species = read_arbaro(file.text, file.path.string());
        if (!species) return species.errors();
        p.tree = species->tree;
        return {};
      },
      "An XML file of Arbaro, named as seen from the preset's folder, in place of tree");
  describe(v, p.appearance);
}

namespace {

constexpr double kMostNodes = 8e6;

class WeberPennGrower final : public Described<WeberPennParams, LoneGrower> {
 public:
  static constexpr std::string_view kLeading[] = {
      "tree/shape",    "tree/scale",    "tree/base_size", "tree/ratio",      "tree/levels",
      "tree/branches", "tree/twigs",    "tree/leaves",    "tree/leaf_scale", "tree/attraction_up",
      "leaves/shape",  "leaves/colors", "bark/kind"};

  GrowerTraits traits() const override {
    return {.stage = GrowthStage::round_bodies,
            .branches = true,
            .rebuilt = params.appearance.season ? Rebuilt::always : Rebuilt::never,
            .tallest = 1.2 * (params.tree.scale + params.tree.scale_v),
            .sunk = params.guide.empty() ? 1.0f : 0.0f};  // whose places are given stands where they say
  }
  Review review() const override {
    if (Errors errors = check_guide(params.guide); !errors.empty()) return {errors};
    if (Errors errors = season_faults(params.appearance.season); !errors.empty()) return {errors};
    if (estimate_nodes(params.tree) < kMostNodes) return {check_pictures(params.appearance)};
    return {{error_at("", "the tree would have more than {:.0f} nodes; fewer branches, splits or segments",
                      kMostNodes)}};
  }
  Result<SizeEstimate> estimate_size(Seed) const override {
    const WeberPenn& form = params.tree;
    SizeEstimate tree;
    tree.nodes = estimate_nodes(form);
    tree.organs = 0.72 * tree.nodes * std::abs(form.leaves) * form.leaf_quality /
                  std::max(1, form.stem(form.levels - 1).curve_res * form.smoothing);
    tree.parts = tree.organs;
    return tree;
  }
  Appearance appearance() const override {
    Appearance appearance = tree_appearance(params.appearance, params.tree.leaves != 0);
    appearance.look.branches.lobes = params.tree.lobes;
    appearance.look.branches.lobe_depth = params.tree.lobe_depth;
    return appearance;
  }
  Result<Model> grow_alone(Seed seed) const override { return grow_weber_penn_tree(params, seed); }
  Result<Model> grow_round(const Detour& detour, Seed seed) const override {
    return grow_weber_penn_tree(params, seed, detour);
  }
};

}  // namespace

Kind<Organism> weber_penn_kind() {
  return make_grower<WeberPennGrower>("weber_penn", "A tree by the parameters of Weber and Penn");
}

}  // namespace frond
