#include "organisms/plant/describe_flower.h"

#include <fmt/format.h>

#include "appearance/describe.h"

namespace frond {

inline constexpr Choice<FloralPart> kFloralParts[] = {
    {"sepals", FloralPart::sepals, "green, around the bud"},
    {"tepals", FloralPart::tepals, "sepals and petals alike, as a lily has"},
    {"petals", FloralPart::petals, "coloured"},
    {"stamens", FloralPart::stamens, "filaments with anthers"},
    {"carpels", FloralPart::carpels, "an ovary with its style and stigmas; without fused 1 each by itself"}};

inline constexpr Choice<Aestivation> kAestivations[] = {
    {"valvate", Aestivation::valvate, "edge to edge"},
    {"imbricate", Aestivation::imbricate, "some outside, some inside; of two sides the upper outside"},
    {"contorted", Aestivation::contorted, "each over one neighbour and under the other"}};

inline constexpr Choice<InflorescenceType> kInflorescenceTypes[] = {
    {"raceme", InflorescenceType::raceme, "flowers on stalks along an axis"},
    {"spike", InflorescenceType::spike, "flowers along an axis without stalks"},
    {"corymb", InflorescenceType::corymb, "a raceme whose flowers are in one plane"},
    {"umbel", InflorescenceType::umbel, "stalks from one place"},
    {"compound_umbel", InflorescenceType::compound_umbel, "umbels in an umbel"},
    {"panicle", InflorescenceType::panicle, "racemes along an axis"},
    {"dichasium", InflorescenceType::dichasium, "below each flower two branches with a flower each"},
    {"scorpioid", InflorescenceType::scorpioid, "two rows of flowers on the back of a coiled axis"},
    {"capitulum", InflorescenceType::capitulum, "a head of florets, rays at its rim"},
    {"spadix", InflorescenceType::spadix, "florets all over a thick axis; a catkin"}};

namespace {

constexpr Range kAngles{.min = -180, .max = 180};
constexpr Range kFactors{.min = 0.02, .max = 10};

}  // namespace

void describe(Properties& v, MemberSide& s) {
  v.number("length", s.length, kFactors, "Factor of the length");
  v.number("width", s.width, kFactors, "Factor of the width");
  v.angle("open", s.open, kAngles, "In place of the whorl's");
  v.angle("bend", s.bend, {.min = -360, .max = 360}, "In place of the whorl's");
  v.angle("fold", s.fold, {.min = -80, .max = 80}, "In place of the whorl's");
  v.number("cup", s.cup, {.min = -1, .max = 1}, "In place of the whorl's");
  v.list("colors", s.colors, Count{0, 64}, "In place of the whorl's; without any these");
  v.color("second", s.second, "In place of the whorl's");
  v.aspect(Aspect::look, "second");
}

void describe(Properties& v, Marks& m) {
  v.integer("count", m.count, {.min = 1, .max = 200}, "Number on each member");
  v.number("size", m.size, {.min = 0.001, .max = 0.5}, "Diameter, as a share of the flower's size");
  v.number("from", m.from, kShare, "Where along the member they begin, 0 foot to 1 tip");
  v.number("to", m.to, kShare, "Where they end");
  v.number("across", m.across, kShare, "How far from the midrib they lie, as a share of the way to the rim");
  v.color("color", m.color, "Their colour");
  v.boolean("upper", m.upper, "Whether members on the upper side of the median plane have them");
  v.boolean("side", m.side, "Whether those between have them");
  v.boolean("lower", m.lower, "Whether members on its lower side have them");
}

void describe(Properties& v, Spiral& s) {
  v.number("length", s.length, kFactors, "Length of the innermost, as a share of the outermost's");
  v.angle("open", s.open, kAngles, "Angle between the axis and the innermost");
  v.number("rise", s.rise, {.min = -2, .max = 2},
           "How much higher the innermost stands, as a share of the flower's size");
}

void describe(Properties& v, Whorl& w) {
  v.choice("part", w.part, kFloralParts, "What its members are");
  v.required("part");
  v.integer("count", w.count, {.min = 1, .max = 300}, "Number of members");
  v.number("length", w.length, {.min = 0.005, .max = 10},
           "Length of a member, as a share of the flower's size");
  v.number("at", w.at, {.min = -5, .max = 5},
           "Height above the flower's foot, below it where negative, as a share of its size; without it a "
           "little above the whorl before");
  v.number(
      "radius", w.radius, {.min = 0, .max = 5},
      "Distance of members' feet from the axis, as a share of the size; without it the receptacle's there");
  v.angle("open", w.open, kAngles,
          "Angle between the axis and a member's foot when the flower is open; without it as is usual for "
          "the part");
  v.angle("bend", w.bend, {.min = -360, .max = 360},
          "Angle by which a member bends outward from foot to tip");
  v.angle("turn", w.turn, {.min = -360, .max = 360},
          "Angle against the whorl before, of the first whorl against the upper side; without it members "
          "stand between those before");
  v.number("width", w.width, {.min = 0.002, .max = 5},
           "Width as a share of the length: of a blade, a filament or an ovary; without it as is usual for "
           "the part");
  v.number("widest", w.widest, {.min = 0.05, .max = 0.95},
           "Where along a blade it is widest, 0 foot to 1 tip");
  v.number("round", w.round, kShare, "How round a blade ends: 0 drawn out to a tip, 1 round");
  v.number("notch", w.notch, kShare, "Depth of a notch in the tip, as a share of the length");
  v.angle("fold", w.fold, {.min = -80, .max = 80}, "Angle by which a blade is folded along its midrib");
  v.number("cup", w.cup, {.min = -1, .max = 1}, "How much a blade is hollowed like a spoon; below 0 arched");
  v.number("wave", w.wave, {.min = 0, .max = 2}, "How much the rim is waved");
  v.integer("detail", w.detail, {.min = 1, .max = 3}, "How fine blades are");
  v.number("fused", w.fused, kShare,
           "Share of the length that is one tube, as of a bell; of carpels whether they are one ovary, as "
           "they are without it");
  v.curve("tube", w.tube,
          "Radius of the tube as a share of the length, over the share of the way from its foot to its rim; "
          "without it a funnel");
  v.number("slant", w.slant, {.min = -1, .max = 1},
           "How much longer the lower side of the tube is, as a share of the length");
  v.number("head", w.head, {.min = 0, .max = 2},
           "Length of anthers or width of stigmas, as a share of the flower's size");
  v.choice("aestivation", w.aestivation, kAestivations, "How neighbours lie in the bud, and overlap later");
  v.object(
      "spiral", w.spiral,
      "Members stand in a spiral by the golden angle, from the outermost to what this says of the innermost");
  v.object("upper", w.upper,
           "What members within 60 degrees of the upper side of the median plane have otherwise");
  v.object("side", w.side, "What members between have otherwise");
  v.object("lower", w.lower,
           "What members within 60 degrees of its lower side have otherwise: a lip, a keel");
  v.boolean("falls", w.falls, "Whether its members have fallen once the flower has withered");
  v.list(
      "colors", w.colors, Count{0, 64},
      "Colours; the turtle's colour index picks one, round and round; without any as is usual for the part");
  v.color("second", w.second, "Colour of a petal's foot, a sepal's veins, of anthers and of stigmas");
  v.object("luster", w.luster, "How it takes light; without it as is usual for the part");
  v.object("marks", w.marks, "Spots on the upper side of blades");
  v.aspect(Aspect::look, "second", "luster");
}

void describe(Properties& v, Receptacle& r) {
  v.number("radius", r.radius, {.min = 0, .max = 2},
           "Radius, as a share of the flower's size; 0 leaves it out");
  v.number("height", r.height, {.min = 0, .max = 2}, "Height of its dome, as a share of the flower's size");
  v.color("color", r.color, "Its colour");
}

void describe(Properties& v, FloralDiagram& d) {
  v.shorthand("whorls");
  v.list("whorls", d.whorls, Count{1, 24}, "The whorls from outside to inside");
  v.required("whorls");
  v.object("receptacle", d.receptacle, "The end of the stalk, which bears the whorls");
  v.number("bud", d.bud, {.min = 0.02, .max = 2}, "Width of the closed bud, as a share of the flower's size");
  v.integer("stages", d.stages, {.min = 1, .max = 64},
            "Number of steps from the bud to the open flower; half as many follow until it has withered");
  v.color("faded", d.faded, "Colour that petals turn to as they wither");
}

void describe(Properties& v, Inflorescence& i) {
  v.choice("type", i.type, kInflorescenceTypes, "How the flowers are borne");
  v.required("type");
  v.text("flower", i.flower, "Symbol of the organ that each flower is");
  v.required("flower");
  v.text("ray", i.ray, "Symbol of the organ at the rim of a head; without it there is none");
  v.text("bract", i.bract,
         "Symbol of the organ below each flower, or round an umbel or a head; without it there is none");
  v.integer("flowers", i.flowers, {.min = 1, .max = 2000}, "Number of flowers; rays are not counted");
  v.integer("rays", i.rays, {.min = 0, .max = 400}, "Number of rays, where there is a `ray`");
  v.integer("involucre", i.involucre, {.min = 0, .max = 400},
            "Number of bracts round an umbel or a head, where there is a `bract`");
  v.number("bare", i.bare, {.min = 0, .max = 0.98}, "Share of the axis below the lowest flower");
  v.number("pedicel", i.pedicel, metres(0, 10),
           "Length of a flower's stalk; it grows where flowers need room");
  v.angle("angle", i.angle, {.min = 0, .max = 180},
          "Angle between the axis and the oldest flower's stalk, the outermost one's of an umbel, the rays' "
          "of a head");
  v.angle("tip_angle", i.tip_angle, {.min = 0, .max = 180},
          "The same of the youngest, and of the umbels of an umbel; without it 0.4 of it");
  v.angle("divergence", i.divergence, {.min = 0, .max = 360},
          "Angle about the axis from one flower to the next");
  v.integer("whorl", i.whorl, {.min = 1, .max = 40},
            "Number of flowers at each node of the axis: 2 opposite, crosswise to those before");
  v.integer("branches", i.branches, {.min = 1, .max = 200},
            "Number of branches of a panicle or a compound umbel");
  v.number("branch", i.branch, metres(0, 10),
           "Length of the longest branch of a panicle, a compound umbel or a dichasium");
  v.number("width", i.width, metres(0.0001, 10), "Diameter of a head's disc or of a spadix");
  v.number("dome", i.dome, {.min = -0.5, .max = 3}, "Height of a head's disc, as a share of its radius");
  v.number("stem", i.stem, metres(0.00002, 1),
           "Diameter of the axis at its foot, where thickness is from the turtle");
  v.angle("nod", i.nod, {.min = 0, .max = 180},
          "Angle by which open flowers are turned down from their stalks");
  v.number("sided", i.sided, kShare,
           "How much flowers are drawn to one side: 0 all round, 1 all to the side the axis arches to, the "
           "turtle's lower one");
  v.angle("arch", i.arch, {.min = -360, .max = 360}, "Angle by which the axis bends from foot to tip");
  v.angle("jitter", i.jitter, {.min = 0, .max = 90}, "Random tilt of each stalk");
  v.boolean("basipetal", i.basipetal, "Whether the youngest flowers are at the foot or the rim");
  v.curve("stages", i.stages,
          "Stage of a flower by its age, from the youngest 0 to the oldest 1: 0 a bud, 1 open, 2 withered");
  v.number("least", i.least, {.min = 0.02, .max = 1},
           "Size of a closed bud, as a share of the open flower's");
}

Errors diagram_faults(const FloralDiagram& diagram) {
  Errors errors;
  for (std::size_t i = 0; i < diagram.whorls.size(); ++i) {
    const Whorl& w = diagram.whorls[i];
    bool blades = w.part != FloralPart::stamens && w.part != FloralPart::carpels;
    auto fault = [&](const char* name, const char* what) {
      errors.push_back({fmt::format("/whorls/{}/{}", i, name), what});
    };
    if (w.spiral && w.fused.value_or(0) > 0 && blades)
      fault("fused", "found with spiral; members of a spiral are free");
    if (w.spiral && w.bilateral())
      fault("spiral", "found with upper, side or lower; a spiral has no median plane");
    if (w.tube && !(w.fused.value_or(0) > 0)) fault("tube", "needs fused above 0");
    if (w.marks && !blades) fault("marks", "is for sepals, tepals and petals");
    if (w.marks && w.marks->from > w.marks->to) fault("marks/from", "lies beyond to; expected at most that");
    if (!blades && w.bilateral())
      fault(w.upper ? "upper" : w.side ? "side" : "lower", "is for sepals, tepals and petals");
    if (blades && w.head) fault("head", "is for stamens and carpels");
  }
  constexpr double kTriangles = 240, kOfMark = 6;  // of a member, about
  constexpr double kMost = 5e6;
  double triangles = 0;
  for (const Whorl& w : diagram.whorls)
    triangles += w.count * (kTriangles + kOfMark * (w.marks ? w.marks->count : 0));
  if (triangles *= diagram.stages * 1.5; triangles > kMost)
    errors.push_back(
        {"/whorls",
         fmt::format("have some {:.0f} triangles at all stages; expected at most {:.0f}", triangles, kMost)});
  return errors;
}

}  // namespace frond
