#pragma once

#include <vector>

#include "appearance/flight.h"
#include "appearance/health.h"
#include "appearance/leaf_look.h"
#include "core/seed.h"
#include "model/bark.h"
#include "model/model.h"

// What shows of the health of plants.
//
// Leaves lose their green before they dry, the oldest first (Lim, Kim and Nam 2007); those that have dried do
// not turn green again. They curl and hang, and fall where `Health::sheds` says so. Petals fade and shrink,
// stems of herbs turn to straw.

namespace frond {

/// The colours that leaves go through: those that are given, or the usual ones.
std::vector<Color> ailing_colors(const Health& health, bool needles = false);

/// Appends these colours to a leaf's own; nothing for other organs, and for leaves of pictures, whose look
/// has them: see ail_look() and ail_pictures().
void add_ailing(Prototype& leaf, const std::vector<Color>& colors);

/// A look of leaves with the pictures of these colours.
LeafLook ail_look(LeafLook look, const Health& health);

/// Gives a prototype that wears a look, `worn`, the pictures of the same look ailing, `ailing`; false where
/// it wears another one.
bool ail_pictures(Prototype& leaf, const LeafLook& worn, const LeafLook& ailing);

/// Changes organs, whose prototypes have these colours, to how they are when their plant fares so. They are
/// where they stand in the world, at rest. Smooth in the fare; each moment is computed alone.
void ail(Organs& organs, const std::vector<Prototype>& prototypes, const Health& health, const Fare& fare,
         Seed seed, const GroundAt& ground);

/// The colours that organs of a prototype share: those of petals and fruit fade. With `together` leaves
/// change theirs as well, those of each colour alike, and what add_ailing() appended is taken away again.
void fade(Prototype& organ, const Health& health, const Fare& fare, bool together);

/// Stems of herbs and their blades; wood stays as it is.
Bark bark_in(const Bark& bark, const Fare& fare);
std::vector<Color> blades_in(const std::vector<Color>& colors, const Health& health, const Fare& fare);

}  // namespace frond
