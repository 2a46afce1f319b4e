#include "appearance/describe.h"

namespace frond {

namespace {

constexpr Choice<FruitForm> kFruitForms[] = {
    {"round", FruitForm::round, "a ball with a hollow round its stalk, as of apples, cherries and berries"},
    {"drop", FruitForm::drop, "narrow at its stalk, as a pear"},
    {"pod", FruitForm::pod, "long and blunt, as pods and catkins"},
    {"winged", FruitForm::winged, "a thin blade, as the keys of an ash"},
    {"cone", FruitForm::cone, "scales in rows, as on conifers and alders"},
    {"spiny", FruitForm::spiny, "a capsule with spines, as of a horse chestnut"},
    {"acorn", FruitForm::acorn, "a nut in a cup of the second colour"}};

constexpr Range kDates{.min = 0, .max = 2, .unit = "years"};

}  // namespace

void describe(Properties& v, Fruiting& f) {
  v.vector("set", f.set, kDates,
           "Times of the year at which the first fruit sets, and the last: 0.25 is the first of April");
  v.vector("ripe", f.ripe, kDates,
           "When the first is ripe, and the last: grown and in its last colour; a time in the year after "
           "flowering is above 1");
  v.vector("fall", f.fall, kDates, "When the first falls, and the last; likewise");
  v.number("share", f.share, {.min = 0, .max = 1},
           "Share of the leaves' places that bear; those with flowers come first");
  v.integer("cluster", f.cluster, {.min = 1, .max = 100}, "Number of fruits at one place");
  v.text(
      "organ", f.organ,
      "Symbol of a plant's own organ whose places bear, in place of those of leaves; the organ itself is a "
      "flower that comes before where there is flowering, and is not shown otherwise");
  v.number("stalk", f.stalk, {.min = 0, .max = 1, .unit = "m"},
           "Length of the stalk of each fruit; 0 leaves it out");
  v.angle(
      "angle", f.angle, {.min = 0, .max = 180},
      "Largest angle between the stalk of a ripe fruit and the plumb line; those of a cluster that have no "
      "room push each other farther aside");
  v.number("size", f.size, {.min = 0.0005, .max = 1, .unit = "m"},
           "Length of a ripe fruit without its stalk");
  v.number("size_variation", f.size_variation, {.min = 0, .max = 0.9},
           "Random change of the size, as a share of it");
  v.number("lies", f.lies, {.min = 0, .max = 1, .unit = "years"},
           "How long a fallen fruit lies on the ground and rots; below copies there is none");
  v.number("width", f.width, {.min = 0.02, .max = 3}, "Width of the form, as a share of its length");
  v.aspect(Aspect::look);
  v.choice("form", f.form, kFruitForms, "What the fruit is");
  v.file(
      "model", f.model, [&](const NamedFile& file) { return load_fruit_model(file, f); },
      "A mesh in place of the form (OBJ, PLY, STL, GLB), named as seen from the preset's folder: the middle "
      "of "
      "its underside is where the stalk ends, y points away from that, its longest side becomes size; it "
      "wears "
      "the colours given here, not the file's materials");
  v.list("colors", f.colors, Count{1, 8}, "Colours that the fruit goes through, from unripe to ripe");
  v.color(
      "blush", f.blush,
      "Colour that comes, in streaks, to the side that looks out of the crown, toward the sun; without it "
      "all sides are alike");
  v.color("second", f.second, "Colour of the stalk, and of an acorn's cup");
  v.number("gloss", f.gloss, {.min = 0, .max = 1}, "Gloss of the skin");
}

}  // namespace frond
