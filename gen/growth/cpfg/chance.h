#pragma once

#include <cstdint>

namespace frond::cpfg {

/// The 48-bit linear congruential generator that cpfg takes its chance from (that of the C library's
/// drand48): X becomes (0x5DEECE66D X + 11) mod 2^48, and a number is X / 2^48.
class Congruential48 {
 public:
  /// The state to begin with; only its lower 48 bits count.
  explicit Congruential48(std::uint64_t state = 0x330E) : state_(state & kMask) {}

  double next() {
    state_ = (state_ * 0x5DEECE66DULL + 11) & kMask;
    return static_cast<double>(state_) / static_cast<double>(kMask + 1);
  }

 private:
  static constexpr std::uint64_t kMask = (1ULL << 48) - 1;
  std::uint64_t state_;
};

/// The generator by which a stochastic L-system draws lots among its productions. `variation`: 0 as cpfg
/// begins it, here and below.
inline Congruential48 lots_of(std::int64_t seed, std::uint64_t variation = 0) {
  return Congruential48((static_cast<std::uint64_t>(seed) + (155ULL << 32)) ^ variation);
}

/// The chance of formulas: one stream for all functions.
struct FormulaChance {
  Congruential48 stream = Congruential48();
  bool has_kept = true;  ///< normal numbers come in pairs; before any srand the first is the mean
  double kept = 0;
};

/// The stream that srand(n) begins.
inline Congruential48 seeded_stream(std::int64_t n, std::uint64_t variation = 0) {
  return Congruential48((static_cast<std::uint64_t>(n) * 65536 + 0x330E) ^ variation);
}

/// srand(n).
void seed_chance(FormulaChance& chance, std::int64_t n, std::uint64_t variation = 0);
/// nran: a normal number of mean 0 and deviation 1, by the polar method.
double normal_number(FormulaChance& chance);
/// bran: a beta number, by rejection (Cheng 1978, algorithm BA). Parameters of 0 or less give 0.
double beta_number(FormulaChance& chance, double a, double b);
/// biran: how many of n (at most 1,000,000) tries succeed.
double binomial_number(FormulaChance& chance, double n, double p);

}  // namespace frond::cpfg
