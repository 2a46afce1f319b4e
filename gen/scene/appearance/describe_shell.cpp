#include "appearance/describe_shell.h"

namespace frond {

namespace {

constexpr Choice<ShellPattern> kShellPatterns[] = {
    {"plain", ShellPattern::plain, "nothing but growth bands"},
    {"bands", ShellPattern::bands, "bands along growth, which run round the whorls"},
    {"lines", ShellPattern::lines, "lines along the edge, across the whorls"},
    {"stripes", ShellPattern::stripes, "by reaction, at rest: uneven stripes along growth"},
    {"axial", ShellPattern::axial, "by reaction, all firing together: uneven lines along the edge"},
    {"zigzag", ShellPattern::zigzag, "by reaction, waves that meet: oblique lines, as on olives"},
    {"tents", ShellPattern::tents, "by reaction, waves that fade slowly: triangles, as on cones"},
    {"spots", ShellPattern::spots, "by reaction, firing here and there"}};

}  // namespace

void describe(Properties& v, ShellLook& l) {
  v.aspect(Aspect::look);
  v.color("color", l.color, "Colour of the ground");
  v.color("second", l.second, "Colour of the pattern");
  v.color("inside", l.inside, "Colour of the inside");
  v.color("lip", l.lip, "Colour of the inside near the lip");
  v.choice("pattern", l.pattern, kShellPatterns, "What the edge has painted as it grew");
  v.integer("count", l.count, {.min = 1, .max = 200}, "Number of bands, or of lines on a whorl or valve");
  v.number("width", l.width, {.min = 0.02, .max = 1},
           "Width of bands and lines, as a share of their distance");
  v.number("from", l.from, {.min = 0, .max = 1}, "Share of the growth at which the pattern begins");
  v.number("to", l.to, {.min = 0, .max = 1}, "Share of the growth at which the pattern ends");
  v.number("mottle", l.mottle, {.min = 0, .max = 1}, "How uneven the colours are");
  v.number("gloss", l.gloss, {.min = 0, .max = 1}, "How glossy it is: 0 chalky, 1 porcelain");
  v.number("growth_lines", l.growth_lines, {.min = 0, .max = 1}, "How much fine growth lines show");
  v.number("variation", l.variation, {.min = 0, .max = 0.5},
           "How much single ones differ in brightness, as a share");
  v.integer("cells", l.cells, {.min = 32, .max = 2048},
            "Cells of the growing edge, and pixels of the picture across; more make a finer reaction");
  v.integer("seed", l.seed, {.min = 0, .max = 1e9}, "Seed of the pattern");
}

void describe(Properties& v, MantleLook& m) {
  v.aspect(Aspect::look);
  v.color("color", m.color, "Colour of the tissue");
  v.color("second", m.second, "Colour of its spots");
  v.color("rim", m.rim, "Colour of the dots along its edge");
  v.number("spots", m.spots, {.min = 0, .max = 1}, "How much of it is spotted");
  v.number("glow", m.glow, {.min = 0, .max = 3}, "How brightly it shines by itself");
}

}  // namespace frond
