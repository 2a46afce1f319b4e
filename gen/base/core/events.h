#pragma once

#include <optional>
#include <string>

// What happens once to the trees of a wood or to a reef, at a date: storms, heat waves, fellings, prunings.

namespace frond {

/// Trees that are felled.
struct Cut {
  std::string entry;    ///< the "name" of the organisms of which some are felled; empty: of all trees
  double share = 1;     ///< of these that still stand, 0..1
  bool by_own = false;  ///< whether they draw lots by their own seeds, not by their numbers
};

/// Limbs that are taken off.
struct Prune {
  std::string entry;  ///< the "name" of the organisms that are pruned; empty: all trees
  double below = 2;   ///< metres above the foot, under which stems lose their limbs
};

/// One date. What is not given does not happen.
struct Event {
  double year = 0;   ///< years since the oldest trees began to grow
  double storm = 0;  ///< 0 the strongest gust of an ordinary year .. 1 one of kWorstStorm
  double heat = 0;   ///< degree heating weeks of a heat wave in the sea
  std::optional<Cut> cut;
  std::optional<Prune> prune;
};

inline constexpr double kWorstStorm = 50;  ///< metres a second, as in the gales that flatten woods

/// Whether an event concerns the organisms of a name.
inline bool concerns(const std::string& entry, const std::string& name) {
  return entry.empty() || entry == name;
}

/// The strongest gust of a year in which such a storm blows, metres a second; `ordinary` is that of others.
inline double storm_gust(double ordinary, double storm) {
  return ordinary < kWorstStorm ? ordinary + storm * (kWorstStorm - ordinary) : ordinary;
}

}  // namespace frond
