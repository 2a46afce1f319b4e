#include "export/tile.h"

#include <algorithm>
#include <cmath>

#include "core/linear.h"
#include "core/parallel.h"
#include "export/look.h"
#include "export/pattern.h"
#include "images/bark.h"

namespace frond {

Tile tile_of(int width, int height, const std::function<Dab(double u, double v)>& spot) {
  Tile tile{Grid(width, height), {}};
  tile.color.resize(tile.height.data.size());
  parallel_for(static_cast<std::size_t>(height), [&](std::size_t y) {
    for (int x = 0; x < width; ++x) {
      Dab s = spot((x + 0.5) / width, 1 - (static_cast<double>(y) + 0.5) / height);
      std::size_t i = y * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
      tile.height.data[i] = static_cast<float>(std::clamp(s.height, 0.0, 1.0));
      tile.color[i] = s.color;
    }
  });
  return tile;
}

namespace {

constexpr int kCups = 8;   // across the picture of a coral's skin
constexpr int kRings = 4;  // of a palm

double bump(double from, double top, double to, double x) {
  return x < top ? smooth_step(from, top, x) : 1 - smooth_step(top, to, x);
}

/// Pores as povinc/frond_coral.inc draws them, over the distance from the middle of a cup.
Dab stony(double d, const DVec3& base, const DVec3& pit, double depth) {
  DVec3 color = ramp(d, {{0.00, pit * 0.70},
                         {0.15, pit * 0.75 + base * 0.1},
                         {0.25, base * 0.95},
                         {0.31, base * 1.18},
                         {0.46, base},
                         {0.72, base * 0.70 + pit * 0.25},
                         {1.00, base * 0.25 + pit * 0.75}});
  double height = 0.3 + depth * (0.6 * bump(0.12, 0.31, 0.85, d) - 0.2 * (1 - smooth_step(0.0, 0.2, d)));
  return {color, height};
}

}  // namespace

double skin_metres(const Skin& skin) {
  double size = skin.kind == SkinKind::stony ? 0.85 : skin.kind == SkinKind::fan ? 0.45 : 0.55;
  return size * skin.pores.cell * kCups;
}

double palm_metres(const Bark& bark) { return kRings * bark.scale; }

Tile skin_tile(const Skin& skin, int pixels) {
  Pattern pattern{Seed{21}};
  DVec3 base = light_of(tinted(skin.tint, 1));
  Tint second = skin.tint;
  second.base = second.secondary;
  DVec3 pit = light_of(tinted(second, 1));
  Tile tile = tile_of(pixels, pixels, [&](double u, double v) -> Dab {
    double bent = 0.30 * skin.pores.warp;
    double du = bent * pattern.fractal(u, v, kCups, 3, 1), dv = bent * pattern.fractal(u, v, kCups, 3, 2);
    double d = tiling_cells(u * kCups + du, v * kCups + dv, kCups, kCups, Seed{22}).nearest;
    double fine = 0.05 * pattern.fractal(u, v, 6 * kCups, 2, 3);
    if (skin.kind == SkinKind::stony) {
      Dab spot = stony(d, base, pit, skin.pores.depth);
      return {spot.color, spot.height + fine};
    }
    double height = 0.8 - 0.5 * skin.pores.depth * d + fine;
    if (skin.kind == SkinKind::fan)
      return {ramp(d, {{0, base * 1.25}, {0.35, base}, {0.9, pit * 0.35 + base * 0.65}}), height};
    return {
        ramp(d,
             {{0, base * 1.45 + 0.05}, {0.3, base * 1.1}, {0.6, base * 0.85}, {1, base * 0.45 + pit * 0.5}}),
        height};
  });
  tile.strength = 0.12 * pixels / kCups * 2;
  return tile;
}

Tile palm_tile(const Bark& bark, int pixels) {
  Pattern pattern{Seed{23}};
  DVec3 c = light_of(bark.colors[0]), d = light_of(bark.second);
  Tile tile = tile_of(pixels, pixels, [&](double u, double v) -> Dab {
    double bent = 0.10 * pattern.fractal(u, v, 6, 3, 1);
    double ring = v * kRings + bent, at = ring - std::floor(ring);
    double fibre = pattern.drawn_out(u, v, 24, 4, 4, 2), grain = pattern.fractal(u, v, 24, 4, 3);
    DVec3 seam = d * (0.65 + 0.3 * grain), collar = c * (1.15 + 0.3 * grain);
    DVec3 along = ramp(0.5 + 0.7 * fibre, {{0.15, d * 0.8}, {0.5, c}, {0.9, c * 1.25}});
    DVec3 color =
        ramp(at, {{0.0, seam}, {0.07, seam}, {0.16, collar}, {0.34, along}, {0.86, along}, {1, seam}});
    return {color,
            0.15 + 0.7 * smooth_step(0.03, 0.2, at) * (1 - 0.6 * smooth_step(0.2, 1.0, at)) + 0.15 * fibre};
  });
  tile.strength = 0.03 * pixels * bark.depth;
  return tile;
}

Tile cube_tile(const Color& color, int pixels) {
  DVec3 c = light_of(color);
  Tile tile = tile_of(pixels, pixels, [&](double u, double v) -> Dab {
    double edge = std::min(std::min(u, 1 - u), std::min(v, 1 - v));
    DVec3 shade = ramp(edge / 0.09, {{0, c * 0.50}, {0.30, c * 0.62}, {0.75, c * 0.98}, {1, c}});
    return {shade, std::sqrt(std::min(1.0, edge / 0.14))};
  });
  tile.strength = 0.04 * pixels;
  return tile;
}

namespace {

/// How much a place of a leaf is vein, as povinc/frond_plant.inc has it.
double vein(double x, double y) {
  double along = std::fmod(x * 6.2 - 3.2 * std::abs(y - 0.5) + 7, 1);
  double side = 0.6 * std::max(0.0, std::abs(along - 0.5) * 2 * 9 - 8);
  return std::min(1.0, std::max(std::max(0.0, 1 - std::abs(y - 0.5) * 34), side));
}

/// Of a leaf of ivy, as povinc/frond_ivy.inc has it: (x, y) on a blade one unit long.
double ivy_vein(double x, double y) {
  constexpr double kMain[][3] = {{0, 1, 0.030},
                                 {0.766, 0.643, 0.026},
                                 {-0.766, 0.643, 0.026},
                                 {0.940, -0.342, 0.022},
                                 {-0.940, -0.342, 0.022}};
  double main = 0, fine = 0;
  for (auto [sine, cosine, wide] : kMain) {
    double along = x * sine + y * cosine, aside = std::abs(x * cosine - y * sine);
    if (along < 0) continue;
    main = std::max(main, 1 - aside / (wide * (1.15 - 0.85 * std::min(1.0, along))));
    double wave = std::abs(std::fmod(6.5 * along - 5.2 * aside + 20, 1) - 0.5);
    if (along > 0.1) fine = std::max(fine, std::max(0.0, 1 - 7 * wave) * std::max(0.0, 1 - 3.6 * aside));
  }
  return std::min(1.0, main + 0.42 * fine);
}

Dab leaf_spot(Tissue tissue, double u, double v, const DVec3& c, const DVec3& second,
              const Pattern& pattern) {
  if (tissue == Tissue::petal)
    return {ramp(u + 0.05 * std::sin(v * 60),
                 {{0, (second * 0.35 + c * 0.65) * 0.85}, {0.35, c * 0.92}, {1, c * 1.05}}),
            0.5};
  if (tissue == Tissue::ivy) {
    if (u > 0.97) return {c * 0.5 + DVec3(0.30, 0.17, 0.10) * 0.5, 0.5};  // the petiole
    double x = (u - 0.5) * 2.6, y = (v - 0.5) * 2.6, veins = ivy_vein(x, y);
    double tone = 0.25 + 0.75 * std::hypot(x, y) + 0.25 * pattern.fractal(u, v, 9, 2, 1);
    DVec3 blade = ramp(tone, {{0, c * DVec3(0.86, 0.96, 0.90)}, {0.6, c}, {1, c * DVec3(1.14, 1.04, 0.96)}});
    return {glm::mix(blade, second * 0.62 + c * 0.38, 0.85 * veins), 0.6 - 0.3 * veins};
  }
  double veins = vein(u, v);
  DVec3 blade = ramp(1.5 * std::abs(v - 0.5) + 0.28 * u, {{0, c * 0.80}, {0.5, c}, {1, c * 1.22}});
  return {glm::mix(blade, second * 0.55 + c * 0.45, veins), 0.6 - 0.3 * veins};
}

}  // namespace

Tile tissue_tile(Tissue tissue, const Color& color, const Color& second, int pixels) {
  Pattern pattern{Seed{24}};
  DVec3 c = light_of(color), s = light_of(second);
  Tile tile =
      tile_of(pixels, pixels, [&](double u, double v) { return leaf_spot(tissue, u, v, c, s, pattern); });
  tile.strength = 0.02 * pixels;
  return tile;
}

Color mean_color(const Tile& tile) {
  DVec3 sum(0);
  for (const DVec3& c : tile.color) sum += glm::clamp(c, 0.0, 1.0);
  sum /= static_cast<double>(std::max<std::size_t>(1, tile.color.size()));
  return {static_cast<float>(encoded(sum.x)), static_cast<float>(encoded(sum.y)),
          static_cast<float>(encoded(sum.z))};
}

Pictures pictures_of(const Tile& tile, double rough) {
  const Grid& h = tile.height;
  Pictures made{Raster(h.width, h.height, 3), normal_picture(h, tile.strength), roughness_of(h, rough)};
  for (std::size_t i = 0; i < tile.color.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      made.colors.data[3 * i + c] =
          to_byte(encoded(std::clamp(tile.color[i][static_cast<int>(c)], 0.0, 1.0)));
  return made;
}

Raster roughness_of(const Grid& height, double rough) {
  Raster made(std::max(1, height.width / 2), std::max(1, height.height / 2), 3);
  for (int y = 0; y < made.height; ++y)
    for (int x = 0; x < made.width; ++x) {
      // Green is the roughness; blue, the share of metal, is nothing.
      double deep = 1 - static_cast<double>(height.at(2 * x, 2 * y));
      made.data[made.index(x, y, 1)] = to_byte(rough + (1 - rough) * 0.5 * deep * deep);
    }
  return made;
}

}  // namespace frond
