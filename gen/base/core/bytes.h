#pragma once

#include <string>
#include <vector>

namespace frond {

// Approximate heap memory of objects, in bytes, beyond their own size; used to limit caches.

template <class T>
std::size_t bytes_of(const std::vector<T>& list) {
  return list.capacity() * sizeof(T);
}

inline std::size_t bytes_of(const std::string& text) {
  constexpr std::size_t kWithin = 15;  // a short string is stored inside the object itself
  return text.capacity() > kWithin ? text.capacity() + 1 : 0;
}

}  // namespace frond
