#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace frond {

/// An allocator whose vectors do not clear what resize() adds: a word is written once, right after.
template <class T>
struct Uncleared : std::allocator<T> {
  template <class U>
  struct rebind {
    using other = Uncleared<U>;
  };
  using std::allocator<T>::allocator;
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

/// Stands for a name together with its number of parameters; an index into Grammar::symbols.
using SymbolId = std::uint8_t;

/// A word of modules: one byte each, and their parameters one after the other in a pool of their own. How
/// many belong to a module is a matter of its symbol.
struct Word {
  Buffer<SymbolId> symbols;
  Buffer<double> parameters;

  std::size_t size() const { return symbols.size(); }
  std::size_t bytes() const { return symbols.size() * sizeof(SymbolId) + parameters.size() * sizeof(double); }
  void clear() { symbols.clear(), parameters.clear(); }
  bool operator==(const Word&) const = default;
};

}  // namespace frond
