#pragma once

#include <string>
#include <vector>

namespace frond {

// What things hold in memory beyond themselves, in bytes, about: by this is bounded what is kept for later.

template <class T>
std::size_t bytes_of(const std::vector<T>& list) {
  return list.capacity() * sizeof(T);
}

inline std::size_t bytes_of(const std::string& text) {
  constexpr std::size_t kWithin = 15;  // a short one lies in the string itself
  return text.capacity() > kWithin ? text.capacity() + 1 : 0;
}

}  // namespace frond
