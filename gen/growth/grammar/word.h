#pragma once

#include <cstddef>
#include <cstdint>
#include <new>
#include <utility>
#include <vector>

namespace frond {

/// Memory for long words. Large blocks use huge pages where the system has them: mapping small pages costs
/// more time than writing the words.
void* allocate_pages(std::size_t bytes);
void release_pages(void* memory);

/// An allocator whose vectors do not initialize new elements in resize(): a word is written right afterwards.
template <class T>
struct Uncleared {
  using value_type = T;
  Uncleared() = default;
  template <class U>
  Uncleared(const Uncleared<U>&) {}
  T* allocate(std::size_t count) { return static_cast<T*>(allocate_pages(count * sizeof(T))); }
  void deallocate(T* memory, std::size_t) { release_pages(memory); }
  bool operator==(const Uncleared&) const { return true; }
  template <class U>
  void construct(U* at) noexcept {
    ::new (static_cast<void*>(at)) U;
  }
  template <class U, class... Values>
  void construct(U* at, Values&&... values) {
    ::new (static_cast<void*>(at)) U(std::forward<Values>(values)...);
  }
};

template <class T>
using Buffer = std::vector<T, Uncleared<T>>;

/// A name together with its number of parameters, as an index into Grammar::symbols.
using SymbolId = std::uint8_t;

/// A word of modules: one byte each, with all parameters in a separate array. The symbol determines the
/// number of parameters.
struct Word {
  Buffer<SymbolId> symbols;
  Buffer<double> parameters;

  std::size_t size() const { return symbols.size(); }
  std::size_t bytes() const { return symbols.size() * sizeof(SymbolId) + parameters.size() * sizeof(double); }
  void clear() { symbols.clear(), parameters.clear(); }
  bool operator==(const Word&) const = default;
};

}  // namespace frond
