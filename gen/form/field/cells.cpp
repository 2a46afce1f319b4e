#include "field/cells.h"

#include <vector>

namespace frond {

namespace {

constexpr int kFine = -1;

std::size_t index_in(Cell cell) {
  return static_cast<std::size_t>((cell.i & 7) << 6 | (cell.j & 7) << 3 | (cell.k & 7));
}

/// The candidate, a cell, that has the most neighbours in a window; the first one of several.
int most_held(unsigned window, std::initializer_list<int> candidates) {
  int best = kFine, most = -1;
  for (int c : candidates) {
    int held = 0;
    for (int axis : {1, 2, 4}) held += static_cast<int>(window >> (c ^ axis) & 1);
    if (held > most) best = c, most = held;
  }
  return best;
}

/// What to add to a window of 2 x 2 x 2 cells, bit 4 i + 2 j + k each, where cells of it touch along an edge
/// or at a corner alone, or the cells that are not there do.
int missing_in(unsigned window) {
  auto is = [&](int c) { return (window >> c & 1) != 0; };
  for (int axis : {1, 2, 4}) {
    int one = axis == 1 ? 2 : 1, other = axis == 4 ? 2 : 4;
    for (int base : {0, axis}) {
      int a = base, b = base | one, c = base | other, d = base | one | other;
      if (is(a) && is(d) && !is(b) && !is(c)) return most_held(window, {b, c});
      if (is(b) && is(c) && !is(a) && !is(d)) return most_held(window, {a, d});
    }
  }
  for (int c = 0; c < 4; ++c) {
    unsigned pair = 1u << c | 1u << (7 - c);
    if (window == pair) return most_held(window, {c ^ 1, c ^ 2, c ^ 4});
    if (window == (~pair & 255u)) return c;
  }
  return kFine;
}

constexpr Cell part_of_window(Cell low, int c) {
  return {low.i + (c >> 2 & 1), low.j + (c >> 1 & 1), low.k + (c & 1)};
}

}  // namespace

const CellSet::Mask* CellSet::block(std::uint64_t key) const {
  if (key != last_key_) {
    auto at = blocks_.find(key);
    last_key_ = key, last_ = at == blocks_.end() ? nullptr : &at->second;
  }
  return last_;
}

void CellSet::add(Cell cell) {
  std::uint64_t key = block_key(cell);
  std::size_t i = index_in(cell);
  Mask& mask = blocks_[key];
  mask[i >> 6] |= std::uint64_t{1} << (i & 63);
  last_key_ = key, last_ = &mask;
}

bool CellSet::holds(Cell cell) const {
  const Mask* mask = block(block_key(cell));
  std::size_t i = index_in(cell);
  return mask && ((*mask)[i >> 6] >> (i & 63) & 1);
}

void mend_contacts(CellSet& cells) {
  std::vector<int> missing;
  for (unsigned window = 0; window < 256; ++window) missing.push_back(missing_in(window));
  std::vector<Cell> open;
  cells.visit([&](Cell cell) {
    bool inner = true;
    for (int d : {-1, 1})
      inner = inner && cells.holds({cell.i + d, cell.j, cell.k}) &&
              cells.holds({cell.i, cell.j + d, cell.k}) && cells.holds({cell.i, cell.j, cell.k + d});
    if (!inner) open.push_back(cell);
  });
  while (!open.empty()) {
    Cell cell = open.back();
    open.pop_back();
    for (int c = 0; c < 8; ++c) {
      Cell low = part_of_window({cell.i - 1, cell.j - 1, cell.k - 1}, c);
      for (;;) {
        unsigned window = 0;
        for (int part = 0; part < 8; ++part)
          window |= static_cast<unsigned>(cells.holds(part_of_window(low, part))) << part;
        if (missing[window] == kFine) break;
        Cell added = part_of_window(low, missing[window]);
        cells.add(added);
        open.push_back(added);
      }
    }
  }
}

}  // namespace frond
