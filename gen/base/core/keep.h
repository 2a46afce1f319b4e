#pragma once

#include <cassert>
#include <cstdint>
#include <vector>

namespace frond {

/// Makes room for so many elements in lists.
template <class... T>
void reserve_all(std::size_t count, std::vector<T>&... lists) {
  (lists.reserve(count), ...);
}

/// Keeps the elements of lists for which `stay` is true, in their order. A list may be empty; each other one
/// is as long as `stay`.
template <class... T>
void keep(const std::vector<std::uint8_t>& stay, std::vector<T>&... lists) {
  auto keep_of = [&](auto& list) {
    if (list.empty()) return;
    assert(list.size() == stay.size());
    std::size_t n = 0;
    for (std::size_t i = 0; i < stay.size(); ++i)
      if (stay[i]) list[n++] = list[i];
    list.resize(n);
  };
  (keep_of(lists), ...);
}

}  // namespace frond
