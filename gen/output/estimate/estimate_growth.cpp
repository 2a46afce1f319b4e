#include "estimate/estimate_growth.h"

#include <algorithm>
#include <cmath>

namespace frond {

double frames_ungrown(const Film& film, const Growth& growth, FilmPart part) {
  constexpr double kNodes = 1.5;  // by this power of its growth the nodes of an organism become more
  double sum = 0;
  for (int frame = part.first; frame <= part.last && growth.duration > 0; ++frame)
    sum += 1 - std::pow(std::min(1.0, growth_front(growth, film.time(frame))), kNodes);
  return sum;
}

}  // namespace frond
