#pragma once

#include <string>

#include "core/assets.h"

namespace frond {

/// The file of a preset that another one names, as its `base` or a `species`: by the rule for all files, and
/// where there is none by that rule, one that comes with Frond, as shipped_preset() finds it. `named_in` is
/// the file that names it.
Result<NamedFile> read_named_preset(const Assets& assets, const std::string& name,
                                    const std::string& named_in);

}  // namespace frond
