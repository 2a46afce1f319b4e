#include "appearance/shell_look.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "appearance/shell_pigment.h"
#include "core/content.h"
#include "core/linear.h"
#include "core/noise.h"
#include "preset/keys.h"

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

constexpr int kLeastLines = 64, kMostLines = 4096;  // of a picture
constexpr double kSecondsAPixel = 1e-6;
constexpr int kMantleWide = 1024, kMantleHigh = 320;
// Marks and tones of both pictures are by eye.

void set(Raster& picture, int x, int y, Vec3 light) {
  for (int c = 0; c < 3; ++c)
    picture.data[picture.index(x, y, c)] = to_byte(encoded(std::clamp(light[c], 0.0f, 1.0f)));
}

/// A place on a shell as noise sees it: round its edge without a seam, and along its growth.
Vec3 on_tube(double around, double along, double often) {
  return Vec3(std::cos(2 * kPi * around) * often / (2 * kPi), along,
              std::sin(2 * kPi * around) * often / (2 * kPi));
}

/// A mark of a share of each period, soft at its edges: 1 in its middle.
double mark(double phase, double width) {
  constexpr double kSoft = 0.06;  // half of an edge
  double off = std::abs(phase - std::round(phase));
  return 1 - smooth_step(0.5 * width - kSoft, 0.5 * width + kSoft, off);
}

bool reacts(ShellPattern pattern) { return pattern >= ShellPattern::stripes; }

int lines_of(const ShellLook& look, double lines_a_cell) {
  return std::clamp(static_cast<int>(std::lround(lines_a_cell * look.cells)), kLeastLines, kMostLines);
}

Raster shell_picture(const ShellLook& look, double lines_a_cell, double whorls) {
  int wide = look.cells, high = lines_of(look, lines_a_cell);
  Seed seed{static_cast<std::uint64_t>(look.seed)};
  Grid made;
  if (reacts(look.pattern)) made = pigment(look.pattern, wide, high, seed.child("pigment"));
  Vec3 ground = linear(look.color), second = linear(look.second), inside = linear(look.inside),
       lip = linear(look.lip);
  int outside = static_cast<int>(std::lround(wide / static_cast<double>(kShellOutside)));
  Raster picture(outside, high, 3);
  constexpr double kFade = 0.06;  // of the growth, at both ends of a pattern
  constexpr double kSeasons = 26, kCoarseLines = 60, kFineLines = 150;  // on a whorl
  constexpr double kLip = 0.1;                                          // of the last whorl
  double often = 9, long_often = often * lines_a_cell;                  // clouds round the shell and along it
  for (int y = 0; y < high; ++y) {
    double along = 1 - (y + 0.5) / high;
    double there =
        smooth_step(look.from - kFade, look.from, along) * (1 - smooth_step(look.to, look.to + kFade, along));
    if (look.to >= 1) there = smooth_step(look.from - kFade, look.from, along);
    double turns = along * std::max(1.0, whorls);
    double season = fractal_noise(Vec3(3.7f, static_cast<float>(kSeasons * turns), 1.1f), 3);
    double line = noise(Vec3(static_cast<float>(kFineLines * turns), 0.4f, 8.2f)) +
                  0.6 * noise(Vec3(static_cast<float>(kCoarseLines * turns), 5.4f, 1.2f));
    for (int x = 0; x < wide; ++x) {
      double around = (x + 0.5) / wide;
      Vec3 at = on_tube(around, long_often * along, often);
      double cloud = fractal_noise(at, 3), bent = 0.25 * cloud;
      double share = 0;
      if (look.pattern == ShellPattern::bands) share = mark(around * look.count + 0.12 * bent, look.width);
      if (look.pattern == ShellPattern::lines) share = mark(turns * look.count + 0.8 * bent, look.width);
      if (reacts(look.pattern)) share = made.at(x, y);
      double tone = 1 + look.mottle * (0.22 * season + 0.14 * cloud) + 0.3 * look.growth_lines * line;
      Vec3 color = glm::mix(ground, second, static_cast<float>(std::clamp(share * there, 0.0, 1.0)));
      set(picture, x, y, glm::pow(color, Vec3(static_cast<float>(2 - std::clamp(tone, 0.3, 1.6)))));
    }
    double near = smooth_step(1 - kLip / std::max(1.0, whorls), 1.0, along);
    for (int x = wide; x < outside; ++x) set(picture, x, y, glm::mix(inside, lip, static_cast<float>(near)));
  }
  return picture;
}

Raster mantle_picture(const MantleLook& look) {
  constexpr double kLength = 14;                      // of the mantle, by half its width
  constexpr double kDots = 5.5;                       // of the row, on half the width
  constexpr double kDotsAt = 0.84, kDotsWide = 0.42;  // on the way to the edge; their length by their width
  Raster picture(kMantleWide, kMantleHigh, 3);
  Vec3 ground = linear(look.color), spot = linear(look.second), rim = linear(look.rim);
  for (int y = 0; y < kMantleHigh; ++y)
    for (int x = 0; x < kMantleWide; ++x) {
      double along = kLength * (x + 0.5) / kMantleWide, across = 2 * (y + 0.5) / kMantleHigh - 1,
             edge = std::abs(across);
      auto at = [&](double often, double more) {
        return Vec3(static_cast<float>(along * often), static_cast<float>(across * 2.2 * often),
                    static_cast<float>(more));
      };
      double cloud = fractal_noise(at(1.1, 0), 3),
             streak = noise(Vec3(static_cast<float>(along * 3.2), static_cast<float>(across * 1.2), 7));
      // Pale spots crowd toward the edge, in rows that run inward.
      double spots = fractal_noise(at(4.6, 3), 2) + 0.4 * streak;
      double level = 1.15 - 1.1 * look.spots - 0.35 * edge;
      double pale = smooth_step(level, level + 0.22, spots);
      Vec3 color = ground * static_cast<float>(std::exp(0.5 * cloud + 0.25 * streak));
      color = glm::mix(color, ground * 0.35f, static_cast<float>(1 - smooth_step(0.03, 0.16, edge)));
      color = glm::mix(color, spot, static_cast<float>(0.85 * pale * smooth_step(0.1, 0.3, edge)));
      // A row of bright dots behind the edge, and a bright line on it.
      double cell = along * kDots + 0.4 * noise(at(2, 9)), off = std::abs(cell - std::round(cell)) / kDots;
      double dot = 1 - smooth_step(0.030, 0.050, std::hypot(off, (edge - kDotsAt) * kDotsWide));
      double line = smooth_step(0.93, 0.96, edge) * (0.55 + 0.45 * noise(at(3, 5)));
      color = glm::mix(
          color, ground * 0.3f,
          static_cast<float>(0.8 * smooth_step(0.70, 0.78, edge) * (1 - smooth_step(0.92, 0.95, edge))));
      color = glm::mix(color, rim, static_cast<float>(std::clamp(std::max(dot, line), 0.0, 1.0)));
      set(picture, x, y, color);
    }
  return picture;
}

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

Drawing shell_drawing(const ShellLook& look, double lines_a_cell, double whorls) {
  double pixels = 1.0 * look.cells / kShellOutside * lines_of(look, lines_a_cell);
  std::string name = fmt::format("shell_{}.png", made_id(keys_of(look, lines_a_cell, whorls).all()));
  return drawing_of(std::move(name), pixels, kSecondsAPixel,
                    [=] { return shell_picture(look, lines_a_cell, whorls); });
}

Drawing mantle_drawing(const MantleLook& look) {
  return drawing_of(fmt::format("mantle_{}.png", made_id(keys_of(look).all())), kMantleWide * kMantleHigh,
                    kSecondsAPixel, [=] { return mantle_picture(look); });
}

}  // namespace frond
