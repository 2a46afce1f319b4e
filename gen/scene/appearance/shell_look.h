#pragma once

#include "appearance/leaf_look.h"
#include "preset/describe.h"

namespace frond {

enum class ShellPattern { plain, bands, lines, stripes, axial, zigzag, tents, spots };

/// Colours and pattern of a shell.
struct ShellLook {
  Color color{0.93f, 0.87f, 0.76f};   ///< of the ground
  Color second{0.52f, 0.30f, 0.16f};  ///< of the pattern
  Color inside{0.97f, 0.90f, 0.85f};
  Color lip{0.96f, 0.90f, 0.82f};
  ShellPattern pattern = ShellPattern::plain;
  int count = 6;              ///< of bands, or of lines per whorl or valve
  double width = 0.4;         ///< of bands and lines, as a share of their spacing
  double from = 0, to = 1;    ///< part of the growth that has the pattern
  double mottle = 0.3;        ///< unevenness of the colours, in growth bands and clouds
  double gloss = 0.6;         ///< 0 matt .. 1 porcelain
  double growth_lines = 0.3;  ///< visibility of fine growth lines
  double variation = 0.08;    ///< variation of brightness between individuals
  int cells = 384;            ///< along the growing edge; more give a finer reaction
  int seed = 1;               ///< of the pattern
};

void describe(Properties& v, ShellLook& l);

/// The mantle of a giant clam.
struct MantleLook {
  Color color{0.05f, 0.22f, 0.42f};
  Color second{0.10f, 0.62f, 0.60f};  ///< of its spots
  Color rim{0.35f, 0.85f, 0.90f};     ///< of the dots along its edge
  double spots = 0.5;                 ///< how many there are, 0..1
  double glow = 0.15;
};

void describe(Properties& v, MantleLook& m);

/// Share of the picture's width that shows the outside; the rest shows the inside.
inline constexpr float kShellOutside = 0.92f;
inline constexpr float kShellInside = 0.97f;

/// The picture of a shell with that number of growth lines per cell of its edge, and of whorls.
Drawing shell_drawing(const ShellLook& look, double lines_a_cell, double whorls);
/// The picture of a mantle: x along the valves, y from one margin to the other.
Drawing mantle_drawing(const MantleLook& look);

}  // namespace frond
