#pragma once

#include <span>
#include <string>

#include "preset/value.h"

namespace frond {

/// What an object is when it has `defaults` behind it. Objects are merged member by member, to any depth; in
/// everything else (lists too) what is its `own` wins. The properties named in `force` ("wave", or
/// "wave/amplitude" for one inside another) count as in the defaults, whatever the object says of its own: a
/// forced property that the defaults do not have is taken out, so that the built-in default counts.
/// Every value keeps its origin; what comes from the defaults is marked `inherited`.
Value merge(const Value& defaults, const Value& own, std::span<const std::string> force = {});

}  // namespace frond
