#pragma once

#include "organisms/crown_tree.h"
#include "organisms/describe_plant.h"
#include "organisms/describe_season.h"

// The properties of trees by their crown as presets spell them; see preset/describe.h.

namespace frond {

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

inline constexpr Choice<LeafShape> kLeafShapes[] = {
    {"birch", LeafShape::birch, "toothed, pointed"},
    {"beech", LeafShape::beech, "an oval"},
    {"oak", LeafShape::oak, "round lobes"},
    {"maple", LeafShape::maple, "five pointed lobes"},
    {"ivy", LeafShape::ivy, "three to five lobes"},
    {"aspen", LeafShape::aspen, "nearly round, on a long stalk"},
    {"willow", LeafShape::willow, "long and narrow"},
    {"linden", LeafShape::linden, "a heart"},
    {"cherry", LeafShape::cherry, "a toothed oval"},
    {"ginkgo", LeafShape::ginkgo, "a fan"},
    {"own", LeafShape::own, "the radii under outline"}};

inline constexpr Choice<BarkPattern> kBarkPatterns[] = {
    {"furrowed", BarkPattern::furrowed, "long ridges, as on oaks"},
    {"plated", BarkPattern::plated, "plates between cracks, as on pines"},
    {"smooth", BarkPattern::smooth, "folds and short scars, as on beeches"},
    {"banded", BarkPattern::banded, "papery with dark bands, as on birches"}};

inline constexpr Choice<EnvelopeKind> kEnvelopeKinds[] = {
    {"ball", EnvelopeKind::ball, "a ball, pressed to its height, width and depth"},
    {"cone", EnvelopeKind::cone, "a cone, or a frustum"},
    {"cylinder", EnvelopeKind::cylinder, "a cylinder"},
    {"mesh", EnvelopeKind::mesh, "the inside of a closed mesh"},
    {"outline", EnvelopeKind::outline, "a silhouette, turned or with a depth"}};

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
void describe(Visitor& v, Sprig& s) {
  v.integer("pairs", s.pairs, {.min = 0, .max = 60}, "Of leaves");
  v.boolean("end_leaf", s.end_leaf, "Whether one stands at the tip");
  v.angle("angle", s.angle, {.min = 5, .max = 110}, "Between leaf and stalk");
  v.number("length", s.length, {.min = 0.05, .max = 1}, "Of a leaf as a share of the sprig's");
  v.number("shrink", s.shrink, {.min = 0, .max = 0.9}, "How much smaller leaves at the tip are");
  v.number("alternate", s.alternate, {.min = 0, .max = 1}, "0: in pairs; 1: by turns");
}

template <class Visitor>
void describe(Visitor& v, LeafLook& l) {
  v.choice("shape", l.shape, kLeafShapes, "Its outline");
  v.list("outline", l.outline, Count{0, 64},
         "Of an own shape: radii from the tip to the stalk, by even angles");
  v.number("width", l.width, {.min = 0.1, .max = 4}, "Factor across");
  v.number("size", l.size, {.min = 0.001, .max = 10, .unit = "m"}, "Length, of a sprig the whole of it");
  v.boolean("sprig", l.sprig, "Sprigs in place of leaves");
  v.object("sprigs", l.sprigs, "How leaves stand on a sprig");
  v.list("colors", l.colors, Count{1, 16}, "Each leaf has one of them");
  v.color("veins", l.veins, "Of veins and stalk");
  v.color("rim", l.rim, "Toward the rim");
  v.number("spots", l.spots, {.min = 0, .max = 1}, "How much the colour varies over a leaf");
  v.angle("fold", l.fold, {.min = -80, .max = 80}, "By which each half is raised");
  v.angle("bend", l.bend, {.min = -180, .max = 180}, "From foot to tip, downward");
  v.integer("detail", l.detail, {.min = 3, .max = 80}, "Points of the mesh along half a rim");
  v.integer("pixels", l.pixels, {.min = 16, .max = 4096}, "Height of its picture");
  v.number("size_variation", l.size_variation, {.min = 0, .max = 0.9},
           "Random change of the size, as a share");
  v.angle("turn_variation", l.turn_variation, {.min = 0, .max = 180}, "Random tilt, either way");
}

template <class Visitor>
void describe(Visitor& v, BarkCoat& c) {
  v.choice("pattern", c.image.pattern, kBarkPatterns, "What it looks like");
  v.color("color", c.image.color, "On the ridges");
  v.color("second", c.image.second, "In furrows, cracks and bands");
  v.color("lichen", c.image.lichen, "Of the lichens");
  v.number("lichens", c.image.lichens, {.min = 0, .max = 1}, "How much of it they cover");
  v.integer("ridges", c.image.ridges, {.min = 1, .max = 200}, "Round the picture");
  v.number("stretch", c.image.stretch, {.min = 0.5, .max = 40}, "How much longer than wide its features are");
  v.number("warp", c.image.warp, {.min = 0, .max = 3}, "How far ridges wander");
  v.number("depth", c.image.depth, {.min = 0, .max = 1}, "Of furrows");
  v.number("wrap", c.wrap, {.min = 0.001, .max = 20, .unit = "m"}, "Round a branch that the picture is wide");
  v.number("aspect", c.aspect, {.min = 0.25, .max = 16}, "How much longer than wide the picture is");
  v.integer("pixels", c.pixels, {.min = 16, .max = 8192}, "Its width");
  v.number("relief", c.relief, {.min = 0, .max = 10}, "Of the bumps");
  v.number("facet", c.facet, {.min = 0.0005, .max = 10, .unit = "m"}, "Width of a side of the mesh, about");
  v.number("twigs", c.twigs, {.min = 0, .max = 10, .unit = "m"},
           "Branches that begin with a smaller radius wear the plain bark");
}

template <class Visitor>
void describe(Visitor& v, TreeDress& d) {
  v.object("bark", d.bark, "Their surface");
  v.object("coat", d.coat, "A bark as a picture; branches are meshes then");
  v.object("leaves", d.leaves, "The leaves");
  v.object("season", d.season, "Its year");
  v.object("wave", d.wave, "Swaying in the wind");
  v.object("growth", d.growth, "When it grows");
}

template <class Visitor>
void describe(Visitor& v, WeberPennParams& p) {
  v.object("tree", p.tree, "Its shape");
  v.text("species", p.species, "An Arbaro XML file in place of tree, as seen from the preset's folder");
  describe(v, p.dress);
}

template <class Visitor>
void describe(Visitor& v, EnvelopeParams& e) {
  v.choice("shape", e.kind, kEnvelopeKinds, "What it is");
  v.number("base", e.base, {.min = 0, .max = 500, .unit = "m"}, "Above the ground");
  v.number("height", e.height, {.min = 0.01, .max = 500, .unit = "m"}, "Of the crown alone");
  v.number("width", e.width, {.min = 0.01, .max = 500, .unit = "m"}, "Of a ball, cone or cylinder");
  v.number("depth", e.depth, {.min = 0, .max = 500, .unit = "m"},
           "From front to back; 0: as wide, an outline is turned about its middle");
  v.number("top", e.top, {.min = 0, .max = 10}, "Of a cone: its top as a share of its foot");
  v.text("file", e.file, "OBJ, SVG or PNG, as seen from the preset's folder");
  v.text("path", e.path, "Of an outline: SVG path data");
}

template <class Visitor>
void describe(Visitor& v, Colonization& c) {
  v.integer("attractors", c.attractors, {.min = 1, .max = 2e6}, "Points in the envelope");
  v.number("influence", c.influence, {.min = 0.001, .max = 1000, .unit = "m"}, "How far a point attracts");
  v.number("kill", c.kill, {.min = 0.001, .max = 1000, .unit = "m"}, "How near a branch takes a point");
  v.number("step", c.step, {.min = 0.001, .max = 100, .unit = "m"}, "Length of a segment");
  v.number("tropism", c.tropism, {.min = -2, .max = 2}, "Upward pull; negative: downward");
  v.number("jitter", c.jitter, {.min = 0, .max = 1}, "Random part of each direction");
  v.number("crowding", c.crowding, {.min = -1, .max = 1}, "-1: more points inside; 1: more at the rim");
  v.integer("most_nodes", c.most_nodes, {.min = 10, .max = 4e6}, "Where growth ends in any case");
}

template <class Visitor>
void describe(Visitor& v, ColonizedParams& p) {
  v.object("envelope", p.envelope, "The room that it fills");
  v.object("colonize", p.growth_into, "How branches find their way");
  v.object("thickness", p.thickness, "Thickness of the branches");
  v.integer("smoothing", p.smoothing, {.min = 1, .max = 16}, "Nodes for each segment");
  v.number("leaf_reach", p.leaf_reach, {.min = 0, .max = 100, .unit = "m"},
           "How far from tips leaves stand; 0: none");
  v.number("leaf_spacing", p.leaf_spacing, {.min = 0.001, .max = 100, .unit = "m"}, "From leaf to leaf");
  v.angle("leaf_down", p.leaf_down, {.min = 0, .max = 180}, "Between branch and leaf");
  describe(v, p.dress);
}

}  // namespace frond
