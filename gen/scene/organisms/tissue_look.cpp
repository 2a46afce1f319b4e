#include "organisms/tissue_look.h"

#include <algorithm>

namespace frond {

Material material_of(const TissueLook& look, Matter matter, Seed seed) {
  auto bright = static_cast<float>(1 + look.variation * seed.child("brightness").range(-1, 1));
  auto toned = [&](Color c) {
    return Color{std::min(1.0f, c.red * bright), std::min(1.0f, c.green * bright),
                 std::min(1.0f, c.blue * bright)};
  };
  return {.matter = matter,
          .color = toned(look.color),
          .second = toned(look.second),
          .scale = look.cup,
          .relief = look.relief,
          .gloss = look.gloss,
          .polyps = look.polyps};
}

}  // namespace frond
