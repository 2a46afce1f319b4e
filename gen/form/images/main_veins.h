#pragma once

#include "images/vein_tree.h"

namespace frond {

/// Lays the main veins and the secondaries of a blade. The same for all leaves of an outline, as meshes fold
/// along them.
void lay_main_veins(const LeafOutline& outline, const Lamina& blade, VeinTree& veins);

}  // namespace frond
