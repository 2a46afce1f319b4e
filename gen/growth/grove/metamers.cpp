#include "grove/metamers.h"

#include <cassert>
namespace frond {

void Metamers::resize(std::size_t n) {
  tip.resize(n);
  side.resize(n);
  parent.resize(n);
  serial.resize(n);
  born.resize(n);
  died.resize(n, kNever);
  pipe.resize(n, 0.0f);
  light.resize(n, 1.0f);
  flags.resize(n);
  order.resize(n);
  to_leader.resize(n);
  to_side.resize(n);
  count.resize(n);
}

void Metamers::keep(const std::vector<std::uint8_t>& stay) {
  assert(stay.size() == size() && stay[0]);
  std::vector<std::int32_t> moved(size());
  std::size_t n = 0;
  for (std::size_t i = 0; i < size(); ++i) {
    if (!stay[i]) continue;
    assert(parent[i] == kRoot || (parent[i] < static_cast<std::int32_t>(i) && stay[parent[i]]));
    moved[i] = static_cast<std::int32_t>(n);
    if (n != i || parent[i] != kRoot) {
      tip[n] = tip[i];
      side[n] = side[i];
      parent[n] = parent[i] == kRoot ? kRoot : moved[parent[i]];
      serial[n] = serial[i];
      born[n] = born[i];
      died[n] = died[i];
      pipe[n] = pipe[i];
      light[n] = light[i];
      flags[n] = flags[i];
      order[n] = order[i];
    }
    ++n;
  }
  resize(n);
}

}  // namespace frond
