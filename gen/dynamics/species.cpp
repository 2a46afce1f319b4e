#include "dynamics/species.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace frond {

namespace {

using enum SeedCarrier;

// height, rate, shape: fitted to top heights at 20, 50 and 100 years of good sites: Forestry Commission yield
//   classes (Edwards and Christie 1981) 6 of oak, 10 of Scots pine, 8 of beech, 16 of Norway spruce, 8 of
//   birch; Schober 1975 I of beech and silver fir. Aspen, rowan: Leuschner and Ellenberg 2017.
// girth_gain: Mitchell's rule of 2.5 cm (1966), more for aspen and spruce, less for rowan.
// crown: crown diameters over diameters of Hemery, Savill and Pryor 2005; conifers: Hasenauer 1997.
// tolerance: Niinemets and Valladares 2006. lifespan: Leuschner and Ellenberg 2017, of natural stands.
// density: of fresh volume, Zanne et al. 2009. decay: Rock, Badeck and Harmon 2008; Herrmann et al. 2015.
// anchorage: Nicoll et al. 2006 for conifers; oak and beech hold more (Stokes 2002, Peltola 2006).
// reach: birch, pine, spruce: Vittoz and Engler 2007; jays: Gomez 2003; beech: Millerón et al. 2013.
// litter, wood: Bače et al. 2012 (spruce and rowan on logs), Leuschner and Ellenberg 2017.
// coldest: tree lines at 6.4 degrees (Körner and Paulsen 2004), less hardy kinds by their limits in altitude.
constexpr std::array<TreeSpecies, 8> kSpecies{{
    {.name = TreeName::birch,
     .height = 26,
     .rate = 0.032,
     .shape = 1.1,
     .girth_gain = 2.5,
     .diameter = 0.6,
     .crown_foot = 0.6,
     .crown_gain = 8,
     .leaf_area = 2.5,
     .tolerance = 2.0,
     .lifespan = 95,
     .density = 525,
     .anchorage = 150,
     .decay = 0.09,
     .carrier = wind,
     .reach = 45,
     .first_seeds = 12,
     .seeds = 3,
     .arrival = 0.15,
     .litter = 0.05,
     .wood = 0.15,
     .coldest = 6.4,
     .moisture = 0.5,
     .moisture_span = 0.5},
    {.name = TreeName::aspen,
     .height = 28,
     .rate = 0.034,
     .shape = 1.15,
     .girth_gain = 3,
     .diameter = 0.8,
     .crown_foot = 0.6,
     .crown_gain = 7.5,
     .leaf_area = 2.5,
     .tolerance = 2.2,
     .lifespan = 105,
     .density = 380,
     .anchorage = 130,
     .decay = 0.09,
     .carrier = wind,
     .reach = 100,
     .first_seeds = 15,
     .seeds = 1,
     .arrival = 0.05,
     .litter = 0.03,
     .wood = 0.1,
     .coldest = 7.5,
     .moisture = 0.6,
     .moisture_span = 0.35},
    {.name = TreeName::rowan,
     .height = 15,
     .rate = 0.045,
     .shape = 1.1,
     .girth_gain = 1.6,
     .diameter = 0.4,
     .crown_foot = 0.5,
     .crown_gain = 10,
     .leaf_area = 2.5,
     .tolerance = 2.7,
     .lifespan = 85,
     .density = 600,
     .anchorage = 160,
     .decay = 0.08,
     .carrier = animals,
     .reach = 60,
     .first_seeds = 10,
     .seeds = 0.5,
     .arrival = 0.02,
     .litter = 0.5,
     .wood = 0.4,
     .coldest = 6.4,
     .moisture = 0.5,
     .moisture_span = 0.5},
    {.name = TreeName::oak,
     .height = 30,
     .rate = 0.018,
     .shape = 1.15,
     .girth_gain = 2.5,
     .diameter = 1.6,
     .crown_foot = 0.7,
     .crown_gain = 9,
     .leaf_area = 3.5,
     .tolerance = 2.6,
     .lifespan = 400,
     .density = 560,
     .anchorage = 200,
     .decay = 0.03,
     .carrier = animals,
     .reach = 30,
     .first_seeds = 40,
     .seeds = 0.1,
     .arrival = 0.01,
     .litter = 0.9,
     .wood = 0.1,
     .coldest = 10,
     .moisture = 0.5,
     .moisture_span = 0.5},
    {.name = TreeName::pine,
     .height = 30,
     .rate = 0.024,
     .shape = 1.35,
     .girth_gain = 2.3,
     .diameter = 1,
     .crown_foot = 0.5,
     .crown_gain = 6.5,
     .leaf_area = 2.5,
     .tolerance = 1.7,
     .lifespan = 280,
     .density = 420,
     .anchorage = 140,
     .evergreen = true,
     .decay = 0.035,
     .carrier = wind,
     .reach = 25,
     .first_seeds = 20,
     .seeds = 0.5,
     .arrival = 0.02,
     .litter = 0.1,
     .wood = 0.15,
     .coldest = 6.8,
     .moisture = 0.35,
     .moisture_span = 0.5},
    {.name = TreeName::beech,
     .height = 38,
     .rate = 0.018,
     .shape = 1.4,
     .girth_gain = 2.5,
     .diameter = 1.3,
     .crown_foot = 0.7,
     .crown_gain = 9,
     .leaf_area = 5,
     .tolerance = 4.6,
     .lifespan = 260,
     .density = 585,
     .anchorage = 170,
     .decay = 0.09,
     .carrier = gravity,
     .reach = 8,
     .first_seeds = 45,
     .seeds = 0.6,
     .arrival = 0.004,
     .litter = 1,
     .wood = 0.2,
     .coldest = 9,
     .moisture = 0.5,
     .moisture_span = 0.3},
    {.name = TreeName::spruce,
     .height = 40,
     .rate = 0.021,
     .shape = 1.5,
     .girth_gain = 2.8,
     .diameter = 1.2,
     .crown_foot = 0.6,
     .crown_gain = 5.5,
     .leaf_area = 5,
     .tolerance = 4.45,
     .lifespan = 260,
     .density = 380,
     .anchorage = 120,
     .evergreen = true,
     .decay = 0.04,
     .carrier = wind,
     .reach = 20,
     .first_seeds = 35,
     .seeds = 0.8,
     .arrival = 0.01,
     .litter = 0.1,
     .wood = 1,
     .coldest = 6.8,
     .moisture = 0.6,
     .moisture_span = 0.3},
    {.name = TreeName::fir,
     .height = 42,
     .rate = 0.018,
     .shape = 1.7,
     .girth_gain = 2.5,
     .diameter = 1.5,
     .crown_foot = 0.7,
     .crown_gain = 6,
     .leaf_area = 5,
     .tolerance = 4.6,
     .lifespan = 320,
     .density = 370,
     .anchorage = 150,
     .evergreen = true,
     .decay = 0.045,
     .carrier = wind,
     .reach = 15,
     .first_seeds = 40,
     .seeds = 0.4,
     .arrival = 0.004,
     .litter = 0.6,
     .wood = 0.6,
     .coldest = 8.5,
     .moisture = 0.55,
     .moisture_span = 0.3},
}};

constexpr std::array<std::string_view, 8> kNames{"birch", "aspen", "rowan",  "oak",
                                                 "pine",  "beech", "spruce", "fir"};

/// The root of 1 - (1 + x) exp(-x) = q, the share of a plane's exponential kernel within x scales.
double exponential_radius(double q) {
  double x = std::sqrt(2 * q) + q;
  for (int i = 0; i < 8; ++i) {
    double e = std::exp(-x);
    x = std::max(x - (1 - (1 + x) * e - q) / std::max(x * e, 1e-12), 0.0);
  }
  return x;
}

constexpr double kMedianExponential = 1.67834699;  // exponential_radius(0.5)

}  // namespace

std::span<const TreeSpecies> tree_species() { return kSpecies; }

std::string_view name_of(TreeName name) { return kNames[static_cast<std::size_t>(name)]; }

double height_at(const TreeSpecies& species, double age) {
  return species.height * std::pow(1 - std::exp(-species.rate * age), species.shape);
}

double age_at(const TreeSpecies& species, double height) {
  double share = std::pow(std::min(height / species.height, 1.0), 1 / species.shape);
  return share < 1 ? std::min(-std::log(1 - share) / species.rate, 1000.0) : 1000;
}

double seed_distance(const TreeSpecies& species, double q) {
  q = std::clamp(q, 0.0, 0.9999);
  switch (species.carrier) {
    case SeedCarrier::wind:  // 1 - (1 + r2/u)^-1 = q, whose median is the root of u
      return species.reach * std::sqrt(q / (1 - q));
    case SeedCarrier::gravity:
      return species.reach * std::sqrt(-std::log(1 - q) / std::log(2.0));
    case SeedCarrier::animals:
      return species.reach * exponential_radius(q) / kMedianExponential;
  }
  return 0;
}

}  // namespace frond
