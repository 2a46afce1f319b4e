#include "cpfg/chance.h"

#include <algorithm>
#include <cmath>

namespace frond::cpfg {

void seed_chance(FormulaChance& chance, std::int64_t n, std::uint64_t variation) {
  chance.stream = seeded_stream(n, variation);
  chance.has_kept = false;
}

double normal_number(FormulaChance& chance) {
  if (chance.has_kept) {
    chance.has_kept = false;
    return chance.kept;
  }
  double a = 0, b = 0, q = 0;
  do {
    a = 2 * chance.stream.next() - 1;
    b = 2 * chance.stream.next() - 1;
    q = a * a + b * b;
  } while (q >= 1 || q == 0);
  double g = std::sqrt(-2 * std::log(q) / q);
  chance.kept = a * g;
  chance.has_kept = true;
  return b * g;
}

double beta_number(FormulaChance& chance, double a, double b) {
  if (!(a > 0 && b > 0 && std::isfinite(a + b))) return 0;
  constexpr int kMostTries = 1000;  // it ends for any parameters
  double sum = a + b;
  double beta = std::min(a, b) <= 1 ? std::max(1 / a, 1 / b) : std::sqrt((sum - 2) / (2 * a * b - sum));
  double gamma = a + 1 / beta, w = 0;
  for (int i = 0; i < kMostTries; ++i) {
    double u1 = chance.stream.next(), u2 = chance.stream.next();
    double v = beta * std::log(u1 / (1 - u1));
    w = std::min(a * std::exp(v), 1e300);
    if (sum * std::log(sum / (b + w)) + gamma * v - std::log(4.0) >= std::log(u1 * u1 * u2)) break;
  }
  return w / (b + w);
}

double binomial_number(FormulaChance& chance, double n, double p) {
  int count = 0;
  auto tries = static_cast<int>(std::clamp(std::isnan(n) ? 0 : n, 0.0, 1e6));
  for (int i = 0; i < tries; ++i) count += chance.stream.next() <= p;
  return count;
}

}  // namespace frond::cpfg
