#include "estimate/estimate_fruit.h"

#include <cmath>

namespace frond {

void count_fruit(SizeEstimate& size, const std::optional<Seasons>& seasons) {
  if (!seasons || !seasons->fruit) return;
  const Fruiting& f = *seasons->fruit;
  const double crops = std::ceil(fruit_years(f, seasons->drift) - static_cast<double>(f.set.x));
  const double more = 1 + f.share * f.cluster * crops * (f.stalk > 0 ? 2 : 1);
  size.organs *= more, size.parts *= more;
}

}  // namespace frond
