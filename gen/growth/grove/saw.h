#pragma once

#include <span>
#include <string>
#include <vector>

#include "grove/metamers.h"
#include "grove/shed.h"
#include "pruning/address.h"

namespace frond {

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
