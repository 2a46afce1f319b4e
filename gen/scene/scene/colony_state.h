#pragma once

#include "organisms/organism.h"

// Colonies that have lost their tissue: the colours of bleached and of dead ones.

namespace frond {

/// What a skin turns to when its colony is bleached or dead.
Skin skin_in(const Skin& skin, ColonyState state);

/// What the material of a living skin turns to; other materials stay.
Material material_in(const Material& material, ColonyState state);

}  // namespace frond
