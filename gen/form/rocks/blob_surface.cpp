#include "rocks/blob_surface.h"

#include <cassert>
#include <cmath>
#include <span>
#include <utility>

#include "core/parallel.h"
#include "rocks/cube_loops.h"

namespace frond {

namespace {

constexpr std::uint32_t kNone = ~std::uint32_t{0};
constexpr std::size_t kPairsATask = 1024;  // vertices that one thread works on in one go

/// A number for each pair of cells that the surface runs between. Open addressing.
class Crossings {
 public:
  Crossings() : slot_(1 << 12, kNone) {}

  std::uint32_t between(std::uint32_t a, std::uint32_t b) {
    if (2 * pairs_.size() >= slot_.size()) grow();
    if (a > b) std::swap(a, b);
    std::uint32_t& place = find(a, b);
    if (place == kNone) {
      place = static_cast<std::uint32_t>(pairs_.size());
      pairs_.emplace_back(a, b);
    }
    return place;
  }
  const std::vector<std::pair<std::uint32_t, std::uint32_t>>& pairs() const { return pairs_; }

 private:
  std::uint32_t& find(std::uint32_t a, std::uint32_t b) {
    std::size_t mask = slot_.size() - 1, i = Seed::mix((std::uint64_t{a} << 32) | b) & mask;
    while (slot_[i] != kNone && pairs_[slot_[i]] != std::pair(a, b)) i = (i + 1) & mask;
    return slot_[i];
  }
  void grow() {
    slot_.assign(slot_.size() * 2, kNone);
    for (std::uint32_t n = 0; n < pairs_.size(); ++n) find(pairs_[n].first, pairs_[n].second) = n;
  }
  std::vector<std::uint32_t> slot_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs_;
};

/// A corner of a loop: a vertex, and the face of its cube through which the loop goes on.
struct Corner {
  std::uint32_t vertex;
  std::uint8_t face;
};

/// Walks the octree and lists the loops of all dual cubes.
struct Tracer {
  const BlobCells& cells;
  Crossings crossings;
  std::vector<Corner> corners;
  std::vector<std::size_t> first{0};  ///< of each loop, in `corners`, and the end

  /// What lies round a vertex (split = 7), an edge, a face, or within a cell (split = 0) of the octree: slot
  /// i has the cell on the upper side of each axis in i. Only the axes in `split` tell slots apart.
  using Slots = std::array<std::uint32_t, 8>;

  void walk(const Slots& slots, unsigned split) {
    bool leaves = true, some = false, all = true;
    for (std::uint32_t s : slots) {
      const BlobCells::Cell& cell = cells.cell[s];
      leaves = leaves && cell.child < 0;
      some = some || cell.inside;
      all = all && cell.inside;
    }
    if (leaves) {
      if (split == 7 && some && !all) trace(slots);
      return;
    }
    // Each axis that is not split yet is cut in a lower half, an upper half and the plane between them.
    static constexpr int kCases[4] = {1, 3, 9, 27};
    unsigned free[3], count = 0;
    for (unsigned axis = 0; axis < 3; ++axis)
      if ((split >> axis & 1) == 0) free[count++] = axis;
    for (int choice = 0; choice < kCases[count]; ++choice) {
      unsigned upper = 0, now = split;
      for (int k = 0, rest = choice; k < static_cast<int>(count); ++k, rest /= 3) {
        if (rest % 3 == 1) upper |= 1u << free[k];
        if (rest % 3 == 2) now |= 1u << free[k];
      }
      Slots finer{};
      for (unsigned i = 0; i < 8; ++i) {
        const BlobCells::Cell& cell = cells.cell[slots[i & split]];
        // At planes that are split already the nearest child lies on the far side of its parent's.
        unsigned child = ((i ^ 7u) & split) | (i & now & ~split) | upper;
        finer[i] = cell.child < 0 ? slots[i & split] : static_cast<std::uint32_t>(cell.child) + child;
      }
      walk(finer, now);
    }
  }

  void trace(const Slots& slots) {
    unsigned inside = 0;
    for (unsigned i = 0; i < 8; ++i) inside |= static_cast<unsigned>(cells.cell[slots[i]].inside) << i;
    for (const CubeLoops::Loop& loop : CubeLoops::table()[inside]) {
      std::size_t start = first.back();
      for (CubeLoops::Step step : loop) {
        auto [a, b] = CubeLoops::edges()[step.edge];
        std::uint32_t vertex = crossings.between(slots[a], slots[b]);
        // Where corners of the cube coincide so do edges.
        if (corners.size() > start && corners.back().vertex == vertex)
          corners.back().face = step.face;
        else
          corners.push_back({vertex, step.face});
      }
      if (corners.size() > start + 1 && corners.back().vertex == corners[start].vertex) corners.pop_back();
      if (corners.size() < start + 3)
        corners.resize(start);
      else
        first.push_back(corners.size());
    }
  }
};

/// Where f is 0 between a place inside and one outside: false position with the halving of Illinois
/// (Dowell and Jarratt 1971).
DVec3 root_between(const Blobs& shape, DVec3 in, DVec3 out) {
  double low = 0, high = 1, at_low = field_value(shape, in), at_high = field_value(shape, out), t = 0;
  if (at_low <= 0) return in;
  if (at_high >= 0) return out;
  double enough = 1e-8 * (at_low - at_high);  // far below what single precision tells apart
  for (int i = 0, last = 0; i < 60 && high - low > 1e-10; ++i) {
    t = low + (high - low) * at_low / (at_low - at_high);
    double value = field_value(shape, glm::mix(in, out, t));
    if (std::abs(value) < enough) break;
    if (value > 0) {
      low = t, at_low = value;
      if (last > 0) at_high /= 2;
      last = 1;
    } else {
      high = t, at_high = value;
      if (last < 0) at_low /= 2;
      last = -1;
    }
  }
  return glm::mix(in, out, t);
}

/// The surface point that a place near it falls to along the gradient (Newton); the place itself where it
/// would go farther than `reach`.
DVec3 fall_onto(const Blobs& shape, const DVec3& place, double reach) {
  DVec3 p = place;
  for (int i = 0; i < 4; ++i) {
    DVec3 gradient = field_gradient(shape, p);
    double steep2 = glm::dot(gradient, gradient);
    if (!(steep2 > 0)) return place;
    p -= gradient * (field_value(shape, p) / steep2);
    if (!(glm::distance(p, place) < reach)) return place;
  }
  return p;
}

/// Makes triangles of loops.
struct Filler {
  const Blobs& shape;
  const Tracer& tracer;
  const std::vector<DVec3>& place;
  Surface& surface;

  void add_vertex(const DVec3& p, const DVec3& otherwise) {
    DVec3 n = -field_gradient(shape, p);
    double length = glm::length(n);
    surface.position.emplace_back(p);
    surface.normal.push_back(length > 0 ? Vec3(n / length) : Vec3(otherwise));
  }

  /// Whether a diagonal of a loop runs within a face of its cube, where the cube next to it might have the
  /// same.
  static bool in_face(std::span<const Corner> loop, std::size_t i, std::size_t k) {
    std::size_t n = loop.size();
    std::uint8_t a = loop[(i + n - 1) % n].face, b = loop[i].face;
    std::uint8_t c = loop[(k + n - 1) % n].face, d = loop[k].face;
    return a == c || a == d || b == c || b == d;
  }

  void fill_four(std::span<const Corner> loop) {
    assert(loop.size() == 4);
    auto [a, b, c, d] = std::array{loop[0].vertex, loop[1].vertex, loop[2].vertex, loop[3].vertex};
    bool ac = !in_face(loop, 0, 2), bd = !in_face(loop, 1, 3);
    if (ac && bd) ac = glm::distance(place[a], place[c]) <= glm::distance(place[b], place[d]);
    if (!ac && !bd) return fill_round(loop);
    if (ac)
      surface.triangle.insert(surface.triangle.end(), {{a, b, c}, {a, c, d}});
    else
      surface.triangle.insert(surface.triangle.end(), {{a, b, d}, {b, c, d}});
  }

  /// Round a vertex of its own in the middle.
  void fill_round(std::span<const Corner> loop) {
    assert(loop.size() >= 3);
    DVec3 sum(0), area(0);
    double reach = 0;
    for (Corner c : loop) sum += place[c.vertex];
    sum /= static_cast<double>(loop.size());
    for (std::size_t i = 0; i < loop.size(); ++i) {
      DVec3 a = place[loop[i].vertex] - sum, b = place[loop[(i + 1) % loop.size()].vertex] - sum;
      area += glm::cross(a, b);
      reach = std::max(reach, glm::length(a));
    }
    auto middle = static_cast<std::uint32_t>(surface.position.size());
    double length = glm::length(area);
    add_vertex(fall_onto(shape, sum, reach), length > 0 ? area / length : DVec3(0, 1, 0));
    for (std::size_t i = 0; i < loop.size(); ++i)
      surface.triangle.push_back({loop[i].vertex, loop[(i + 1) % loop.size()].vertex, middle});
  }

  void fill() {
    for (std::size_t i = 0; i + 1 < tracer.first.size(); ++i) {
      std::span<const Corner> loop(tracer.corners.data() + tracer.first[i],
                                   tracer.first[i + 1] - tracer.first[i]);
      if (loop.size() == 3)
        surface.triangle.push_back({loop[0].vertex, loop[1].vertex, loop[2].vertex});
      else if (loop.size() == 4)
        fill_four(loop);
      else
        fill_round(loop);
    }
  }
};

}  // namespace

Surface blob_surface(const Blobs& shape, const CellOptions& options) {
  return blob_surface(shape, cut_cells(shape, options));
}

Surface blob_surface(const Blobs& shape, const BlobCells& cells) {
  Surface surface;
  if (cells.cell.empty()) return surface;
  Tracer tracer{cells, {}, {}};
  tracer.walk({}, 0);

  const auto& pairs = tracer.crossings.pairs();
  std::vector<DVec3> place(pairs.size());
  surface.position.resize(pairs.size());
  surface.normal.resize(pairs.size());
  parallel_for((pairs.size() + kPairsATask - 1) / kPairsATask, [&](std::size_t share) {
    for (std::size_t i = share * kPairsATask; i < std::min((share + 1) * kPairsATask, pairs.size()); ++i) {
      const BlobCells::Cell *in = &cells.cell[pairs[i].first], *out = &cells.cell[pairs[i].second];
      if (!in->inside) std::swap(in, out);
      assert(in->inside && !out->inside && "a crossing lies between inside and outside");
      DVec3 from = cells.box(*in).middle(), to = cells.box(*out).middle();
      place[i] = root_between(shape, from, to);
      DVec3 n = -field_gradient(shape, place[i]);
      double length = glm::length(n);
      surface.position[i] = place[i];
      surface.normal[i] = length > 0 ? n / length : glm::normalize(to - from);
    }
  });
  Filler{shape, tracer, place, surface}.fill();
  return surface;
}

}  // namespace frond
