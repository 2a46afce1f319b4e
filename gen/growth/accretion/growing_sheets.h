#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "accretion/margin.h"
#include "core/cell_grid.h"

// Private to margin.h.

namespace frond {

/// Whether the segment between two points crosses a triangle (Moeller and Trumbore 1997).
inline bool goes_through(Vec3 from, Vec3 to, const std::array<Vec3, 3>& triangle) {
  DVec3 start(from), corner(triangle[0]), segment = DVec3(to) - start, e1 = DVec3(triangle[1]) - corner,
                                          e2 = DVec3(triangle[2]) - corner, h = glm::cross(segment, e2);
  double volume = glm::dot(e1, h);
  if (std::abs(volume) < 1e-18) return false;
  DVec3 off = start - corner, k = glm::cross(off, e1);
  double u = glm::dot(off, h) / volume, v = glm::dot(segment, k) / volume, share = glm::dot(e2, k) / volume;
  return u >= 0 && v >= 0 && u + v <= 1 && share >= 0 && share <= 1;
}

/// The bounding box of a triangle, low and high.
template <class Place>
std::array<Vec3, 2> box_of(const std::array<std::uint32_t, 3>& t, const Place& place) {
  Vec3 a = place(t[0]), b = place(t[1]), c = place(t[2]);
  return {glm::min(glm::min(a, b), c), glm::max(glm::max(a, b), c)};
}

inline bool boxes_meet(const std::array<Vec3, 2>& a, const std::array<Vec3, 2>& b) {
  return a[0].x <= b[1].x && b[0].x <= a[1].x && a[0].y <= b[1].y && b[0].y <= a[1].y && a[0].z <= b[1].z &&
         b[0].z <= a[1].z;
}

/// Whether two triangles intersect anywhere but at shared corners. `place(v)` is the position of a vertex.
template <class Place>
bool triangles_cross(const std::array<std::uint32_t, 3>& one, const std::array<std::uint32_t, 3>& other,
                     const Place& place) {
  std::array<Vec3, 3> p{place(one[0]), place(one[1]), place(one[2])},
      q{place(other[0]), place(other[1]), place(other[2])};
  auto shared = [](std::uint32_t v, const std::array<std::uint32_t, 3>& t) {
    return v == t[0] || v == t[1] || v == t[2];
  };
  for (std::size_t k = 0; k < 3; ++k) {
    std::size_t next = k == 2 ? 0 : k + 1;
    if (!shared(one[k], other) && !shared(one[next], other) && goes_through(p[k], p[next], q)) return true;
    if (!shared(other[k], one) && !shared(other[next], one) && goes_through(q[k], q[next], p)) return true;
  }
  return false;
}

inline constexpr float kRimPace = 0.8f;  // width of a row, in edges
inline constexpr int kRimRounds = 8;     // rounds of relaxation
inline constexpr float kRimBow = 0.55f;  // a sheet bends to a half circle at most: chord by arc, a bit less
inline constexpr float kRimStill = 0.125f;  // share of the full pace; a slower vertex has stopped for good
inline constexpr std::uint32_t kRimNobody = ~0u;

/// One rim while it grows.
struct GrowingRim {
  std::vector<std::uint32_t> vertex{};
  std::vector<Vec3> heading{};
  std::vector<float> pace{};  // 1 full speed, 0 stopped
  bool closed = false;
  bool tube = false;  // closed, with nothing inside
  std::uint32_t sheet = 0;
  int first = 0, last = 0;  // rows

  std::size_t size() const { return vertex.size(); }
  std::size_t next(std::size_t i) const { return i + 1 < size() ? i + 1 : closed ? 0 : i; }
  std::size_t prior(std::size_t i) const { return i > 0 ? i - 1 : closed ? size() - 1 : i; }
};

/// A vertex that keeps a vertex of the rim away.
struct RimRival {
  std::uint32_t who;
  float distance;  // metres, the least distance to keep from it
};

/// A row before it is added to the sheet. Its vertices are numbered after the existing ones.
struct RimRow {
  struct Vertex {
    Vec3 at;
    std::array<std::uint32_t, 2> parents;
    float distance, u;
  };
  std::vector<Vertex> vertex{};
  std::vector<std::array<std::uint32_t, 3>> triangle{};
  std::vector<std::size_t> gap{};  // of each triangle, the rim position that it stands on, up to the next
  GrowingRim after{};              // the rim after this row
};

/// Sheets while they grow.
class GrowingSheets {
 public:
  GrowingSheets(const Margin& law, const MarginWorld& world, Seed seed)
      : law_(law),
        world_(world),
        edge_(static_cast<float>(law.edge)),
        step_(kRimPace * edge_),
        clearance_(std::max(static_cast<float>(law.clearance), 1.5f * edge_)),
        grid_(clearance_ + 2 * step_),
        skin_(1.5f * edge_) {
    for (int axis = 0; axis < 3; ++axis)
      lot_[axis] = static_cast<float>(seed.child("lobes", static_cast<std::uint64_t>(axis)).range(-99, 99));
    sheet_.rows = std::max(2, static_cast<int>(law.reach / step_));
  }

  void start(const MarginStart& start, std::uint32_t sheet);
  Sheet grow() &&;

 private:
  std::uint32_t add(Vec3 at, std::array<std::uint32_t, 2> parents, float row, float distance, float u,
                    std::uint32_t sheet);
  void advance(GrowingRim& rim, int row);
  void set_paces(GrowingRim& rim);
  void aim(GrowingRim& rim);
  void look_round(const GrowingRim& rim);
  void relax(const GrowingRim& rim);
  void keep_away(std::size_t i);
  bool is_kinked(const GrowingRim& rim, std::size_t i) const;
  void stop_what_collides(GrowingRim& rim);
  RimRow plan(const GrowingRim& rim) const;
  void fill(const GrowingRim& rim, RimRow& row, const std::vector<std::uint32_t>& above) const;
  bool stop_what_crosses(GrowingRim& rim, const RimRow& plan);
  void lay(GrowingRim& rim, RimRow&& plan, int row);

  const Margin& law_;
  const MarginWorld& world_;
  float edge_, step_, clearance_;
  Vec3 lot_{0};
  Sheet sheet_;
  std::vector<float> u_;              // of each vertex, along the rim
  std::vector<std::uint32_t> owner_;  // the sheet of each vertex
  std::vector<std::uint32_t> seat_;   // of each vertex, its index on the rim that grows now
  std::vector<GrowingRim> rims_;
  CellGrid grid_;  // of vertices
  CellGrid skin_;  // of triangles
  // One entry for each vertex of the rim that grows now:
  std::vector<Vec3> from_, to_, aim_, tangent_, shift_;
  std::vector<float> rest_, arc_, thread_;
  std::vector<std::vector<RimRival>> rivals_;
};

}  // namespace frond
