#pragma once

#include <cstdint>
#include <string_view>

namespace frond {

/// A node in a tree of random numbers. There is no stream and no state: a number depends only on the path to
/// its node, so that adding a branch, a thread or a frame changes no other number.
///
///     Seed coral = scene.child("organism", 3);
///     double lean = coral.child("lean").range(-0.1, 0.1);
struct Seed {
  std::uint64_t key = 0;

  /// The child node of the given purpose and index.
  constexpr Seed child(std::string_view purpose, std::uint64_t index = 0) const {
    std::uint64_t name = 0xcbf29ce484222325ull;  // FNV-1a
    for (char c : purpose) name = (name ^ static_cast<unsigned char>(c)) * 0x100000001b3ull;
    return Seed{mix(mix(key ^ name) + index)};
  }

  /// The child node of the given index; cheaper than a name, for inner loops.
  constexpr Seed child(std::uint64_t index) const {
    return Seed{mix(key + 0x9e3779b97f4a7c15ull * (index + 1))};
  }

  /// 64 random bits.
  constexpr std::uint64_t bits() const { return mix(key ^ 0x2545f4914f6cdd1dull); }

  /// A number in [0, 1).
  constexpr double unit() const { return static_cast<double>(bits() >> 11) * 0x1p-53; }

  /// A number in [low, high).
  constexpr double range(double low, double high) const { return low + (high - low) * unit(); }

  /// A number of the normal distribution with mean 0 and deviation 1.
  double normal() const;

  /// The finalizer of SplitMix64 (Steele, Lea and Flood 2014).
  static constexpr std::uint64_t mix(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15ull;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
    return x ^ (x >> 31);
  }
};

}  // namespace frond
