#include "appearance/shell_look.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "appearance/describe_shell.h"
#include "appearance/shell_pigment.h"
#include "core/content.h"
#include "core/linear.h"
#include "core/noise.h"
#include "images/raster.h"
#include "preset/keys.h"

namespace frond {

namespace {

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

PigmentRegime regime_of(ShellPattern pattern) {
  switch (pattern) {
    case ShellPattern::stripes:
      return PigmentRegime::stripes;
    case ShellPattern::axial:
      return PigmentRegime::lines;
    case ShellPattern::tents:
      return PigmentRegime::tents;
    case ShellPattern::spots:
      return PigmentRegime::spots;
    default:
      return PigmentRegime::zigzag;
  }
}

bool reacts(ShellPattern pattern) { return pattern >= ShellPattern::stripes; }

int lines_of(const ShellLook& look, double lines_a_cell) {
  return std::clamp(static_cast<int>(std::lround(lines_a_cell * look.cells)), kLeastLines, kMostLines);
}

Raster shell_picture(const ShellLook& look, double lines_a_cell, double whorls) {
  int wide = look.cells, high = lines_of(look, lines_a_cell);
  Seed seed{static_cast<std::uint64_t>(look.seed)};
  Grid made;
  if (reacts(look.pattern)) made = pigment(regime_of(look.pattern), wide, high, seed.child("pigment"));
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

template <class Draw>
Drawing drawing_of(std::string_view what, const Keys& keys, double pixels, double seconds, Draw draw) {
  std::string name = fmt::format("{}_{}.png", what, made_id(keys.all()));
  return {{name},
          [name, draw]() -> Result<std::vector<Picture>> {
            Result<std::string> bytes = png_text(draw());
            if (!bytes) return bytes.errors();
            return std::vector<Picture>{{name, std::move(*bytes)}};
          },
          pixels,
          seconds};
}

}  // namespace

Drawing shell_drawing(const ShellLook& look, double lines_a_cell, double whorls) {
  double pixels = 1.0 * look.cells / kShellOutside * lines_of(look, lines_a_cell);
  return drawing_of("shell", keys_of(look, lines_a_cell, whorls), pixels, kSecondsAPixel * pixels,
                    [=] { return shell_picture(look, lines_a_cell, whorls); });
}

Drawing mantle_drawing(const MantleLook& look) {
  return drawing_of("mantle", keys_of(look), kMantleWide * kMantleHigh,
                    kSecondsAPixel * kMantleWide * kMantleHigh, [=] { return mantle_picture(look); });
}

}  // namespace frond
