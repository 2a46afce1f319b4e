#include "grove/metamers.h"

#include <cassert>

#include "core/keep.h"

namespace frond {

void Metamers::resize(std::size_t n) {
  auto all = [n](auto&... lists) { (lists.resize(n), ...); };
  all(tip, side, parent, serial, born, pipe, flags, order, to_leader, to_side, count);
  died.resize(n, kNever);
  light.resize(n, 1.0f);
}

void Metamers::keep(const std::vector<std::uint8_t>& stay) {
  assert(stay.size() == size() && stay[0]);
  std::vector<std::int32_t> moved(size());
  std::int32_t n = 0;
  for (std::size_t i = 0; i < size(); ++i) {
    if (!stay[i]) continue;
    assert(parent[i] == kRoot || (parent[i] < static_cast<std::int32_t>(i) && stay[parent[i]]));
    moved[i] = n++;
    if (parent[i] != kRoot) parent[i] = moved[parent[i]];
  }
  frond::keep(stay, tip, side, parent, serial, born, died, pipe, light, flags, order);
  resize(tip.size());
}

}  // namespace frond
