#include "rocks/blob_cells.h"

#include <cassert>

#include "core/parallel.h"

namespace frond {

namespace {

constexpr int kCoarsest = 3;              // so that the outermost cells are free of the surface
constexpr std::size_t kCellsATask = 512;  // cells that one thread looks at in one go
constexpr double kReachOfTriangle = 1.5;  // the longest edge of a triangle, in widths of the cell, about

enum class Verdict : std::uint8_t { leaf, clear, split };

/// Grows a tree of cells level by level.
struct Cutter {
  const Blobs& shape;
  const CellOptions& options;
  BlobCells& cells;

  bool in(const DVec3& p) const { return field_value(shape, p) > 0; }

  /// Whether f runs on along one direction in all of a box twice as wide.
  bool certain(const Box& box) const {
    DVec3 inward = field_gradient(shape, box.middle());
    double length = glm::length(inward);
    if (!(length > 0)) return false;
    DVec3 more = box.size() * 0.5;
    return field_slope_range(shape, {box.low - more, box.high + more}, inward / length).low > 0;
  }

  /// Whether triangles as large as the cell are near enough to the surface.
  bool flat(const Box& box) const {
    if (options.tolerance <= 0) return false;
    double edge = kReachOfTriangle * box.size().x;
    return field_curvature(shape, box.middle()) * edge * edge / 8 <= options.tolerance * cells.size;
  }

  Verdict judge(BlobCells::Cell& cell) const {
    Box box = cells.box(cell);
    Interval range = field_range(shape, box);
    cell.clear = !range.holds(0);
    cell.inside = cell.clear ? range.low > 0 : in(box.middle());
    if (cell.clear) return cell.level < kCoarsest ? Verdict::split : Verdict::clear;
    if (cell.level < kCoarsest) return Verdict::split;
    if (cell.level >= BlobCells::kDeepest) return Verdict::leaf;
    if (cell.level < options.depth && !flat(box)) return Verdict::split;
    return certain(box) ? Verdict::leaf : Verdict::split;
  }

  /// Makes the eight cells of one; they lie in a row at the end.
  void split(std::size_t index) {
    auto first = static_cast<std::int32_t>(cells.cell.size());
    BlobCells::Cell parent = cells.cell[index];
    cells.cell[index].child = first;
    for (unsigned i = 0; i < 8; ++i) {
      BlobCells::Cell cell;
      cell.level = static_cast<std::uint8_t>(parent.level + 1);
      for (unsigned axis = 0; axis < 3; ++axis)
        cell.at[axis] = static_cast<std::uint16_t>(2u * parent.at[axis] + (i >> axis & 1u));
      cell.inside = parent.inside;
      cell.clear = parent.clear;
      cells.cell.push_back(cell);
    }
  }

  void cut() {
    std::vector<Verdict> verdicts;
    for (std::size_t from = 0, to = 1; from < to; from = to, to = cells.cell.size()) {
      verdicts.assign(to - from, Verdict::leaf);
      parallel_for((to - from + kCellsATask - 1) / kCellsATask, [&](std::size_t share) {
        for (std::size_t i = share * kCellsATask; i < std::min((share + 1) * kCellsATask, to - from); ++i)
          verdicts[i] = judge(cells.cell[from + i]);
      });
      for (std::size_t i = 0; i < to - from; ++i)
        if (verdicts[i] == Verdict::split) split(from + i);
    }
  }

  /// Sees to it that there is a cell of that level, or finer ones, at that place.
  void provide(int x, int y, int z, int level, std::vector<std::vector<std::size_t>>& parents) {
    int side = 1 << level;
    if (x < 0 || y < 0 || z < 0 || x >= side || y >= side || z >= side) return;
    std::size_t index = 0;
    for (int l = 0; l < level; ++l) {
      if (cells.cell[index].child < 0) {
        split(index);
        parents[l].push_back(index);
        if (!cells.cell[index].clear)
          for (std::size_t i = 0; i < 8; ++i)
            judge(cells.cell[static_cast<std::size_t>(cells.cell[index].child) + i]);
      }
      int bit = level - 1 - l;
      index = static_cast<std::size_t>(cells.cell[index].child + (x >> bit & 1) + 2 * (y >> bit & 1) +
                                       4 * (z >> bit & 1));
    }
  }

  /// Splits neighbours until none is more than one level finer than another, over faces and edges: a split
  /// cell has neighbours of its own size.
  void balance() {
    std::vector<std::vector<std::size_t>> parents(BlobCells::kDeepest + 1);
    for (std::size_t i = 0; i < cells.cell.size(); ++i)
      if (cells.cell[i].child >= 0) parents[cells.cell[i].level].push_back(i);
    for (std::size_t level = parents.size(); level-- > 0;) {
      for (std::size_t k = 0; k < parents[level].size(); ++k) {
        auto at = cells.cell[parents[level][k]].at;
        for (int i = 0; i < 27; ++i) {
          int x = i % 3 - 1, y = i / 3 % 3 - 1, z = i / 9 - 1;
          if (x * x + y * y + z * z == 3 || i == 13) continue;
          provide(at[0] + x, at[1] + y, at[2] + z, static_cast<int>(level), parents);
        }
      }
    }
  }
};

}  // namespace

Box BlobCells::box(const Cell& c) const {
  assert(c.level <= kDeepest && c.at[0] < 1u << c.level && c.at[1] < 1u << c.level &&
         c.at[2] < 1u << c.level);
  DVec3 width = root.size() / static_cast<double>(1 << c.level);
  DVec3 low = root.low + width * DVec3(c.at[0], c.at[1], c.at[2]);
  return {low, low + width};
}

BlobCells cut_cells(const Blobs& shape, const CellOptions& options) {
  assert(options.depth >= 1 && options.depth <= 10 && shape.level > 0);
  BlobCells cells;
  Box bounds = field_bounds(shape);
  DVec3 size = bounds.size();
  cells.size = std::max(size.x, std::max(size.y, size.z));
  if (!(cells.size > 0)) return cells;
  // The middles of the outermost cells, which are 1/8 of the whole or less, lie outside of the surface.
  double half = cells.size * 0.5 * 8 / 7 * 1.001;
  cells.root = {bounds.middle() - half, bounds.middle() + half};
  cells.cell.emplace_back();
  Cutter cutter{shape, options, cells};
  cutter.cut();
  cutter.balance();
  return cells;
}

}  // namespace frond
