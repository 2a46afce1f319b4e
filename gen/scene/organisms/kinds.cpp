#include "organisms/kinds.h"

namespace frond {

std::span<const Kind<Organism>> organism_kinds() {
#define FROND_ROW(name) name##_kind(),
  static const std::vector<Kind<Organism>> kinds{FROND_KINDS(FROND_ROW)};
#undef FROND_ROW
  return kinds;
}

}  // namespace frond
