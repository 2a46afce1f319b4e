#include "images/bark.h"

#include <algorithm>
#include <cmath>

#include "core/linear.h"
#include "core/parallel.h"
#include "images/bark_photo.h"
#include "images/tiling_noise.h"

namespace frond {

namespace {

struct Spot {
  double height, tone;
};

// All numbers here are by eye. Factors in a sum weigh what makes up a height or a tone, each 0..1.

constexpr double kBarkGain = 0.55;  // of fractal noise, from octave to octave
// A crack between cells rises from its ground to its edge over this difference of a cell's two distances.
constexpr double kCrackGround = 0.02, kCrackEdge = 0.30;

/// The scar of a shed branch.
struct Scar {
  double least = 0.055, more = 0.075;  ///< radius, in widths of the picture: from the least to so much more
  double many = 3;                     ///< scars on a square of that width, above which they are smaller
  double solid = 0.92, gone = 1.08;    ///< radii from its middle between which it fades into the bark
  double push = 0.55;                  ///< radii by which the bark beside it is pushed aside ..
  double push_all = 0.7, push_none = 1.9;  ///< .. between these radii from its middle, less and less
  double collar = 0.80, wide = 0.16;       ///< radii: where the collar is highest, and half its width
  double rings = 3, more_rings = 2;        ///< number of rings: from the least to so many more
  int grain = 24;                          ///< features of its roughness round the picture
};
constexpr Scar kScar;

/// Short streaks across a bark.
struct Streaks {
  int times;            ///< as many as there are ridges
  double thick;         ///< half their height, in distances from row to row
  double share = 0.42;  ///< of the possible positions that have one
};

/// One kind of bark at (u, v), each 0..1. `along_` features fit along where `across_` ridges fit round.
class BarkPainter {
 public:
  BarkPainter(const BarkImage& bark, int width, int height, Seed seed)
      : bark_(bark),
        seed_(seed),
        across_(bark.ridges),
        along_(std::max(1, static_cast<int>(std::lround(bark.ridges * static_cast<double>(height) / width /
                                                        bark.stretch)))) {}

  Spot at(double u, double v) const {
    Knot knot = bark_.knots > 0 ? knot_at(u, v) : Knot{};
    // The bark gives way round a knot.
    Spot spot = plain(u + knot.push.x, v + knot.push.y);
    if (bark_.lenticels > 0) add_lenticels(spot, u, v);
    if (knot.within > 0) add_knot(spot, knot, u, v);
    return spot;
  }

 private:
  /// Where a branch has been shed: `away` 0 in its middle, 1 at the rim of its collar.
  struct Knot {
    double within = 0, away = 0, own = 0;
    glm::dvec2 push{0};
  };

  /// The picture is so high in its widths.
  double tall() const { return along_ * bark_.stretch / across_; }

  Knot knot_at(double u, double v) const {
    auto cells = std::max(1, static_cast<int>(std::lround(std::sqrt(bark_.knots))));
    int rows = std::max(1, static_cast<int>(std::lround(cells * tall())));
    double share = bark_.knots / (cells * cells), x = u * cells, y = v * rows;
    Knot best;
    double nearest = 2;
    for (int cell = 0; cell < 9; ++cell) {
      int column = static_cast<int>(std::floor(x)) + cell % 3 - 1,
          row = static_cast<int>(std::floor(y)) + cell / 3 - 1;
      Seed own = seed_.child("knot", (row % rows + rows) % rows).child((column % cells + cells) % cells);
      if (own.child(0).unit() > share) continue;
      // Their size is that of a branch rather than of the bark's features.
      double radius = (kScar.least + kScar.more * own.child(1).unit()) /
                      std::sqrt(std::max(1.0, bark_.knots / kScar.many));
      glm::dvec2 offset((x - column - 0.25 - 0.5 * own.child(2).unit()) / cells,
                        (y - row - 0.25 - 0.5 * own.child(3).unit()) * tall() / rows);
      offset.y *= 0.85 + 0.3 * own.child(4).unit();  // not quite round
      double away = glm::length(offset) / radius;
      if (away >= nearest) continue;
      nearest = away;
      double bend = kScar.push * radius * smooth_step(kScar.push_none, kScar.push_all, away);
      glm::dvec2 out = offset / std::max(glm::length(offset), 1e-9);
      best = {smooth_step(kScar.gone, kScar.solid, away), away, own.child(5).unit(),
              glm::dvec2(-out.x, -out.y / tall()) * bend};
    }
    return best;
  }

  /// A scar with rings, a hollow heart and a thick collar.
  void add_knot(Spot& spot, const Knot& knot, double u, double v) const {
    double grain = even(u, v, kScar.grain, seed_.child("scar"), 3);
    double away = knot.away + 0.07 * grain;
    double rings = 0.5 + 0.5 * std::cos(2 * kPi * (kScar.rings + kScar.more_rings * knot.own) * away);
    double collar = std::exp(-std::pow((away - kScar.collar) / kScar.wide, 2));
    double height = 0.34 + 0.30 * away + 0.10 * rings * (1 - collar) + 0.38 * collar + 0.07 * grain -
                    0.30 * smooth_step(0.30, 0.05, away) * knot.own;
    double tone = 0.30 + 0.22 * rings + 0.42 * collar - 0.35 * smooth_step(0.34, 0.10, away) + 0.10 * grain;
    spot.height = std::clamp(glm::mix(spot.height, height, knot.within), 0.0, 1.0);
    spot.tone = std::clamp(glm::mix(spot.tone, tone, knot.within), 0.0, 1.0);
  }

  /// Pores across: corky lips about a dark slit.
  void add_lenticels(Spot& spot, double u, double v) const {
    constexpr double kMostPores = 0.8, kSlit = 0.55;  // share of all positions; depth in the lips
    double lips = lenticels(u, v, {1, 0.24, kMostPores * bark_.lenticels}, seed_.child("pores")),
           slit = smooth_step(kSlit, 1.0, lips);
    spot.height = std::clamp(spot.height + 0.30 * lips - 0.45 * slit, 0.0, 1.0);
    spot.tone = std::clamp(spot.tone - 0.45 * lips - 0.35 * slit, 0.0, 1.0);
  }

  Spot plain(double u, double v) const {
    switch (bark_.pattern) {
      case BarkPattern::furrowed:
        return furrowed(u, v);
      case BarkPattern::plated:
        return plated(u, v);
      case BarkPattern::smooth:
        return smooth(u, v);
      case BarkPattern::banded:
        return banded(u, v);
    }
    return {};
  }

  double rough(double u, double v, int times, int octaves, Seed seed) const {
    return tiling_fractal(u * across_ * times, v * along_ * times, across_ * times, along_ * times, octaves,
                          kBarkGain, seed);
  }
  /// Round noise: as many features along as the picture is high.
  double even(double u, double v, int across, Seed seed, int octaves = 4) const {
    int along = std::max(1, static_cast<int>(std::lround(across * along_ * bark_.stretch / across_)));
    return tiling_fractal(u * across, v * along, across, along, octaves, kBarkGain, seed);
  }

  Spot furrowed(double u, double v) const {
    constexpr double kWander = 1.1;                // ridges by which one wanders
    constexpr double kDark = 0.10, kLight = 0.62;  // heights that have the second colour, and the first
    Seed s = seed_;
    int wide = std::max(1, across_ / 2);
    double wander =
        tiling_noise(u * wide, v * along_, wide, along_, s.child("wander")) +
        0.5 * tiling_noise(u * wide * 2, v * along_ * 2, wide * 2, along_ * 2, s.child("wander", 1)) +
        0.16 * rough(u, v, 4, 2, s.child("wander", 2));
    double ridge = u * across_ + kWander * bark_.warp * wander;
    double f = ridge - std::floor(ridge);
    double back = std::sqrt(std::max(0.0, 1 - (2 * f - 1) * (2 * f - 1)));
    // Each ridge breaks across, at places of its own, along the edges of stretched cells.
    Cells c = tiling_cells(u * across_ + 0.45 * wander, v * along_ * 2 + 0.3 * wander, across_, along_ * 2,
                           s.child("break"));
    double broken = smooth_step(kCrackGround, kCrackEdge, c.second - c.nearest);
    double coarse = 0.5 + 0.5 * rough(u, v, 2, 5, s.child("coarse"));
    double fine = even(u, v, across_ * 6, s.child("fine"), 3);
    double height =
        std::pow(back, 0.8) * (0.40 + 0.60 * coarse) * (0.55 + 0.45 * broken) * (0.85 + 0.3 * c.own);
    height = std::clamp(height + 0.09 * fine, 0.0, 1.0);
    return {height, smooth_step(kDark, kLight, height + 0.10 * fine)};
  }

  Spot plated(double u, double v) const {
    constexpr double kWarp = 0.55;  // plates by which their edges wander
    Seed s = seed_;
    double w = kWarp * bark_.warp;
    double du = w * rough(u, v, 1, 4, s.child("warp")), dv = w * rough(u, v, 1, 4, s.child("warp", 1));
    Cells c = tiling_cells(u * across_ + du, v * along_ + dv, across_, along_, s.child("plates"));
    Cells thin =
        tiling_cells(u * across_ * 2 + du, v * along_ * 3 + dv, across_ * 2, along_ * 3, s.child("flakes"));
    double edge = c.second - c.nearest, plate = smooth_step(kCrackGround, kCrackEdge, edge);
    double flake = smooth_step(0.0, 0.22, thin.second - thin.nearest);
    double fine = even(u, v, across_ * 5, s.child("fine"), 4);
    double height = plate * (0.50 + 0.28 * c.own + 0.14 * flake * thin.own + 0.10 * flake) + 0.09 * fine;
    height = std::clamp(height, 0.0, 1.0);
    return {height, std::clamp(plate * (0.55 + 0.40 * thin.own) + 0.15 * fine, 0.0, 1.0)};
  }

  Spot smooth(double u, double v) const {
    Seed s = seed_;
    double fold = even(u, v, std::max(2, across_ / 3), s.child("fold"), 5);
    double fine = even(u, v, across_ * 5, s.child("fine"), 3);
    double scars = lenticels(u, v, {3, 0.10}, s.child("scars"));
    double height = 0.55 + 0.22 * fold + 0.06 * fine + 0.20 * scars;
    return {std::clamp(height, 0.0, 1.0),
            std::clamp(0.80 + 0.28 * fold + 0.12 * fine - 0.65 * scars, 0.0, 1.0)};
  }

  Spot banded(double u, double v) const {
    Seed s = seed_;
    double fine = even(u, v, across_ * 4, s.child("fine"), 4);
    double sheet = even(u, v, std::max(2, across_ / 3), s.child("sheet"), 4);
    double thin = lenticels(u, v, {2, 0.16}, s.child("thin"));
    double wide = lenticels(u, v, {1, 0.30}, s.child("wide"));
    // Where old branches were: dark and ragged, wider than high.
    constexpr double kEyes = 0.45;                      // share of cells that have one
    constexpr double kEyeRim = 0.26, kEyeHeart = 0.10;  // distances from its middle, in cells
    int rows = std::max(1, along_ / 2), columns = std::max(2, across_ / 4);
    Cells c = tiling_cells(u * columns + 0.25 * fine, v * rows + 0.10 * fine, columns, rows, s.child("eyes"));
    double eye = c.own < kEyes ? smooth_step(kEyeRim, kEyeHeart, c.nearest + 0.10 * fine) : 0;
    double dark = std::max({0.75 * thin, wide, eye});
    double height = 0.62 + 0.10 * sheet + 0.05 * fine - 0.35 * eye + 0.16 * thin;
    return {std::clamp(height, 0.0, 1.0),
            std::clamp(0.94 + 0.14 * sheet + 0.06 * fine - 0.95 * dark, 0.0, 1.0)};
  }

  /// 1 in streaks of that kind, 0 beside them.
  double lenticels(double u, double v, const Streaks& kind, Seed seed) const {
    int columns = std::max(1, across_ * kind.times / 3);
    int rows = std::max(1, static_cast<int>(std::lround(along_ * bark_.stretch)) * kind.times);
    double bent = 0.5 * even(u, v, std::max(2, across_ / 2), seed.child("bent"), 3);
    double y = v * rows + bent;
    int row = static_cast<int>(std::floor(y));
    double x = u * columns, streak = 0;
    for (int near = -1; near <= 1; ++near) {
      int column = static_cast<int>(std::floor(x)) + near;
      auto own = seed.child((row % rows + rows) % rows).child((column % columns + columns) % columns);
      if (own.child(3).unit() > kind.share) continue;
      double half = 0.12 + 0.5 * own.child(0).unit(), middle = column + own.child(1).unit();
      double across = std::abs(x - middle) / half,
             up = std::abs(y - row - 0.5) / (kind.thick * (0.5 + own.child(2).unit()));
      streak = std::max(streak, smooth_step(1.0, 0.55, std::sqrt(across * across + up * up)));
    }
    return streak;
  }

  /// 1 where x is below `to`, 0 above `from`, and the other way round where from < to.
  static double smooth_step(double from, double to, double x) {
    return from < to ? frond::smooth_step(from, to, x) : 1 - frond::smooth_step(to, from, x);
  }

  const BarkImage& bark_;
  Seed seed_;
  int across_, along_;
};

using Rgb = glm::dvec3;
Rgb rgb_of(const Color& c) { return {linear(c.red), linear(c.green), linear(c.blue)}; }

void put(Raster& raster, int x, int y, Rgb color) {
  for (int c = 0; c < 3; ++c) raster.data[raster.index(x, y, c)] = to_byte(encoded(std::max(color[c], 0.0)));
}

template <class Paint>
void each_row(int height, const Paint& paint) {
  parallel_for(static_cast<std::size_t>(height), [&](std::size_t y) { paint(static_cast<int>(y)); });
}

}  // namespace

BarkMaps bark_maps(const BarkImage& bark, int width, int height, Seed seed) {
  // Shallow furrows have their ground near the ridges.
  auto raised = [&](double h) { return static_cast<float>(std::clamp(1 - (1 - h) * bark.depth, 0.0, 1.0)); };
  BarkMaps maps{Grid(width, height), Grid(width, height)};
  if (bark.photo) {
    maps.height = tile_heights(resized_tile(*bark.photo, width, height));
    for (float& h : maps.height.data) h = raised(static_cast<double>(h));
    return maps;
  }
  BarkPainter painter(bark, width, height, seed.child("bark"));
  each_row(height, [&](int y) {
    for (int x = 0; x < width; ++x) {
      Spot spot = painter.at((x + 0.5) / width, 1 - (y + 0.5) / height);
      maps.height.at(x, y) = raised(spot.height);
      maps.tone.at(x, y) = static_cast<float>(spot.tone);
    }
  });
  return maps;
}

Raster normal_picture(const Grid& grid, double strength) {
  Raster raster(grid.width, grid.height, 3);
  each_row(grid.height, [&](int y) {
    for (int x = 0; x < grid.width; ++x) {
      auto h = [&](int dx, int dy) { return static_cast<double>(grid.wrapped(x + dx, y + dy)); };
      double across = (h(1, -1) + 2 * h(1, 0) + h(1, 1) - h(-1, -1) - 2 * h(-1, 0) - h(-1, 1)) / 8;
      double up = (h(-1, -1) + 2 * h(0, -1) + h(1, -1) - h(-1, 1) - 2 * h(0, 1) - h(1, 1)) / 8;
      DVec3 n = glm::normalize(DVec3(-across * strength, -up * strength, 1));
      for (int c = 0; c < 3; ++c) raster.data[raster.index(x, y, c)] = to_byte(0.5 + 0.5 * n[c]);
    }
  });
  return raster;
}

Raster bark_colors(const BarkImage& bark, const BarkMaps& maps, Seed seed) {
  constexpr int kPatches = 4, kStains = 3;                  // of lichen and of stain, round the picture
  constexpr double kLichenNone = 0.42, kLichenAll = 0.62;   // patches of noise between which lichens cover
  constexpr double kLichenSpread = 0.8;                     // by how much both fall where lichens are 1
  constexpr double kFurrowLight = 0.20, kLitHeight = 0.75;  // light in the ground; height that has it all
  if (bark.photo) return resized_tile(*bark.photo, maps.height.width, maps.height.height);
  Raster raster(maps.height.width, maps.height.height, 3);
  Rgb high = rgb_of(bark.color), low = rgb_of(bark.second), lichen = rgb_of(bark.lichen);
  Seed spots = seed.child("lichen"), stain = seed.child("stain");
  int rows = std::max(1, kPatches * raster.height / raster.width);
  each_row(raster.height, [&](int y) {
    for (int x = 0; x < raster.width; ++x) {
      double u = (x + 0.5) / raster.width, v = 1 - (y + 0.5) / raster.height;
      double tone = maps.tone.at(x, y), height = maps.height.at(x, y);
      double patch = tiling_fractal(u * kPatches, v * rows, kPatches, rows, 6, 0.6, spots);
      double tint = tiling_fractal(u * kStains, v * rows, kStains, rows, 5, 0.6, stain);
      // Little light comes down into a furrow.
      Rgb color = glm::mix(low, high, tone) *
                  (kFurrowLight + 0.80 * frond::smooth_step(0.0, kLitHeight, height)) * (1 + 0.45 * tint);
      color *= Rgb(1 + 0.08 * tint, 1, 1 - 0.10 * tint);
      double grown = frond::smooth_step(kLichenNone - kLichenSpread * bark.lichens,
                                        kLichenAll - kLichenSpread * bark.lichens, patch) *
                     tone;
      if (bark.lichens > 0) color = glm::mix(color, lichen * (0.6 + 0.5 * height), 0.75 * grown);
      put(raster, x, y, color);
    }
  });
  return raster;
}

Raster lit_picture(const Raster& colors, const Raster& normals) {
  Raster raster(colors.width, colors.height, 3);
  constexpr double kAmbient = 0.18;  // light in the shade, beside the 1 of the lamp
  const DVec3 light = glm::normalize(DVec3(-0.45, 0.35, 0.82));
  each_row(raster.height, [&](int y) {
    for (int x = 0; x < raster.width; ++x) {
      DVec3 n;
      Rgb color;
      for (int c = 0; c < 3; ++c) {
        n[c] = normals.at(x, y, c) / 127.5 - 1;
        color[c] = linear(colors.at(x, y, c) / 255.0);
      }
      put(raster, x, y, color * (kAmbient + 1.0 * std::max(0.0, glm::dot(glm::normalize(n), light))));
    }
  });
  return raster;
}

Raster grey_picture(const Grid& grid) {
  Raster raster(grid.width, grid.height, 1);
  for (std::size_t i = 0; i < grid.data.size(); ++i) raster.data[i] = to_byte(grid.data[i]);
  return raster;
}

}  // namespace frond
