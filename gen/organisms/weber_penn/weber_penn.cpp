#include "organisms/weber_penn/weber_penn.h"

#include <algorithm>
#include <cmath>

#include "crown/arbaro.h"
#include "dress/describe.h"
#include "dress/picture_bounds.h"
#include "organisms/crown_leaves.h"
#include "organisms/kinds.h"

namespace frond {

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

Errors load_species(const NamedFile& file, WeberPenn& tree) {
  Result<ArbaroSpecies> species = read_arbaro(file.text, file.path.string());
  if (!species) return species.errors();
  tree = species->tree;
  return {};
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

template <class Visitor>
void describe(Visitor& v, StemLevel& s) {
  constexpr Range kAngle{.min = -3600, .max = 3600};
  v.angle("down_angle", s.down_angle, kAngle, "From the parent");
  v.angle("down_angle_v", s.down_angle_v, kAngle,
          "Its variation; negative: it falls by so much from the parent's base to its top");
  v.angle("rotate", s.rotate, kAngle, "About the parent from stem to stem; negative: to and fro");
  v.angle("rotate_v", s.rotate_v, kAngle, "Its variation");
  v.number("branches", s.branches, {.min = 0, .max = 2000},
           "Stems of this level on one of the level below, which it shares with its clones");
  v.number("branch_dist", s.branch_dist, {.min = 0, .max = 100},
           "0: in whorls at each segment; 1: evenly; more: a whorl each so many segments");
  v.number("length", s.length, {.min = 0, .max = 100}, "Share of the parent's, of a trunk: of the scale");
  v.number("length_v", s.length_v, {.min = 0, .max = 100}, "Its variation");
  v.number("taper", s.taper, {.min = 0, .max = 3}, "0: cylinder; 1: to a point; 2: a round end; 3: pearls");
  v.number("seg_splits", s.seg_splits, {.min = 0, .max = 4}, "Clones that split off at each segment");
  v.angle("split_angle", s.split_angle, {.min = 0, .max = 180}, "Between stem and clone");
  v.angle("split_angle_v", s.split_angle_v, {.min = 0, .max = 180}, "Its variation");
  v.integer("curve_res", s.curve_res, {.min = 1, .max = 200}, "Segments of a stem");
  v.angle("curve", s.curve, kAngle, "By which it bends over its length");
  v.angle("curve_back", s.curve_back, kAngle, "By which its upper half bends instead");
  v.angle("curve_v", s.curve_v, kAngle, "Random bending; negative: a helix of that slope");
}

template <class Visitor>
void describe(Visitor& v, Pruning& p) {
  v.number("ratio", p.ratio, {.min = 0, .max = 1}, "0: none; 1: nothing stands out of the envelope");
  v.number("width", p.width, {.min = 0, .max = 10}, "Radius as a share of the scale");
  v.number("width_peak", p.width_peak, {.min = 0, .max = 1},
           "Where it is widest: 0 at the foot; 1 at the top");
  v.number("power_low", p.power_low, {.min = 0, .max = 100}, "Bulge below: 1 straight, less is rounder");
  v.number("power_high", p.power_high, {.min = 0, .max = 100}, "Bulge above");
}

template <class Visitor>
void describe(Visitor& v, WeberPenn& t) {
  v.choice("shape", t.shape, kCrownShapes, "How long branches are by their height");
  v.number("cone_top", t.cone_top, {.min = 0, .max = 1},
           "Of a conical crown: its topmost branches as a share of the longest");
  v.number("base_size", t.base_size, {.min = 0, .max = 1}, "Share of the tree without branches");
  v.number("scale", t.scale, {.min = 0.01, .max = 500, .unit = "m"}, "Size of the tree");
  v.number("scale_v", t.scale_v, {.min = 0, .max = 500, .unit = "m"}, "Its variation");
  v.number("z_scale", t.z_scale, {.min = 0.05, .max = 20}, "Factor of the height alone");
  v.number("z_scale_v", t.z_scale_v, {.min = 0, .max = 20}, "Its variation");
  v.integer("levels", t.levels, {.min = 1, .max = 9}, "Of stems, the trunk included");
  v.number("ratio", t.ratio, {.min = 0.0001, .max = 1}, "Radius of the trunk as a share of its length");
  v.number("ratio_power", t.ratio_power, {.min = -10, .max = 10}, "How fast radii fall with length");
  v.number("flare", t.flare, {.min = -1, .max = 10}, "How much wider the foot is");
  v.integer("lobes", t.lobes, {.min = 0, .max = 100}, "Of the trunk's cross-section (branches with a coat)");
  v.number("lobe_depth", t.lobe_depth, {.min = 0, .max = 0.9}, "Share of the radius");
  v.number("trunk_scale", t.trunk_scale, {.min = 0.01, .max = 20}, "Factor of the trunk's radius");
  v.number("trunk_scale_v", t.trunk_scale_v, {.min = 0, .max = 20}, "Its variation");
  v.integer("base_splits", t.base_splits, {.min = 0, .max = 20}, "Clones above the trunk's first segment");
  v.integer("trunks", t.trunks, {.min = 1, .max = 1000}, "How many stand beside each other");
  v.number("trunk_spread", t.trunk_spread, {.min = 0, .max = 100, .unit = "m"},
           "How far from the middle they stand, at most");
  v.object("trunk", t.level[0], "Level 0");
  v.object("branches", t.level[1], "Level 1");
  v.object("twigs", t.level[2], "Level 2");
  v.object("shoots", t.level[3], "Level 3 and all beyond");
  v.number("leaves", t.leaves, {.min = -2000, .max = 2000},
           "On one stem of the last level, and on each clone; negative: a fan at its end");
  v.choice("leaf_distribution", t.leaf_distribution, kCrownShapes, "Over the level that bears them");
  v.number("leaf_scale", t.leaf_scale, {.min = 0.001, .max = 20, .unit = "m"}, "Length of a leaf");
  v.number("leaf_scale_x", t.leaf_scale_x, {.min = 0.01, .max = 10}, "Its width as a share of the length");
  v.number("leaf_bend", t.leaf_bend, {.min = 0, .max = 1}, "How far leaves turn to the light");
  v.number("leaf_stem_length", t.leaf_stem_length, {.min = -1, .max = 10}, "Share of the leaf's length");
  v.number("leaf_quality", t.leaf_quality, {.min = 0.01, .max = 1},
           "Share of the leaves; they grow to make up");
  v.number("attraction_up", t.attraction_up, {.min = -20, .max = 20},
           "Of twigs and shoots; negative: they hang");
  v.object("pruning", t.pruning, "The envelope that branches are cut to");
  v.integer("smoothing", t.smoothing, {.min = 1, .max = 16}, "Nodes for each segment");
}

template <class Visitor>
void describe(Visitor& v, WeberPennParams& p) {
  v.object("tree", p.tree, "Its shape");
  v.file(
      "species", p.species, [&](const NamedFile& file) { return load_species(file, p.tree); },
      "An Arbaro XML file in place of tree, as seen from the preset's folder");
  describe(v, p.dress);
}

namespace {

constexpr double kMostNodes = 8e6;

class WeberPennGrower final : public Described<WeberPennParams, LoneGrower> {
 public:
  Errors check() const override {
    if (foresee_nodes(params.tree) < kMostNodes) return check_pictures(params.dress);
    return {{"", "the tree would have more than 4000000 nodes; fewer branches, splits or segments"}};
  }
  Result<Foresight> foresee(Seed) const override {
    const WeberPenn& form = params.tree;
    Foresight tree;
    tree.nodes = foresee_nodes(form);
    tree.organs = 0.72 * tree.nodes * std::abs(form.leaves) * form.leaf_quality /
                  std::max(1, form.stem(form.levels - 1).curve_res * form.smoothing);
    tree.parts = tree.organs;
    return tree;
  }
  double tallest() const override { return 1.2 * (params.tree.scale + params.tree.scale_v); }
  Dress dress() const override {
    Dress dress = dress_of(params.dress, params.tree.leaves != 0);
    dress.look.lobes = params.tree.lobes;
    dress.look.lobe_depth = params.tree.lobe_depth;
    return dress;
  }
  bool develops(bool) const override { return params.dress.season.has_value(); }
  std::optional<Result<Grammar>> grammar() const override { return std::nullopt; }
  Result<Model> grow_alone(Seed seed) const override { return grow_weber_penn_tree(params, seed); }
  std::function<Result<Model>(double)> develop(const Motion&, Seed) const override { return {}; }
};

}  // namespace

Kind<Organism> weber_penn_kind() {
  return make_grower<WeberPennGrower>("weber_penn", "A tree by the parameters of Weber and Penn");
}

}  // namespace frond
