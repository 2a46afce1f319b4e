#include "organisms/tissue_look.h"

#include <algorithm>

#include "appearance/describe.h"

namespace frond {

void describe(Properties& v, TissueLook& t) {
  v.aspect(Aspect::look);
  v.color("color", t.color, "Colour of what stands out: walls, ridges");
  v.color("second", t.second, "Colour of what lies back: cups, valleys");
  v.number("cup", t.cup, {.min = 0.0005, .max = 0.2, .unit = "m"}, "Distance from one polyp to the next");
  v.number("relief", t.relief, {.min = 0, .max = 3}, "How deep the cups look; 0 is smooth");
  v.number("gloss", t.gloss, {.min = 0, .max = 1}, "How wet it looks: 0 matt");
  v.number("variation", t.variation, {.min = 0, .max = 0.5},
           "How much single ones differ in brightness, as a share");
  describe(v, t.polyps);
}

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
