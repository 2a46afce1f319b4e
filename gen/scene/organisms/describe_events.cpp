#include "organisms/describe_events.h"

namespace frond {

void describe(Properties& v, Cut& c) {
  v.text("entry", c.entry, "Name of the organisms of which some are felled; without it all trees count");
  v.number("share", c.share, {.min = 0, .max = 1}, "Share of those that still stand, chosen by the seed");
}

void describe(Properties& v, Prune& p) {
  v.text("entry", p.entry, "Name of the organisms that are pruned; without it all trees are");
  v.number("below", p.below, {.min = 0, .max = 100, .unit = "m"},
           "Height above the foot under which stems lose their limbs");
}

void describe(Properties& v, Event& e) {
  v.number("year", e.year, {.min = 0, .max = 10000, .unit = "years"},
           "When it happens, counted from when the oldest trees began to grow, or in the years of the stand");
  v.required("year");
  v.number("storm", e.storm, {.min = 0, .max = 1, .sense = "0.5 breaks limbs, 1 flattens woods"},
           "Strength of a storm, from the strongest gust of an ordinary year to one of 50 m/s");
  v.object("cut", e.cut, "Trees that are felled");
  v.object("prune", e.prune, "Limbs that are taken off");
}

}  // namespace frond
