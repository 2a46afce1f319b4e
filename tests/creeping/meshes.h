#pragma once

#include <cmath>
#include <functional>
#include <map>

#include "core/noise.h"
#include "core/seed.h"
#include "creeping/triangle_surface.h"
#include "rocks/stone.h"

namespace frond {

inline TriangleSurface built(const Surface& s) { return std::move(*TriangleSurface::build(s)); }

/// A surface over a grid of (u, v) in 0..1, joined to itself where `wrap` says so.
inline Surface sheet(int columns, int rows, bool wrap_u, bool wrap_v,
                     const std::function<Vec3(double, double)>& at) {
  Surface s;
  int width = wrap_u ? columns : columns + 1, height = wrap_v ? rows : rows + 1;
  for (int j = 0; j < height; ++j)
    for (int i = 0; i < width; ++i) s.position.push_back(at(double(i) / columns, double(j) / rows));
  auto index = [&](int i, int j) { return static_cast<std::uint32_t>((j % height) * width + i % width); };
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      s.triangle.push_back({index(i, j), index(i + 1, j), index(i + 1, j + 1)});
      s.triangle.push_back({index(i, j), index(i + 1, j + 1), index(i, j + 1)});
    }
  set_normals(s);
  return s;
}

/// A ball of 2 * columns * rows triangles, with poles of triangles without area.
inline Surface ball(double radius, int columns, int rows) {
  return sheet(columns, rows, true, false, [=](double u, double v) {
    double a = 2 * kPi * u, b = kPi * v;
    return Vec3(radius * std::sin(b) * std::cos(a), -radius * std::cos(b),
                -radius * std::sin(b) * std::sin(a));
  });
}

inline Surface ring(double radius, double thickness, int columns, int rows) {
  return sheet(columns, rows, true, true, [=](double u, double v) {
    double a = 2 * kPi * u, b = 2 * kPi * v, r = radius + thickness * std::cos(b);
    return Vec3(r * std::cos(a), thickness * std::sin(b), -r * std::sin(a));
  });
}

/// The skin of a body of bricks: all cells (x, y, z) of a grid for which `full` holds. Vertices are not
/// shared.
inline Surface bricks(int nx, int ny, int nz, Vec3 cell, const std::function<bool(int, int, int)>& full) {
  Surface s;
  auto is = [&](int x, int y, int z) {
    return x >= 0 && y >= 0 && z >= 0 && x < nx && y < ny && z < nz && full(x, y, z);
  };
  auto quad = [&](Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
    auto first = static_cast<std::uint32_t>(s.position.size());
    for (Vec3 p : {a, b, c, d})
      s.position.push_back((p - Vec3(0.5f * float(nx), 0, 0.5f * float(nz))) * cell);
    s.triangle.push_back({first, first + 1, first + 2});
    s.triangle.push_back({first, first + 2, first + 3});
  };
  for (int x = 0; x < nx; ++x)
    for (int y = 0; y < ny; ++y)
      for (int z = 0; z < nz; ++z) {
        if (!is(x, y, z)) continue;
        Vec3 o(x, y, z), i(1, 0, 0), j(0, 1, 0), k(0, 0, 1);
        if (!is(x + 1, y, z)) quad(o + i, o + i + j, o + i + j + k, o + i + k);
        if (!is(x - 1, y, z)) quad(o, o + k, o + j + k, o + j);
        if (!is(x, y + 1, z)) quad(o + j, o + j + k, o + i + j + k, o + i + j);
        if (!is(x, y - 1, z)) quad(o, o + i, o + i + k, o + k);
        if (!is(x, y, z + 1)) quad(o + k, o + i + k, o + i + j + k, o + j + k);
        if (!is(x, y, z - 1)) quad(o, o + j, o + i + j, o + i);
      }
  set_normals(s);
  return s;
}

inline Surface cube(float size, int cells) {
  return bricks(cells, cells, cells, Vec3(size / float(cells)), [](int, int, int) { return true; });
}

/// A wall of 4 x 2 x 0.3 m that stands free, its foot at y = 0, front toward +z.
inline Surface thin_wall() {
  return bricks(40, 20, 3, Vec3(0.1f), [](int, int, int) { return true; });
}

/// The same with a window and a door.
inline Surface wall_with_openings() {
  return bricks(40, 20, 3, Vec3(0.1f), [](int x, int y, int) {
    bool window = x >= 8 && x < 18 && y >= 8 && y < 15, door = x >= 26 && x < 32 && y < 14;
    return !window && !door;
  });
}

/// A floor that meets a wall.
inline Surface corner() {
  return bricks(20, 20, 20, Vec3(0.1f), [](int, int y, int z) { return y < 2 || z < 3; });
}

inline Surface bumpy_rock(int detail = 6) { return stone_surface({Seed{11}, 1.0, 0.2}, detail); }

/// A rock as a poor scan gives it: noise on each vertex, triangles that share none, some flipped, some
/// missing, some twice, some without area.
inline Surface scanned(Seed seed) {
  Surface rock = stone_surface({Seed{5}, 0.8, 0.1}, 5), s;
  for (std::size_t i = 0; i < rock.position.size(); ++i)
    rock.position[i] += noise3(rock.position[i] * 40.0f) * 0.003f;
  for (std::size_t t = 0; t < rock.triangle.size(); ++t) {
    Seed own = seed.child("scan", t);
    Vec3 middle = rock.position[rock.triangle[t][0]];
    bool hole = noise(middle * 5.0f + Vec3(31)) > 0.72;
    if (hole || own.child("missing").unit() < 0.001) continue;
    auto [a, b, c] = rock.triangle[t];
    if (own.child("flipped").unit() < 0.3) std::swap(b, c);
    int times = own.child("twice").unit() < 0.05 ? 2 : 1;
    for (int k = 0; k < times; ++k) {
      auto first = static_cast<std::uint32_t>(s.position.size());
      for (auto v : {a, b, c}) s.position.push_back(rock.position[v]);
      s.triangle.push_back({first, first + 1, first + 2});
      if (own.child("flat").unit() < 0.05) s.triangle.push_back({first, first + 1, first + 1});
    }
  }
  set_normals(s);
  return s;
}

}  // namespace frond
