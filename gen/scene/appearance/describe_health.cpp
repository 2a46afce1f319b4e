#include "appearance/describe.h"

namespace frond {

void describe(Properties& v, ColorCourse& t) {
  v.aspect(Aspect::look);
  if (v.purpose() == Purpose::keys && t.constant()) {
    // As numbers, so that what is named by them keeps its name.
    ColorShift by = t.at(0);
    v.angle("hue", by.hue, {}, "");
    v.number("saturation", by.saturation, {}, "");
    v.number("value", by.value, {}, "");
    return;
  }
  v.animated("hue", t.hue, {.min = -360, .max = 360, .unit = "degrees"},
             "Angle by which colours are turned round the colour wheel, or keyframes of it");
  v.animated("saturation", t.saturation, {.min = 0, .max = 3},
             "Factor of the colours' saturation, or keyframes of it; 0 is grey, 1 leaves it");
  v.animated("value", t.value, {.min = 0, .max = 3},
             "Factor of the colours' brightness, or keyframes of it; 1 leaves it");
}

void describe(Properties& v, Health& h) {
  v.aspect(Aspect::look);
  v.shorthand("at");
  v.animated(
      "at", h.at, {.min = 0, .max = 1},
      "How it fares, or keyframes of it: 1 healthy; corals are white at 0.5 and dead at 0, leaves yellow "
      "and dry from the oldest on. What has died does not come back");
  v.number("stagger", h.stagger, {.min = 0, .max = 1e6, .unit = "s"},
           "Each individual fares so up to so much later than the first, at random");
  v.list(
      "colors", h.colors, Count{0, 8},
      "Colours that leaves go through, the last that of dead ones; not given: yellow and brown, of needles "
      "red");
  v.number("sheds", h.sheds, {.min = 0, .max = 1},
           "Health below which leaves begin to fall, as those of trees do; 0 keeps them on the plant");
  v.angle("droop", h.droop, {.min = 0, .max = 180},
          "Angle by which leaves and flowers of a dead plant hang down");
  v.number("fluoresces", h.fluoresces, {.min = 0, .max = 3},
           "How brightly corals fluoresce just before they pale; 0: they do not");
}

}  // namespace frond
