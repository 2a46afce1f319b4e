#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/events.h"
#include "core/seed.h"
#include "grove/shed.h"
#include "pruning/address.h"

// Dated events and cuts in a grove.

namespace frond {

/// An event of the year of a grove in which it takes effect: what it breaks comes down during the year after.
struct DatedEvent {
  int year = 0;
  Event event;
};

/// The events of a grove.
struct Dates {
  std::vector<DatedEvent> events;
  std::optional<Vec3> toward;  ///< where storms blow and what is felled falls; none: anywhere
};

/// The storm of a year whose strongest gust is `wind` where no event makes it stronger. The random direction
/// and strength of ordinary years do not depend on events.
Weather weather_of(double wind, double snow, const Dates& dates, Seed seed, int year);

/// A tree that may be felled: its name, its own seed, and whether it stands.
struct FellingTree {
  std::string name;
  Seed seed;
  bool stands = true;
};

/// For each of these trees, 1 if it is felled in a year, else 0.
std::vector<std::uint8_t> felled_in(const Dates& dates, int year, std::span<const FellingTree> trees,
                                    Seed seed);

/// The height under which a tree of that name loses its limbs in a year, metres; 0: none are taken off.
double pruned_in(const Dates& dates, int year, const std::string& name);

/// Lets the limbs fall that leave the stem below the height `below`, metres.
void prune(const Metamers& tree, double below, Seed seed, int year, Falls& falls);

/// A limb that is sawn off at the end of a year.
struct YearCut {
  int year = 0;            ///< of the grove
  Address at;              ///< on the tree as it is then
  std::size_t number = 0;  ///< of its edit, for messages
};

/// Saws off what cuts of that year name, at the node nearest to the place: it falls when the year ends. Buds
/// on the next nodes below wake, as what held them back is gone; where none is alive, new ones come from the
/// wood there (epicormic buds: Meier, Saunders and Michler 2012). Gives the metamers whose upper end was cut.
/// What finds no branch is noted.
std::vector<std::size_t> saw(Metamers& tree, std::span<const YearCut> cuts, int year, Falls& falls,
                             std::vector<std::string>& notes);

}  // namespace frond
