#include "scene/describe.h"

namespace frond {

namespace {

constexpr Choice<ColonyName> kColonyChoices[] = {
    {"tabular", ColonyName::tabular, "tables of Acropora: fast, spread over others, bleach and break first"},
    {"branching", ColonyName::branching, "staghorn Acropora: fast, live on as fragments"},
    {"bushy", ColonyName::bushy, "Pocillopora: small and short-lived, settle in numbers"},
    {"massive", ColonyName::massive, "Porites: slow, outlive storms and heat"},
    {"brain", ColonyName::brain, "merulinids: slow, keep their neighbours off"},
    {"encrusting", ColonyName::encrusting, "Montipora and the like, flat on the ground"},
    {"foliose", ColonyName::foliose, "leaves that bear shade"},
    {"soft", ColonyName::soft, "leather corals, which leave no skeleton"},
    {"sponge", ColonyName::sponge, "needs no light"}};

}  // namespace

void describe(Properties& v, ColonyText& c) {
  v.shorthand("name");
  v.choice("name", c.name, kColonyChoices,
           "The species, by growth form; rates that are not given here are those of docs/reef_dynamics.md");
  v.required("name");
  v.text("organism", c.organism,
         "Name of the organism that these colonies are drawn as, one with `sown` and a `count` of 0; not "
         "given: they are not drawn");
  for (std::size_t r = 0; r < kColonyRates; ++r) {
    const ColonyRate& rate = colony_rates()[r];
    v.number(rate.name, c.rates[r], {.min = rate.min, .max = rate.max, .unit = rate.unit}, rate.doc);
  }
}

void describe(Properties& v, Outplant& o) {
  v.choice("name", o.name, kColonyChoices, "The species that is planted");
  v.required("name");
  v.number("density", o.density, {.min = 0.001, .max = 1000, .unit = "colonies a m2"},
           "How many are planted, at random places where they have room");
  v.number("diameter", o.diameter, {.min = 0.02, .max = 5, .unit = "m"}, "How wide they are");
}

void describe(Properties& v, ReefText& r) {
  v.vector("area", r.area, {.min = 1, .max = 100, .unit = "m"}, "How long the floor is along x and along z");
  v.integer("years", r.years, {.min = 1, .max = 1000}, "How many years are simulated, from bare ground on");
  v.vector("shown", r.shown, {.min = 0, .max = 1000, .unit = "years"},
           "The years that a film shows, first and last; not given: all that are simulated. A still shows "
           "the last");
  v.list("species", r.species, "The species that settle; not given: all that there are");
  v.list("planted", r.planted, "Colonies that are planted at the beginning");
  v.boolean("settling", r.settling, "Whether larvae settle");
  v.number("storms", r.storms, {.min = 0, .max = 10, .sense = "1 on an open slope, 0 none"},
           "Factor of the drag of the strongest waves of each year, which come by themselves");
  v.number("grazing", r.grazing, {.min = 0, .max = 5, .unit = "1/year"},
           "How fast fishes and urchins graze the floor, as g of Mumby and others 2007: below 0.2 macroalgae "
           "take what becomes free, above 0.4 corals come back");
  v.number("algae", r.algae, {.min = 0, .max = 5, .unit = "1/year"},
           "How fast macroalgae spread over turf, as gamma of Mumby and others 2007");
  v.number("binding", r.binding, {.min = 0, .max = 5, .unit = "1/year"},
           "How fast loose rubble is bound, so that colonies can settle on it");
}

}  // namespace frond
