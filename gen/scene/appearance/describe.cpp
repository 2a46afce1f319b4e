#include "appearance/describe.h"

#include "core/assets.h"
#include "preset/eases.h"

namespace frond {

namespace {

constexpr Choice<SkinKind> kSkinKinds[] = {
    {"stony", SkinKind::stony, "raised cups with a pit in each, as on stony corals"},
    {"fan", SkinKind::fan, "fine and matt, as on sea fans and whips"},
    {"soft", SkinKind::soft, "furry with open polyps, as on soft corals"}};

constexpr Choice<BarkKind> kBarks[] = {{"bark", BarkKind::bark, "furrowed along the branch"},
                                       {"birch", BarkKind::birch, "smooth with dark bands"},
                                       {"stem", BarkKind::stem, "green stems of herbs"},
                                       {"ink", BarkKind::ink, "one matt colour"},
                                       {"metal", BarkKind::metal, "polished wire"},
                                       {"wax", BarkKind::wax, "smooth with soft highlights"},
                                       {"palm", BarkKind::palm, "rings across, the scars of leaves"}};

constexpr Choice<Tissue> kBladeTissues[] = {{"leaf", Tissue::leaf, "with veins"},
                                            {"petal", Tissue::petal, "without"}};

constexpr Choice<GirthFrom> kGirths[] = {
    {"turtle", GirthFrom::turtle, "the turtle's widths, as diameters"},
    {"distance", GirthFrom::distance, "the way from a place to the farthest tip above it, through the curve"},
    {"pipe", GirthFrom::pipe,
     "what a branch carries: its radius to the power n is the sum of those it parts into"}};

constexpr Choice<BarkPattern> kBarkPatterns[] = {
    {"furrowed", BarkPattern::furrowed, "long ridges, as on oaks"},
    {"plated", BarkPattern::plated, "plates between cracks, as on pines"},
    {"smooth", BarkPattern::smooth, "folds and short scars, as on beeches"},
    {"banded", BarkPattern::banded, "papery with dark bands, as on birches"}};

constexpr std::string_view kSeasonTimes = "winter is 0, spring 0.25, summer 0.5, autumn 0.8";

}  // namespace

void describe(Properties& v, Polyps& p) {
  v.aspect(Aspect::look);
  v.number("glow", p.glow, {.min = 0, .max = 3}, "How brightly it fluoresces, as corals do in blue light");
  v.number("polyps", p.width, {.min = 0, .max = 0.2, .unit = "m"},
           "Width over which a polyp spreads its tentacles; 0 leaves them in their cups");
  v.animated(
      "open", p.open, {.min = 0, .max = 1},
      "How far polyps are open: 0 drawn in, 1 spread; keyframes open and close them. Needs polyps above 0");
}

void describe(Properties& v, Pores& p) {
  v.aspect(Aspect::look);
  v.number("cell", p.cell, {.min = 0.0005, .max = 1, .unit = "m"}, "Distance from one pore to the next");
  v.number("warp", p.warp, {.min = 0, .max = 1}, "How far the cells are warped out of their regular pattern");
  v.number("depth", p.depth, {.min = 0, .max = 3}, "How deep the pores look; 0 is smooth");
}

void describe(Properties& v, Tint& t) {
  v.aspect(Aspect::look);
  v.color("base", t.base, "Colour of the skin");
  v.color("secondary", t.secondary, "Colour in the pores and grooves");
  describe(v, t.course);
  v.number("variation", t.variation, {.min = 0, .max = 0.9},
           "How much single corals differ in brightness, as a share");
  v.number("young", t.young, {.min = 0, .max = 1}, "How much paler growing tips are; 0 as the rest");
  v.number("young_length", t.young_length, {.min = 0, .max = 10, .unit = "m"},
           "Length below a growing tip over which the paleness fades");
}

void describe(Properties& v, Skin& s) {
  v.aspect(Aspect::look);
  v.choice("kind", s.kind, kSkinKinds, "What the skin is made of");
  v.object("pores", s.pores, "The pores in the skin");
  v.object("tint", s.tint, "The colours of the skin");
  describe(v, s.polyps);
}

void describe(Properties& v, Growth& g) {
  v.aspect(Aspect::motion);
  v.number("start", g.start, {.min = -1e6, .max = 1e6, .unit = "s"},
           "Time in the film at which growth begins");
  v.number("duration", g.duration, {.min = 0, .max = 1e6, .unit = "s"},
           "How long growth takes; 0 is fully grown from the first frame");
  v.boolean("to_end", g.to_end, "Whether growth ends with the film, instead of after `duration`");
  v.choice(
      "ease", g.ease, kEases,
      "How growth begins and ends, of what does not grow year by year; not given: fast in youth, slow in "
      "age");
  v.number("stagger", g.stagger, {.min = 0, .max = 1e6, .unit = "s"},
           "Each organism begins to grow up to so much later than the first, at random");
  v.number(
      "rate", g.rate, {.min = 0, .max = 1000, .unit = "cm a year"},
      "By how much it becomes longer in a year, in the mean: branches from their foot, bodies in height or "
      "radius, whichever is more. With years_a_second; how long it grows follows from its size then, and "
      "not from duration");
  v.number("years_a_second", g.years_a_second, {.min = 0, .max = 10000, .unit = "years"},
           "Years that pass in a second of the film: for rate, and for trees, which have years of their own");
  v.number("ripen", g.ripen, {.min = 0.01, .max = 2},
           "Share of the growth that a place takes from its first appearance to its full thickness");
  // That of one metre, until the size is known.
  if (g.by_rate()) g.duration = paced(g, 1).duration, g.ease = g.ease.value_or(Ease::none);
}

void describe(Properties& v, Wave& w) {
  v.aspect(Aspect::motion);
  v.angle("amplitude", w.amplitude, {.min = 0, .max = 120}, "Angle by which the tips are bent at most");
  v.number("speed", w.speed, {.min = 0, .max = 20, .unit = "1/s"},
           "Number of swings in a second; with loop it is rounded so that the film closes");
  v.angle("phase", w.phase, {.min = -360, .max = 360},
          "Where in its swing the motion begins; each organism adds a random part");
  v.number("length", w.length, {.min = 0.01, .max = 1000, .unit = "m"},
           "Distance from crest to crest along the current or the wind");
  v.direction("direction", w.direction, Across::xz,
              "Direction in which the current or the wind moves; only x and z count");
  v.boolean("loop", w.loop,
            "Whether the film holds whole swings only, so that it can be repeated without a jump");
}

void describe(Properties& v, FoodPlace& f) {
  v.animated("position", f.position, {.min = -1000, .max = 1000, .unit = "m"},
             "Where it is; with keyframes it moves");
  v.required("position");
}

void describe(Properties& v, Food& f) {
  v.aspect(Aspect::motion);
  v.angle("strength", f.strength, {.min = 0, .max = 180},
          "Angle by which a whole branch may bend toward the food, about");
  v.number("stretch", f.stretch, {.min = 0, .max = 3},
           "Share of its length by which a tip beside the food lengthens toward it; the rest of the colony "
           "lengthens less, and what is longer is thinner");
  v.number("reach", f.reach, {.min = 0.02, .max = 100, .unit = "m"},
           "Distance within which the pull is weaker, so that branches do not fold up at the food");
  v.animated("position", f.position, {.min = -1000, .max = 1000, .unit = "m"},
             "Where the food is; with keyframes it moves");
  v.list("others", f.others, Count{0, 32}, "More food; each part of a branch bends most to what is nearest");
  v.boolean("eaten", f.eaten,
            "Whether food that a tip has reached is eaten up; who shares a place shares it");
}

void describe(Properties& v, Girth& g) {
  v.choice("from", g.from, kGirths, "What the thickness of branches follows from");
  v.number("radius", g.radius, {.min = 0, .max = 100, .unit = "m"},
           "Radius at the base; 0 leaves it as the turtle draws it");
  v.number("exponent", g.exponent, {.min = 1, .max = 4},
           "Exponent n of the pipe model; the smaller, the thinner twigs are beside the trunk. Needs "
           "\"from\": \"pipe\"");
  v.curve("curve", g.curve,
          "Share of the radius by the way to the farthest tip, from 0 at a tip to 1 at the base. Needs "
          "\"from\": \"distance\"");
  v.number("least", g.least, {.min = 0.00001, .max = 1, .unit = "m"}, "Radius that no branch falls below");
  v.number("flare", g.flare, {.min = 0, .max = 4},
           "How much wider the foot is than the stem above it, as a share");
}

void describe(Properties& v, Bark& b) {
  v.aspect(Aspect::look);
  v.choice("kind", b.kind, kBarks, "What the surface of branches is made of");
  v.list("colors", b.colors, Count{1, 64},
         "Colours of the surface; the turtle's colour index picks one, round and round");
  v.color("second", b.second, "Colour in the furrows and bands");
  v.number("scale", b.scale, {.min = 0.0005, .max = 10, .unit = "m"},
           "Width of a furrow or the distance between bands");
  v.number("depth", b.depth, {.min = 0, .max = 3}, "Depth of the relief; 0 is smooth");
  v.color("young", b.young, "Colour of young shoots");
  v.number("young_length", b.young_length, {.min = 0, .max = 10, .unit = "m"},
           "Length below a tip over which a green shoot turns into wood; 0 leaves all of one colour");
  v.number("variation", b.variation, {.min = 0, .max = 0.9},
           "How much single plants differ in brightness, as a share");
}

void describe(Properties& v, BarkChange& b) {
  v.aspect(Aspect::look);
  v.choice("kind", b.kind, kBarks,
           "What the branch is made of; where the plant wears a picture of bark, the branch wears none then, "
           "unless pattern is given");
  v.color("color", b.color, "Colour of the surface, of the ridges of a picture, and of young shoots");
  v.color("second", b.second, "Colour in the furrows and bands");
  v.choice("pattern", b.pattern, kBarkPatterns,
           "Pattern of the branch's picture, where the plant wears one, see coat");
  v.number("lichens", b.lichens, {.min = 0, .max = 1}, "Share of the bark that lichens cover");
}

void describe(Properties& v, BladeLook& b) {
  v.aspect(Aspect::look);
  v.list("colors", b.colors, Count{1, 64},
         "Colours of the filled outlines; the turtle's colour index picks one, round and round");
  v.color("second", b.second, "Colour of the veins");
  v.choice("tissue", b.tissue, kBladeTissues, "What the filled outlines are made of");
}

void describe(Properties& v, BarkImage& b) {
  v.choice("pattern", b.pattern, kBarkPatterns, "Pattern of the bark's picture");
  v.color("color", b.color, "Colour on the ridges");
  v.color("second", b.second, "Colour in furrows, cracks and bands");
  v.color("lichen", b.lichen, "Colour of the lichens");
  v.number("lichens", b.lichens, {.min = 0, .max = 1}, "Share of the bark that lichens cover");
  v.integer("ridges", b.ridges, {.min = 1, .max = 200}, "Number of ridges round the picture");
  v.number("stretch", b.stretch, {.min = 0.5, .max = 40},
           "How many times longer than wide the features of the bark are");
  v.number("warp", b.warp, {.min = 0, .max = 3}, "How far the ridges wander");
  v.number("depth", b.depth, {.min = 0, .max = 1}, "Depth of the furrows in the picture; 0 is flat");
  v.number("knots", b.knots, {.min = 0, .max = 60},
           "Number of scars of fallen branches, with rings and a collar, on a square as wide as the picture");
  v.number("lenticels", b.lenticels, {.min = 0, .max = 1},
           "Share of the places for pores across the bark, as on cherries, that have one");
}

void describe(Properties& v, BarkCoat& c) {
  v.aspect(Aspect::look);
  describe(v, c.image);
  v.number("wrap", c.wrap, {.min = 0.001, .max = 20, .unit = "m"},
           "Length round a branch that one width of the picture covers");
  v.number("aspect", c.aspect, {.min = 0.25, .max = 16}, "How many times longer than wide the picture is");
  v.integer("pixels", c.pixels, {.min = 16, .max = 8192}, "Width of the picture");
  v.number(
      "tall", c.tall, {.min = 0.01, .max = 50, .unit = "m"},
      "Height of the piece of bark that the photograph shows; wrap and aspect follow from it. Needs photo");
  v.file(
      "photo", c.photo, [&](const NamedFile& file) { return load_bark_photo(file, c); },
      "A photograph of bark (PNG, JPEG or WebP), upright as it stands on the trunk, instead of the pattern "
      "and its "
      "colours; it "
      "is made to repeat without seams, and dark places are furrows");
  v.number("relief", c.relief, {.min = 0, .max = 10},
           "Height of the bumps that the picture raises on the bark; 0 is smooth");
  v.number("furrow", c.furrow, {.min = 0, .max = 2},
           "Depth of the furrows that are cut into the branches where the camera is near, as a share of a "
           "ridge's width; 0 leaves all to the bumps");
  v.number("facet", c.facet, {.min = 0.0005, .max = 10, .unit = "m"},
           "Width of one side of the branches' mesh, about; less is rounder");
  v.number("moss", c.moss, {.min = 0, .max = 1}, "How much moss grows on it, most at the foot");
  v.number("moss_height", c.moss_height, {.min = 0.01, .max = 100, .unit = "m"},
           "Height above its foot to which that comes up");
  v.color("tone", c.tone,
          "Colour that a tint of copies is reckoned for; all of the bark changes as this colour does");
  v.number("twigs", c.twigs, {.min = 0, .max = 10, .unit = "m"},
           "Branches that begin with a smaller radius than this wear the plain bark instead");
}

void describe(Properties& v, Blossom& b) {
  v.number("share", b.share, {.min = 0, .max = 1}, "Share of the leaves' places that bear flowers");
  v.integer("cluster", b.cluster, {.min = 1, .max = 40}, "Number of flowers at one place");
  v.number("size", b.size, {.min = 0.0005, .max = 2, .unit = "m"}, "Width of a flower");
  v.integer("petals", b.petals, {.min = 1, .max = 60}, "Number of petals of a flower");
  v.color("color", b.color, "Colour of the petals");
  v.color("heart", b.heart, "Colour of the flower's heart");
  v.number("at", b.at, {.min = 0, .max = 1, .unit = "years"}, "Time of the year at which the flowers open");
  v.number("lasts", b.lasts, {.min = 0, .max = 0.6, .unit = "years"},
           "How long a flower stands until its petals fall");
  v.aspect(Aspect::look, "petals", "color", "heart");
}

void describe(Properties& v, Flowering& f) {
  v.number("at", f.at, {.min = 0, .max = 1, .unit = "years"},
           "Time of the year at which the flowers of the plant itself open");
  v.number("lasts", f.lasts, {.min = 0.001, .max = 0.9, .unit = "years"}, "How long these flowers last");
}

void describe(Properties& v, Seasons& s) {
  v.shorthand("at");
  v.animated("at", s.at, {.min = -1000, .max = 1000, .unit = "years", .sense = kSeasonTimes},
             "Time of the year, or keyframes of it: 0 new year, 0.25 spring, 0.5 midsummer, 0.8 autumn, 1.5 "
             "the next summer");
  v.number("opening", s.opening, {.min = 0, .max = 1, .unit = "years"},
           "Time of the year at which leaves unfold");
  v.number("turning", s.turning, {.min = 0, .max = 1, .unit = "years"},
           "Time of the year at which leaves begin to change colour");
  v.number("fall", s.fall, {.min = 0, .max = 1, .unit = "years"}, "Time of the year at which leaves fall");
  v.number("spread", s.spread, {.min = 0, .max = 0.3, .unit = "years"},
           "Time from the first leaf to the last, in opening, turning and falling");
  v.number("drift", s.drift, {.min = 0.0001, .max = 0.2, .unit = "years"},
           "How long a falling leaf is in the air");
  v.number("litter", s.litter, {.min = 0, .max = 1},
           "Share of the fallen leaves that lie on the ground until spring");
  v.boolean("evergreen", s.evergreen, "Whether the leaves stay as they are all year");
  v.color("young", s.young, "Colour of leaves that are just unfolding");
  v.list("autumn", s.autumn, Count{1, 16},
         "Colours that leaves go through in autumn; some stop at the first, others reach the last");
  v.object("blossom", s.blossom, "Flowers where leaves stand; without it there are none");
  v.object("fruit", s.fruit, "Fruit where leaves stand; without it there is none");
  v.object("flowering", s.flowering,
           "When the flowers and fruits of the plant itself are there; without it they stay all year");
  v.aspect(Aspect::look, "young", "autumn");
}

void describe(Properties& v, TreeAppearance& d) {
  v.object("bark", d.bark, "The plain surface of branches, of twigs in any case");
  v.object("coat", d.coat, "A picture of bark on the trunk and the larger branches, which are meshes then");
  v.object("leaves", d.leaves, "The leaves");
  v.object("season", d.season, "The course of the year for its leaves; without it they stay as they are");
  v.object("wave", d.wave, "Swaying in the wind");
  v.object("growth", d.growth, "When it grows in the film");
}

}  // namespace frond
