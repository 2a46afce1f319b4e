#include "dynamics/colonies.h"

#include <algorithm>
#include <cmath>

namespace frond {

namespace {

using enum ColonyName;

// extension: Pratchett et al. 2015 (Oceanogr. Mar. Biol. 53), linear extension by growth form: tabular
//   Acropora 3-10 cm a year, branching 5-16, Pocillopora 2-5, massive Porites 0.5-2, merulinids 0.4-1.2,
//   encrusting 1-3, foliose 2-6; soft corals: Fabricius 1995, Bastidas et al. 2004; sponges: McMurray 2008.
// widest, tallest, slenderness, foot, crown: Veron 2000; stalks of tables by Madin 2005.
// rank: of colonies that touch; mounds and soft corals keep off others by sweeper tentacles and toxins (Lang
// 1973,
//   Sheppard 1979), tables win by growing over what they do not touch (Connell et al. 2004). shade: Stimson
//   1985, Baird and Hughes 2000 (under tables). tolerance: depth ranges of the forms, Done 1982; sponges need
//   no light.
// arrival, larvae: so that 4-8 juveniles below 5 cm live on a m2 (Trapon et al. 2013, Penin et al. 2010);
//   more Pocillopora than Acropora come where parents are few, as they brood.
// young_death, death: Babcock and Mundy 1996, Wilson and Harrison 2005, Madin et al. 2014; massive corals:
//   Hughes and Jackson 1985, Bythell et al. 1993. injury: Pisapia and Pratchett 2014.
// shape_factor, top_heavy: Madin and Connolly 2006, Madin et al. 2014: tables and thickets grow easier to
//   dislodge, mounds never do.
// lethal_heat: Hughes et al. 2018 (Acropora and Pocillopora lose most of their cover from 6 to 8 on), Loya et
//   al. 2001, Marshall and Baird 2000 (order of the forms).
// reattach: Highsmith 1982. skeleton: Sheppard et al. 2002, Graham et al. 2006. rubble: Rasser, Riegl 2002.
// clang-format off
constexpr std::array<ColonySpecies, kColonyNames> kColonies{{
    //                        grows rises widest tallest slender foot crown
    {ColonyName::tabular,     6.0,  3.0,  2.6,  0.5,  0.32, 0.22, 0.25,
    // rank shade bears  arrive larvae
       5,   0.80, 0.15,  0.70,  4.0,
    // young dies injury  csf  exp  heat  reattach stands rubble
       0.40, 0.10, 0.04,  14., 1.0,  5.5,  0.05,   4,   0.6},
    {ColonyName::branching,   8.0,  7.0,  2.2,  0.9,  0.60, 0.50, 0.70,
       4,   0.55, 0.20,  0.45,  3.0,
       0.45, 0.11, 0.06,  11., 0.8,  5.2,  0.25,   4,   0.7},
    {ColonyName::bushy,       2.6,  2.2,  0.5,  0.4,  0.80, 0.50, 0.80,
       3.5, 0.50, 0.30,  1.00,  3.0,
       0.40, 0.13, 0.04,  6.,  0.5,  5.5,  0.05,   4,   0.6},
    {ColonyName::massive,     1.2,  1.0,  4.0,  2.2,  0.60, 1.00, 1.00,
       6,   0.95, 0.65,  0.15,  1.0,
       0.20, 0.010, 0.02, 0.4, 0.0,  17.,  0.0,    60,  0.0},
    {ColonyName::brain,       0.8,  0.7,  1.6,  0.8,  0.55, 1.00, 1.00,
       8,   0.95, 0.70,  0.22,  1.2,
       0.22, 0.025, 0.03, 0.4, 0.0,  11.,  0.0,    50,  0.0},
    {ColonyName::encrusting,  2.0,  0.3,  1.5,  0.06, 0.40, 1.00, 1.00,
       2,   0.95, 0.65,  0.50,  1.5,
       0.35, 0.07, 0.06,  0.05, 0.0, 8.5,  0.0,    8,   0.0},
    {ColonyName::foliose,     3.0,  2.2,  1.8,  0.6,  0.50, 0.45, 0.60,
       3,   0.80, 0.70,  0.30,  1.2,
       0.38, 0.08, 0.05,  6.,  0.5,  7.5,  0.10,   4,   0.5},
    {ColonyName::soft,        1.0,  1.0,  1.0,  0.35, 0.50, 0.70, 0.60,
       7,   0.70, 0.55,  0.25,  1.2,
       0.35, 0.06, 0.03,  1.5, 0.3,  7.0,  0.05,   0.2, 0.0},
    {ColonyName::sponge,      1.2,  2.0,  0.7,  0.9,  1.40, 1.00, 1.00,
       5.5, 0.90, 1.00,  0.12,  0.8,
       0.35, 0.06, 0.03,  2.5, 0.3,  30.,  0.05,   0.3, 0.0},
}};

using S = ColonySpecies;
constexpr std::array<ColonyRate, kColonyRates> kRates{{
    {"extension", &S::extension, 0.05, 35, "cm", "How far its rim advances in a year where there is light and room"},
    {"rise", &S::rise, 0.05, 35, "cm", "How much taller it grows in a year"},
    {"widest", &S::widest, 0.02, 20, "m", "Diameter of the largest colonies"},
    {"tallest", &S::tallest, 0.01, 10, "m", "Height of the tallest colonies"},
    {"slenderness", &S::slenderness, 0.02, 10, "", "Height over diameter at most"},
    {"foot", &S::foot, 0.05, 1, "", "Diameter of its foot over its own; below 1 it spreads above the ground and others live under it"},
    {"crown", &S::crown, 0.02, 1, "", "Share of the height that what spreads above the foot takes, from the top"},
    {"rank", &S::rank, 0, 20, "", "Rank in competition: where two meet, that of the higher rank overgrows the other; equals stop"},
    {"shade", &S::shade, 0, 1, "", "Share of the light that a colony takes from what is under it"},
    {"tolerance", &S::tolerance, 0, 1, "", "How well it bears shade: 0 needs full light, 1 grows without"},
    {"arrival", &S::arrival, 0, 100, "recruits a m2", "Colonies of one year that come up in a year on free hard ground, from larvae of other reefs"},
    {"larvae", &S::larvae, 0, 100, "recruits a m2", "The same from larvae of the reef itself, if the species covered all of it"},
    {"young_death", &S::young_death, 0, 1, "", "Share of the colonies narrower than 5 cm that die in a year"},
    {"death", &S::death, 0, 1, "", "Share of the full-grown that die in a year of other causes than storms and heat"},
    {"injury", &S::injury, 0, 0.9, "", "Share of its area that a colony loses in a year to predators, disease and sand"},
    {"shape_factor", &S::shape_factor, 0.001, 1000, "", "Colony shape factor of Madin and Connolly 2006 at a diameter of 1 m: the higher, the weaker are the waves that dislodge it"},
    {"top_heavy", &S::top_heavy, 0, 3, "", "Exponent by which the shape factor rises with the diameter"},
    {"lethal_heat", &S::lethal_heat, 4.5, 100, "degree heating weeks", "Heat of which half of the colonies die"},
    {"reattach", &S::reattach, 0, 1, "", "Share of the dislodged colonies of which a fragment grows on where it comes to lie"},
    {"skeleton", &S::skeleton, 0, 500, "years", "How long a dead colony stands"},
    {"rubble", &S::rubble, 0, 3, "", "Area that a broken colony covers with rubble over its own"},
}};
// clang-format on

constexpr std::array<std::string_view, kColonyNames> kNamesOfColonies{
    "tabular", "branching", "bushy", "massive", "brain", "encrusting", "foliose", "soft", "sponge"};

constexpr double kHeatSlope = 4;    // of the logarithm of the odds of death over that of the heat
constexpr double kOnset = 3;        // degree heating weeks up to which nothing dies (Hughes et al. 2018)
constexpr double kOnsetSpan = 1.5;  // within which deaths set in

}  // namespace

std::span<const ColonyRate, kColonyRates> colony_rates() { return kRates; }

std::span<const ColonySpecies> colony_species() { return kColonies; }

std::string_view name_of(ColonyName name) { return kNamesOfColonies[static_cast<std::size_t>(name)]; }

double shape_factor_at(const ColonySpecies& species, double diameter) {
  return species.shape_factor * std::pow(diameter, species.top_heavy);
}

double heat_death(const ColonySpecies& species, double weeks) {
  double onset = std::clamp((weeks - kOnset) / kOnsetSpan, 0.0, 1.0);
  return weeks > 0 ? onset / (1 + std::pow(species.lethal_heat / weeks, kHeatSlope)) : 0;
}

}  // namespace frond
