#include "land/ground.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "core/bytes.h"
#include "core/noise.h"

namespace frond {

double ground_height(const Ground& ground, double x, double z) {
  Vec3 shift(ground.seed.child("x").range(-99, 99), 0, ground.seed.child("z").range(-99, 99));
  Vec3 p(x / ground.scale, 0, z / ground.scale);
  return 0.7 * ground.relief * fractal_noise(p + shift, 3);
}

GroundDisc GroundDisc::reaching(double reach, double most) const {
  double within = std::clamp(reach, radius, most);
  return {within, static_cast<int>(std::lround(rings * std::sqrt(within / radius))), reach};
}

namespace {

/// Distances of the rings of a disc from its middle, from the first to its edge.
std::vector<double> ring_distances(const GroundDisc& disc) {
  std::vector<double> distances;
  for (int ring = 1; ring <= disc.rings; ++ring) {
    double share = static_cast<double>(ring) / disc.rings;
    distances.push_back(disc.radius * share * share);
  }
  if (disc.beyond <= disc.radius) return distances;
  double logs = std::log(disc.beyond / disc.radius);
  int more = std::max(1, static_cast<int>(std::ceil(logs / std::log(1 + 2.0 / disc.rings))));
  for (int ring = 1; ring <= more; ++ring) distances.push_back(disc.radius * std::exp(logs * ring / more));
  return distances;
}

constexpr int kCells = 128;  // along x and z, the origin in the middle
constexpr int kWider = 4;    // times the squares of the next grid
constexpr double kFinestSquare =
    1.0 / 64;  // metres, the squares of the first, as meshes are finest in their middle
constexpr std::size_t kSquares = std::size_t{kCells} * kCells;  // of a grid

/// The number of a square; far out of the grid the nearest that is outside of it.
int cell_of(double x, double side) {
  return static_cast<int>(std::clamp(std::floor(x / side) + kCells / 2, -1.0, double{kCells}));
}

/// Whether a square is one of those that the grid within covers.
bool is_inner(int cell) { return std::abs(2 * cell + 1 - kCells) < kCells / kWider; }

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

Surface ground_surface(const Ground& ground, Vec2 centre, const GroundDisc& disc) {
  double radius = std::max(disc.radius, disc.beyond);
  auto height = [&](Vec2 at) {
    return ground_height(ground, at.x, at.y) *
           (1 - smooth_step(0.6, 1.0, glm::distance(at, centre) / radius));
  };
  return ground_surface(height, centre, disc);
}

Surface ground_surface(const std::function<double(Vec2)>& height, Vec2 centre, const GroundDisc& disc) {
  assert(disc.rings >= 2);
  Surface surface;
  int sectors = disc.rings * 2;
  std::vector<double> distances = ring_distances(disc);
  int rings = static_cast<int>(distances.size());
  surface.position.push_back(Vec3(centre.x, height(centre), centre.y));
  for (int ring = 1; ring <= rings; ++ring) {
    double distance = distances[static_cast<std::size_t>(ring - 1)];
    for (int sector = 0; sector < sectors; ++sector) {
      double angle = 2 * kPi * (sector + 0.5 * (ring % 2)) / sectors;
      Vec2 at = centre + Vec2(distance * std::cos(angle), distance * std::sin(angle));
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

Heights::Heights(const Surface& surface) {
  float reach = 0;
  for (const Vec3& at : surface.position) reach = std::max({reach, std::abs(at.x), std::abs(at.z)});
  std::vector<double> sides{kFinestSquare};  // metres, of the squares of each grid
  while (sides.back() * (kCells / 2) <= static_cast<double>(reach)) sides.push_back(kWider * sides.back());
  cells_[0].resize(kSquares), cells_[1].resize(kSquares * (sides.size() - 1));
  for (auto [a, b, c] : surface.triangle) {
    std::array<Vec3, 3> triangle{surface.position[a], surface.position[b], surface.position[c]};
    const auto& [p, q, r] = triangle;
    Vec3 low = glm::min(p, glm::min(q, r)), high = glm::max(p, glm::max(q, r));
    auto id = static_cast<std::uint32_t>(triangles_.size());
    for (std::size_t k = 0; k < sides.size(); ++k) {
      auto first = [&](float x) { return std::max(0, cell_of(x, sides[k])); };
      auto last = [&](float x) { return std::min(kCells - 1, cell_of(x, sides[k])); };
      for (int row = first(low.z); row <= last(high.z); ++row)
        for (int column = first(low.x); column <= last(high.x); ++column) {
          auto cell = static_cast<std::size_t>(row * kCells + column);
          if (k == 0)
            cells_[0][cell].push_back(id);
          else if (!is_inner(row) || !is_inner(column))
            cells_[1][(k - 1) * kSquares + cell].push_back(id);
        }
    }
    triangles_.push_back(triangle);
  }
}

double Heights::operator()(double x, double z) const {
  if (known_) return known_(x, z);
  double side = kFinestSquare;
  std::size_t grids = (cells_[0].size() + cells_[1].size()) / kSquares;
  for (std::size_t k = 0; k < grids; ++k, side *= kWider) {
    int row = cell_of(z, side), column = cell_of(x, side);
    if (row < 0 || row >= kCells || column < 0 || column >= kCells) continue;
    auto cell = static_cast<std::size_t>(row * kCells + column);
    for (std::uint32_t id : k == 0 ? cells_[0][cell] : cells_[1][(k - 1) * kSquares + cell])
      if (std::optional<double> height = height_at(triangles_[id], x, z)) return *height;
    return 0;
  }
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
