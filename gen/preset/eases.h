#pragma once

#include "core/ease.h"
#include "preset/describe.h"

namespace frond {

/// What presets call the ways in which something begins and ends.
inline constexpr Choice<Ease> kEases[] = {{"none", Ease::none, "at an even pace"},
                                          {"in", Ease::in, "slow at the beginning"},
                                          {"out", Ease::out, "slow at the end"},
                                          {"both", Ease::both, "slow at the beginning and at the end"}};

}  // namespace frond
