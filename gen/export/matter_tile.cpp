#include <algorithm>
#include <cmath>

#include "export/pattern.h"
#include "export/tile.h"

namespace frond {

namespace {

/// A material as its painters see it: colours as light.
struct Painted {
  DVec3 c, s;
  double relief, moss;
  Pattern p;
};

/// Soot and green that damp leaves on masonry.
DVec3 weathered(const Painted& m, double u, double v, const DVec3& clean) {
  double damp = m.moss * std::max(0.0, 1.4 * m.p.bozo(u, v, 3, 90) - 0.35);
  DVec3 soot = m.c * 0.5, algae = m.c * DVec3(0.42, 0.46, 0.30);
  return ramp(damp, {{0.10, clean}, {0.42, clean * 0.67 + soot * 0.33}, {0.75, soot}, {1, algae}});
}

Dab brick(const Painted& m, double u, double v) {
  double g = m.p.granite(u, v, 8, 1), patch = m.p.bozo(u, v, 2, 2);
  DVec3 clay = ramp(g, {{0.10, m.c * 0.52},
                        {0.30, m.c * 0.86},
                        {0.55, m.c},
                        {0.78, m.c * 1.14},
                        {0.95, m.c * 0.6 + m.s * 0.5}});
  DVec3 scorched = ramp(g, {{0.2, m.c * DVec3(0.42, 0.40, 0.46)}, {0.7, m.c * DVec3(0.80, 0.74, 0.76)}});
  DVec3 salts = ramp(g, {{0.2, m.c * 0.8 + m.s * 0.15}, {0.6, m.c * 0.62 + m.s * 0.42}});
  return {weathered(m, u, v, ramp(patch, {{0.18, scorched}, {0.36, clay}, {0.66, clay}, {0.88, salts}})), g};
}

Dab mortar(const Painted& m, double u, double v) {
  double g = m.p.granite(u, v, 16, 1);
  return {weathered(m, u, v, ramp(g, {{0.15, m.s}, {0.45, m.c * 0.85}, {0.8, m.c}, {1, m.c * 1.12}})), g};
}

Dab limestone(const Painted& m, double u, double v) {
  double g = m.p.granite(u, v, 10, 1), patch = m.p.bozo(u, v, 3, 2);
  DVec3 grain = ramp(g, {{0.12, m.c * 0.76}, {0.35, m.c * 0.94}, {0.65, m.c}, {0.9, m.c * 1.06}});
  DVec3 stain = ramp(g, {{0.2, m.s * 0.8 + m.c * 0.2}, {0.8, m.s * 0.45 + m.c * 0.5}});
  return {weathered(m, u, v, ramp(patch, {{0.22, (grain + stain) * 0.5}, {0.42, grain}})), g};
}

Dab plaster(const Painted& m, double u, double v) {
  double g = m.p.granite(u, v, 24, 1), flaked = 0.5 + 0.5 * m.p.fractal(u, v, 4, 5, 2),
         edge = 0.20 + 0.22 * m.moss;
  DVec3 lime = ramp(g, {{0.2, m.c * 0.90}, {0.6, m.c}, {0.9, m.c * 1.04}});
  DVec3 below = ramp(g, {{0.2, m.s * 0.7}, {0.7, m.s * 1.1}});
  DVec3 color = ramp(
      flaked, {{edge, below}, {edge + 0.006, m.c * 0.35}, {edge + 0.018, m.c * 0.8}, {edge + 0.03, lime}});
  return {weathered(m, u, v, color), (flaked > edge ? 0.7 : 0.3) + 0.2 * g};
}

Dab paint(const Painted& m, double u, double v) {
  double n = 0.5 + 0.5 * m.p.drawn_out(u, v, 16, 8, 5, 1), peel = 0.30 * m.moss;
  DVec3 color = ramp(
      n,
      {{0, m.s * 0.6}, {peel - 0.01, m.s}, {peel + 0.015, m.c * 0.82}, {peel + 0.10, m.c * 0.95}, {1, m.c}});
  return {color, smooth_step(peel, peel + 0.05, n) * 0.5 + 0.2 * n};
}

/// Boards, sawn along u.
Dab timber(const Painted& m, double u, double v) {
  double wander = 0.35 * m.p.drawn_out(u, v, 2, 6, 3, 1);
  double ring = v * 12 + wander * 4, late = std::pow(ring - std::floor(ring), 3);
  double fibre = m.p.drawn_out(u, v, 6, 96, 4, 2);
  double crack = m.relief * (1 - smooth_step(0.0, 0.03, std::abs(m.p.drawn_out(u, v, 2, 24, 2, 3))));
  double tone = 0.80 - 0.42 * late * (1 - 0.35 * m.relief) + 0.35 * fibre - 0.6 * crack;
  auto wood = [&](const DVec3& c) {
    return ramp(tone, {{0, c * DVec3(0.20, 0.15, 0.11)},
                       {0.30, c * DVec3(0.55, 0.47, 0.40)},
                       {0.62, c * 0.9},
                       {0.85, c * 1.1},
                       {1, c * 1.3}});
  };
  double worn = m.relief * 1.1 - 0.35 + 0.8 * m.p.drawn_out(u, v, 3, 6, 3, 4);
  return {glm::mix(wood(m.c), wood(m.s), smooth_step(0.15, 0.75, worn)),
          0.5 + 0.3 * fibre + 0.2 * late - 0.5 * crack};
}

Dab ashlar(const Painted& m, double u, double v) {
  double tone = 0.52 + 0.35 * m.p.fractal(u, v, 5, 4, 1) + 0.3 * m.p.fractal(u, v, 60, 2, 2);
  double pit = std::clamp(4 * (0.5 * m.p.fractal(u, v, 30, 1, 3) - 0.20), 0.0, 1.0);
  DVec3 clean =
      ramp(tone - 0.5 * m.relief * pit,
           {{0, m.c * 0.27}, {0.25, m.c * 0.60}, {0.5, m.c * 0.92}, {0.75, m.c * 1.08}, {1, m.c * 1.33}});
  DVec3 stained = ramp(tone, {{0, m.s * 0.15}, {0.5, m.s * 0.42}, {1, m.s * 0.77}});
  double worn = 0.30 * m.relief + 0.8 * m.p.drawn_out(u, v, 5, 2, 4, 4);
  DVec3 color = ramp(worn, {{0.16, clean}, {0.90, clean * 0.42 + stained * 0.58}});
  double crust = tiling_cells(u * 12, v * 12, 12, 12, Seed{41}).nearest +
                 1.6 * std::max(0.0, 0.66 - 0.3 * m.moss - m.p.bozo(u, v, 3, 5));
  if (m.moss > 0)
    color = ramp(crust, {{0, DVec3(0.36, 0.36, 0.28)},
                         {0.17, DVec3(0.44, 0.44, 0.36)},
                         {0.22, DVec3(0.3, 0.3, 0.24)},
                         {0.25, color}});
  return {color, 0.4 + 0.5 * (tone - 0.5) - 0.4 * pit + 0.2};
}

Dab bed(const Painted& m, double u, double v) {
  double g = m.p.granite(u, v, 16, 1);
  DVec3 bare = ramp(g, {{0.1, m.c * 0.42}, {0.5, m.c * 0.70}, {0.9, m.c * 0.95}});
  DVec3 green = ramp(
      g,
      {{0.15, DVec3(0.035, 0.055, 0.012)}, {0.5, DVec3(0.10, 0.15, 0.03)}, {0.85, DVec3(0.24, 0.30, 0.07)}});
  return {glm::mix(bare, green, smooth_step(1.0 - 0.75 * m.moss, 1.08 - 0.75 * m.moss, m.p.bozo(u, v, 6, 2))),
          g};
}

Dab soil(const Painted& m, double u, double v) {
  double g = m.p.granite(u, v, 16, 1), surfel = tiling_cells(u * 40, v * 40, 40, 40, Seed{42}).nearest;
  return {
      ramp(g,
           {{0, m.c * 0.25}, {0.35, m.c * 0.7}, {0.65, m.c * 1.2}, {0.88, m.c * 0.9 + m.s * 0.35}, {1, m.s}}),
      0.8 * g + 0.3 * (1 - surfel)};
}

/// What stone is in the open: stained, cracked, with lichen.
Dab in_the_open(const Painted& m, double u, double v, Dab fresh, const DVec3& dark) {
  double stain = smooth_step(0.45, 0.85, m.p.granite(u, v, 3, 20));
  DVec3 color = glm::mix(fresh.color, dark, 0.42 * stain);
  double bent = 0.2 * m.p.fractal(u, v, 3, 4, 21);
  Cells c = tiling_cells(u * 2 + bent, v * 2 + bent, 2, 2, Seed{43});
  double sound =
      std::max(smooth_step(0.004, 0.03, c.second - c.nearest), m.p.bozo(u, v, 2, 22) < 0.5 ? 1.0 : 0.0);
  color = glm::mix(dark * 0.45, color, sound);
  double round =
      tiling_cells(u * 9 + bent, v * 9 - bent, 9, 9, Seed{44}).nearest + 0.2 * m.p.fractal(u, v, 24, 3, 23);
  double patches =
      m.moss > 0 && m.p.bozo(u, v, 2, 24) > 0.62 - 0.20 * m.moss ? 1 - smooth_step(0.22, 0.30, round) : 0;
  DVec3 pale = DVec3(0.35, 0.39, 0.30) * (0.8 + 0.4 * m.p.granite(u, v, 40, 25));
  return {glm::mix(color, pale, patches), fresh.height * (0.5 + 0.5 * sound) + 0.1 * patches};
}

Dab granite(const Painted& m, double u, double v) {
  DVec3 warm = m.c * DVec3(1.12, 0.98, 0.86);
  double grain = tiling_cells(u * 72, v * 72, 72, 72, Seed{45}).own, g = m.p.granite(u, v, 5, 1),
         large = m.p.bozo(u, v, 2, 2);
  DVec3 grains = ramp(0.36 + 0.3 * grain, {{0.36, m.s * 0.45},
                                           {0.40, m.s},
                                           {0.42, m.c * 0.72},
                                           {0.48, m.c * 0.95},
                                           {0.54, warm},
                                           {0.60, m.c * 1.2},
                                           {0.66, m.c * 1.5}});
  DVec3 tone = ramp(g, {{0.15, m.c * 0.6}, {0.45, m.c}, {0.75, warm * 1.2}}),
        wide = ramp(large, {{0.25, m.c * 0.72}, {0.5, m.c}, {0.75, warm * 1.1}});
  return in_the_open(m, u, v, {(grains * 1.1 + tone + wide) / 3.1, 0.6 * g + 0.3 * grain},
                     m.s * 0.55 + m.c * 0.12);
}

Dab karst(const Painted& m, double u, double v) {
  double ring = v * 4 + 0.5 * m.p.fractal(u, v, 3, 5, 1), at = ring - std::floor(ring),
         g = m.p.granite(u, v, 5, 2), pit = m.p.bozo(u, v, 44, 3);
  DVec3 bands = ramp(at, {{0, m.c * 0.92},
                          {0.12, m.c * 1.08},
                          {0.20, m.s * 0.85},
                          {0.24, m.c * 0.8},
                          {0.45, m.c},
                          {0.52, m.s},
                          {0.60, m.c * 1.05},
                          {0.83, m.c * 0.86},
                          {0.88, m.s * 0.9},
                          {1, m.c * 0.92}});
  DVec3 tone = ramp(g, {{0.15, m.c * 0.62}, {0.45, m.c}, {0.75, m.c * 1.22}}),
        pits = ramp(pit, {{0.22, m.s * 0.35}, {0.30, m.c * 0.85}, {0.6, m.c * 1.03}, {0.8, m.c * 1.15}});
  return in_the_open(m, u, v,
                     {(bands * 1.1 + tone + pits * 0.9) / 3.0, 0.5 * g + 0.4 * smooth_step(0.2, 0.32, pit)},
                     m.s * 0.45 + m.c * 0.15);
}

Dab basalt(const Painted& m, double u, double v) {
  double g = m.p.granite(u, v, 14, 1), large = m.p.bozo(u, v, 2, 2),
         bubble = tiling_cells(u * 33, v * 33, 33, 33, Seed{46}).nearest;
  DVec3 fine = ramp(g, {{0.15, m.c * 0.5}, {0.45, m.c}, {0.75, m.c * 1.55}}),
        wide = ramp(large, {{0.25, m.c * 0.7}, {0.5, m.c * 1.1}, {0.62, m.c * 1.1}, {0.8, m.s}});
  DVec3 bubbles = ramp(bubble, {{0.10, m.c * 0.12}, {0.16, m.c * 0.9}, {0.5, m.c}, {0.9, m.c * 1.2}});
  return in_the_open(
      m, u, v, {(fine * 1.1 + wide + bubbles * 0.9) / 3.0, 0.4 * g + 0.5 * smooth_step(0.08, 0.18, bubble)},
      m.c * 0.35);
}

/// Cups with their walls: what lives, or, with larger cells, what is overgrown.
Dab polyps(const Painted& m, double u, double v) {
  double cup = tiling_cells(u * 24, v * 24, 24, 24, Seed{47}).nearest, g = m.p.granite(u, v, 20, 1);
  DVec3 color = ramp(
      cup, {{0.05, m.s}, {0.20, m.c * 0.72 + m.s * 0.2}, {0.32, m.c * 1.22}, {0.45, m.c}, {0.9, m.c * 0.72}});
  return {color * (0.9 + 0.2 * g), smooth_step(0.1, 0.32, cup) * (1 - 0.5 * smooth_step(0.35, 0.9, cup))};
}

Dab meander(const Painted& m, double u, double v) {
  double g = m.p.granite(u, v, 16, 1);
  return {ramp(g, {{0.15, m.c * 0.85}, {0.5, m.c}, {0.85, m.c * 1.2}}), g};
}

Dab sponge(const Painted& m, double u, double v) {
  double pit = tiling_cells(u * 20, v * 20, 20, 20, Seed{48}).nearest, g = m.p.granite(u, v, 8, 1);
  return {ramp(pit, {{0.15, m.c * 0.35 + m.s * 0.5}, {0.40, m.c}}) * (0.85 + 0.3 * g),
          smooth_step(0.1, 0.4, pit)};
}

Dab reef(const Painted& m, double u, double v) {
  double g = m.p.granite(u, v, 12, 1), patch = m.p.bozo(u, v, 5, 2);
  DVec3 bare = ramp(g, {{0.15, m.c * 0.3}, {0.4, m.c * 0.65}, {0.6, m.c * 0.9}, {0.85, m.c * 1.15}});
  return {
      ramp(patch, {{0.40, bare}, {0.46, m.s * (0.6 + 0.8 * g)}, {0.62, m.s * (0.6 + 0.8 * g)}, {0.66, bare}}),
      g};
}

/// Who paints a matter, and how many times its `scale` the picture is wide.
struct MatterPainter {
  Matter matter;
  Dab (*paint)(const Painted& m, double u, double v);
  double times, strength;
};

constexpr MatterPainter kPainters[] = {
    {Matter::brick, brick, 14, 6},        {Matter::mortar, mortar, 8, 8},
    {Matter::limestone, limestone, 8, 5}, {Matter::plaster, plaster, 20, 6},
    {Matter::paint, paint, 20, 4},        {Matter::timber, timber, 24, 6},
    {Matter::ashlar, ashlar, 3, 8},       {Matter::bed, bed, 3, 8},
    {Matter::soil, soil, 40, 12},         {Matter::granite, granite, 4.2, 7},
    {Matter::karst, karst, 4.2, 8},       {Matter::basalt, basalt, 4.2, 8},
    {Matter::polyps, polyps, 24, 8},      {Matter::meander, meander, 24, 3},
    {Matter::sponge, sponge, 26, 6},      {Matter::reef, reef, 5, 8}};

}  // namespace

Tile matter_tile(const Material& material, int pixels) {
  Painted m{light_of(material.color), light_of(material.second), material.relief, material.moss, {Seed{31}}};
  for (const MatterPainter& painter : kPainters) {
    if (painter.matter != material.matter) continue;
    Tile tile = tile_of(pixels, pixels, [&](double u, double v) { return painter.paint(m, u, v); });
    tile.metres = painter.times * material.scale;
    tile.strength = painter.strength * (0.4 + material.relief) * pixels / 512;
    return tile;
  }
  return {};
}

namespace {

constexpr double kOutside = 0.75;  // share of a vessel's picture

/// How far (s, w) lies inside a motif, as povinc/frond_vessel.inc has it.
double motif_depth(Motif motif, double s, double w) {
  double own = s - std::floor(s), near = std::abs(own - 0.5);
  switch (motif) {
    case Motif::zigzag:
      return 0.13 - std::abs(w - 0.12 - 1.52 * near);
    case Motif::waves:
      return std::max(0.10 - std::abs(w - 0.5 - 0.28 * std::sin(2 * kPi * s)),
                      0.05 - std::abs(w - 0.5 - 0.28 * std::sin(2 * kPi * s + 1.3)));
    case Motif::dots:
      return 0.30 - std::hypot(w - 0.5, (own - 0.5) * 1.1);
    case Motif::meander: {
      constexpr const char* kKey[] = {"11111", "10001", "10111", "10000", "11111"};  // rows from the foot up
      return kKey[std::clamp(static_cast<int>(w * 5), 0, 4)][std::min(4, static_cast<int>(own * 5))] == '1'
                 ? 0.5
                 : -0.5;
    }
    case Motif::petals:
      return 0.46 * std::pow(std::max(0.0, std::sin(kPi * (1 - std::pow(1 - w, 1.4)))), 0.75) - near - 0.04;
    case Motif::rings:
      return std::max({0.06 - std::abs(w - 0.12), 0.10 - std::abs(w - 0.5), 0.06 - std::abs(w - 0.88)});
    case Motif::plain:
      return 0.5 - std::abs(w - 0.5);
  }
  return -1;
}

DVec3 with_bands(const Material& material, const Pattern& p, double u, double v, DVec3 color) {
  for (const Band& band : material.bands) {
    double w = (v - band.at) / band.width + 0.5;
    if (w < 0 || w > 1) continue;
    double inside = motif_depth(band.motif, u * band.repeats, w) + 0.015 * p.fractal(u, v, 60, 2, 80);
    color = glm::mix(color, light_of(band.color) * 0.88, 0.96 * smooth_step(0.35, 0.65, 0.5 + 12 * inside));
  }
  return color;
}

DVec3 glazed(const Painted& m, double u, double v) {
  double cloud = 0.5 * m.p.drawn_out(u, v, 6, 6, 3, 1), run = 0.5 * m.p.drawn_out(u, v, 24, 3, 3, 2);
  double thick = 0.55 + (0.55 + 0.35 * m.relief) * cloud + (0.25 + 0.55 * m.relief) * run -
                 0.16 * smooth_step(0.9, 1.0, v);
  DVec3 glaze = ramp(thick, {{0, m.c * 0.45 + m.s * 0.62},
                             {0.22, m.c * 0.80 + m.s * 0.26},
                             {0.45, m.c * 0.97},
                             {0.7, m.c * 0.92},
                             {1, m.c * DVec3(0.66, 0.70, 0.76)}});
  if (m.relief > 0.25) {  // cracks
    double bent = 0.15 * m.p.fractal(u, v, 12, 2, 3);
    Cells c = tiling_cells(u * 30 + bent, v * 30 + bent, 30, 30, Seed{47});
    glaze = glm::mix(m.c * 0.3 + m.s * 0.1, glaze,
                     smooth_step(0.0, 0.02 + 0.04 * m.relief, c.second - c.nearest));
  }
  // Above the foot the glaze ends.
  double bare = 1 - smooth_step(0.02, 0.035, v + 0.02 * run);
  return bare > 0 ? glm::mix(glaze, m.s * (0.85 + 0.2 * m.p.fractal(u, v, 60, 2, 4)), bare) : glaze;
}

DVec3 fired(const Painted& m, double u, double v) {
  double turned = m.p.drawn_out(u, v, 2, 60, 3, 1);
  double tone = 0.5 + 0.3 * m.p.fractal(u, v, 5, 2, 2) + 0.2 * turned + 0.2 * m.p.fractal(u, v, 90, 1, 3);
  DVec3 clay =
      ramp(tone, {{0, m.c * DVec3(0.62, 0.56, 0.50)}, {0.45, m.c * 0.93}, {0.75, m.c * 1.1}, {1, m.c * 1.3}});
  double salt = (0.15 + 0.85 * m.relief) * (0.15 + 0.6 * m.p.drawn_out(u, v, 6, 3, 4, 4) + 0.3 * (0.6 - v));
  clay = ramp(salt, {{0.12, clay}, {0.5, clay * 0.43 + m.s * 0.57}, {0.85, m.s}});
  double green =
      0.5 + 1.7 * (0.5 * m.p.drawn_out(u, v, 8, 5, 4, 5) - 0.48 + 0.60 * m.moss + 0.22 * m.moss * (0.45 - v));
  return glm::mix(clay, DVec3(0.16, 0.19, 0.06), smooth_step(0.4, 0.8, green));
}

}  // namespace

Tile vessel_tile(const Material& material, int pixels) {
  Painted m{light_of(material.color), light_of(material.second), material.relief, material.moss, {Seed{32}}};
  double rough = material.matter == Matter::terracotta ? 0.4 : material.matter == Matter::glass ? 0 : 0.1;
  Tile tile = tile_of(pixels, 3 * pixels / 4, [&](double u, double v) -> Dab {
    // Inside it is the same at the same height.
    bool outside = v < kOutside;
    double along = outside ? v / kOutside : (1 - v) / (1 - kOutside);
    DVec3 color = material.matter == Matter::terracotta ? fired(m, u, along)
                  : material.matter == Matter::glass    ? m.c
                                                        : glazed(m, u, along);
    if (outside) color = with_bands(material, m.p, u, along, color);
    return {color, 0.6 + rough * m.p.drawn_out(u, v, 2, 60, 2, 1)};
  });
  tile.strength = 0.008 * pixels;
  return tile;
}

float on_vessel(float along) {
  auto outside = static_cast<float>(kOutside);
  return along < 1 ? outside * along : outside + (1 - outside) * (along - 1);
}

}  // namespace frond
