#include "appearance/describe.h"

#include "core/assets.h"

namespace frond {

namespace {

constexpr Choice<LeafShape> kLeafShapes[] = {{"birch", LeafShape::birch, "toothed, pointed"},
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

constexpr Choice<SprigArrangement> kSprigArrangements[] = {
    {"pinnate", SprigArrangement::pinnate, "in pairs along a common stalk"},
    {"digitate", SprigArrangement::digitate,
     "from the end of the stalk, like fingers, the middle one the largest, as in horse chestnut and lupin"}};

constexpr Choice<VeinPattern> kVeinPatterns[] = {
    {"pinnate", VeinPattern::pinnate, "secondaries leave a midrib"},
    {"palmate", VeinPattern::palmate, "main veins run from the stalk to the lobes"},
    {"parallel", VeinPattern::parallel, "veins run side by side from the stalk to the tip"},
    {"dichotomous", VeinPattern::dichotomous, "veins fork again and again, as in ginkgo"}};

}  // namespace

void describe(Properties& v, Sprig& s) {
  v.choice("arrangement", s.arrangement, kSprigArrangements, "How the leaves of a sprig stand");
  v.integer("pairs", s.pairs, {.min = 0, .max = 60}, "Number of pairs of leaves on a sprig");
  v.boolean("end_leaf", s.end_leaf, "Whether a leaf stands at the tip of a sprig");
  v.angle("angle", s.angle, {.min = 5, .max = 170},
          "Angle between a leaf and the stalk of its sprig, of digitate ones that of the outermost");
  v.number("length", s.length, {.min = 0.05, .max = 1}, "Length of a leaf as a share of the sprig's");
  v.number("shrink", s.shrink, {.min = 0, .max = 0.9},
           "How much smaller the leaves at the tip, or the outermost of digitate ones, are, as a share");
  v.number("alternate", s.alternate, {.min = 0, .max = 1},
           "How far the leaves of a pair stand apart; 0 opposite each other, 1 alternating. Needs "
           "\"arrangement\": \"pinnate\"");
}

void describe(Properties& v, Luster& l) {
  v.aspect(Aspect::look);
  v.number("through", l.through, {.min = 0, .max = 0.9},
           "Share of the light, of all that it throws back, that comes out on the other side: a leaf glows "
           "before a low sun");
  v.number("gloss", l.gloss, {.min = 0, .max = 1}, "Gloss of the upper side; the lower side is matt");
  v.number("relief", l.relief, {.min = 0, .max = 3}, "Depth of a leaf's veins or a petal's pleats");
  v.number("yellow", l.yellow, {.min = 0, .max = 1},
           "How much yellower the light is that comes through a leaf of pictures than what it throws back; "
           "1 as in summer");
}

void describe(Properties& v, LeafLook& l) {
  v.aspect(Aspect::look);
  v.choice("shape", l.shape, kLeafShapes, "Outline of a leaf");
  v.list("outline", l.outline, Count{0, 64},
         "Radii of the outline at even angles, from the tip round to the stalk. Needs \"shape\": \"own\"");
  v.number("width", l.width, {.min = 0.1, .max = 4},
           "Factor of the leaf's width; 1 leaves the shape as it is");
  v.number("stalk", l.stalk, {.min = 0, .max = 0.8},
           "Length of the stalk as a share of the whole leaf; without it as is usual for its shape");
  v.number("teeth", l.teeth, {.min = 0, .max = 60},
           "Number of teeth along either side; not given: as of its shape");
  v.number("tooth", l.tooth, {.min = 0, .max = 0.3},
           "Depth of the teeth as a share of the radius; not given: as of its shape");
  v.boolean("palmate", l.palmate,
            "Whether the main veins run from the stalk to the lobes, as in maple and vine, instead of from "
            "the midrib; not "
            "given: as of its shape");
  v.choice("venation", l.venation, kVeinPatterns,
           "How the main veins run; without it as palmate says, or as is usual for its shape");
  v.integer(
      "secondaries", l.secondaries, {.min = 1, .max = 60},
      "Number of side veins on either side of a midrib, or of veins that run parallel on either side of "
      "it; each lobe has its own. Without it as is usual for its shape");
  v.number("vein_density", l.vein_density, {.min = 0.3, .max = 3},
           "Factor of how close the veins between the side veins are");
  v.boolean("loops", l.loops,
            "Whether veins join again and enclose small fields, as in most leaves, instead of ending freely");
  v.number("size", l.size, {.min = 0.001, .max = 10, .unit = "m"},
           "Length of a leaf, or of a whole sprig where sprig is true");
  v.boolean("sprig", l.sprig, "Whether sprigs of several leaves stand where single leaves would");
  v.object("sprigs", l.sprigs, "How leaves are arranged on a sprig. Needs \"sprig\": true");
  v.boolean(
      "end_sprigs", l.end_sprigs,
      "Whether only sprigs at the ends of branches carry a leaf at their tip, and those along them none. "
      "Needs \"sprig\": true");
  v.list("colors", l.colors, Count{1, 16}, "Colours of the leaves; each leaf takes one of them");
  bool colored = false;
  v.given("colors", colored);
  v.file(
      "photo", l.photo, [&](const NamedFile& file) { return load_leaf_photo(file, colored, l); },
      "A picture (PNG or WebP) of a leaf that was cut out of a photograph, with transparency around it, the "
      "foot of its "
      "stalk at "
      "the bottom in the middle and its tip at the top; it gives the outline and the picture instead of the "
      "shape, "
      "and colors, where they are given, become its mean colour");
  v.color("veins", l.veins, "Colour of the veins and the stalk");
  v.color("rim", l.rim, "Colour toward the rim of a leaf");
  v.object("luster", l.luster, "How it takes light; without it as is usual for leaves");
  v.number("spots", l.spots, {.min = 0, .max = 1}, "How much the colour varies over one leaf");
  v.angle("fold", l.fold, {.min = -80, .max = 80}, "Angle by which each half is raised along the midrib");
  v.angle("bend", l.bend, {.min = -180, .max = 180},
          "Angle by which a leaf is bent down from its foot to its tip");
  v.number("pleat", l.pleat, {.min = 0, .max = 1},
           "How deeply a near leaf with a midrib is folded along its side veins, as those of beech, hornbeam "
           "and hazel; it takes a detail of 12 or more, and a single leaf that curls has no folds");
  v.number("curl", l.curl, {.min = 0, .max = 1},
           "How far its lobes curl up and its blade buckles, as it dries");
  v.number("age", l.age, {.min = 0, .max = 1}, "How far brown has come from the rim, and in blotches");
  v.integer("detail", l.detail, {.min = 3, .max = 80}, "Number of points of the mesh along half the rim");
  v.integer("pixels", l.pixels, {.min = 16, .max = 4096}, "Height of the leaf's picture");
  v.number("size_variation", l.size_variation, {.min = 0, .max = 0.9},
           "Random change of the size, as a share of it");
  v.angle("turn_variation", l.turn_variation, {.min = 0, .max = 180}, "Random tilt of each leaf, either way");
  v.aspect(Aspect::shape, "size", "fold", "bend", "pleat", "curl", "detail", "size_variation",
           "turn_variation");
}

}  // namespace frond
