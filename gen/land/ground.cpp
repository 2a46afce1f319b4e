#include "land/ground.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "core/bytes.h"
#include "core/noise.h"

namespace frond {

double ground_height(const Ground& ground, double x, double z) {
  Vec3 shift(static_cast<float>(ground.seed.child("x").range(-99, 99)), 0,
             static_cast<float>(ground.seed.child("z").range(-99, 99)));
  Vec3 p(static_cast<float>(x / ground.scale), 0, static_cast<float>(z / ground.scale));
  return 0.7 * ground.relief * fractal_noise(p + shift, 3);
}

Surface ground_surface(const Ground& ground, Vec2 centre, double radius, int rings) {
  auto height = [&](Vec2 at) {
    return ground_height(ground, at.x, at.y) *
           (1 - smooth_step(0.6, 1.0, glm::distance(at, centre) / radius));
  };
  return ground_surface(height, centre, radius, rings);
}

Surface ground_surface(const std::function<double(Vec2)>& height, Vec2 centre, double radius, int rings) {
  assert(rings >= 2);
  Surface surface;
  int sectors = rings * 2;
  surface.position.push_back(Vec3(centre.x, height(centre), centre.y));
  for (int ring = 1; ring <= rings; ++ring) {
    double share = static_cast<double>(ring) / rings;
    double distance = radius * share * share;
    for (int sector = 0; sector < sectors; ++sector) {
      double angle = 2 * kPi * (sector + 0.5 * (ring % 2)) / sectors;
      Vec2 at = centre + Vec2(static_cast<float>(distance * std::cos(angle)),
                              static_cast<float>(distance * std::sin(angle)));
      surface.position.push_back(Vec3(at.x, height(at), at.y));
    }
  }
  auto vertex = [&](int ring, int sector) {
    return ring == 0 ? 0u
                     : static_cast<std::uint32_t>(1 + (ring - 1) * sectors + (sector + sectors) % sectors);
  };
  for (int sector = 0; sector < sectors; ++sector)
    surface.triangle.push_back({vertex(0, 0), vertex(1, sector + 1), vertex(1, sector)});
  for (int ring = 1; ring < rings; ++ring) {
    for (int sector = 0; sector < sectors; ++sector) {
      // Odd rings are turned by half a sector, so that triangles stay near equilateral.
      int shift = ring % 2;
      auto a = vertex(ring, sector), b = vertex(ring, sector + 1);
      auto c = vertex(ring + 1, sector + shift), d = vertex(ring + 1, sector + shift + 1);
      if (shift) {
        surface.triangle.push_back({a, b, c});
        surface.triangle.push_back({b, d, c});
      } else {
        surface.triangle.push_back({a, d, c});
        surface.triangle.push_back({a, b, d});
      }
    }
  }
  set_normals(surface);
  return surface;
}

namespace {

constexpr int kCells = 64;                             // along x and z, the origin in the middle
constexpr std::array<double, 2> kCellSides{1.0, 8.0};  // metres

int cell_of(double x, double side) { return static_cast<int>(std::floor(x / side)) + kCells / 2; }

/// The height of a triangle at (x, z), if it is there.
std::optional<double> height_at(const std::array<Vec3, 3>& triangle, double x, double z) {
  const auto& [p, q, r] = triangle;
  double qx = q.x - p.x, qz = q.z - p.z, rx = r.x - p.x, rz = r.z - p.z, dx = x - p.x, dz = z - p.z;
  double area = qx * rz - qz * rx;
  if (area == 0) return {};
  double s = (dx * rz - dz * rx) / area, t = (qx * dz - qz * dx) / area;
  if (s < -1e-9 || t < -1e-9 || s + t > 1 + 1e-9) return {};
  return p.y + s * (q.y - p.y) + t * (r.y - p.y);
}

}  // namespace

Heights::Heights(const Surface& surface) {
  for (auto& cells : cells_) cells.resize(kCells * kCells);
  for (auto [a, b, c] : surface.triangle) {
    std::array<Vec3, 3> triangle{surface.position[a], surface.position[b], surface.position[c]};
    const auto& [p, q, r] = triangle;
    Vec3 low = glm::min(p, glm::min(q, r)), high = glm::max(p, glm::max(q, r));
    auto id = static_cast<std::uint32_t>(triangles_.size());
    for (std::size_t k = 0; k < kCellSides.size(); ++k) {
      auto first = [&](float x) { return std::max(0, cell_of(x, kCellSides[k])); };
      auto last = [&](float x) { return std::min(kCells - 1, cell_of(x, kCellSides[k])); };
      for (int row = first(low.z); row <= last(high.z); ++row)
        for (int column = first(low.x); column <= last(high.x); ++column)
          cells_[k][static_cast<std::size_t>(row * kCells + column)].push_back(id);
    }
    triangles_.push_back(triangle);
  }
}

double Heights::operator()(double x, double z) const {
  if (known_) return known_(x, z);
  for (std::size_t k = 0; k < kCellSides.size() && !cells_[k].empty(); ++k) {
    int row = cell_of(z, kCellSides[k]), column = cell_of(x, kCellSides[k]);
    if (row < 0 || row >= kCells || column < 0 || column >= kCells) continue;
    for (std::uint32_t id : cells_[k][static_cast<std::size_t>(row * kCells + column)])
      if (std::optional<double> height = height_at(triangles_[id], x, z)) return *height;
    return 0;
  }
  for (const auto& triangle : triangles_)
    if (std::optional<double> height = height_at(triangle, x, z)) return *height;
  return 0;
}

std::size_t Heights::bytes() const {
  std::size_t bytes = bytes_of(triangles_);
  for (const auto& grid : cells_) {
    bytes += bytes_of(grid);
    for (const auto& cell : grid) bytes += bytes_of(cell);
  }
  return bytes;
}

}  // namespace frond
