#pragma once

#include <span>
#include <string>

#include "preset/value.h"

namespace frond {

/// `own` laid over `below`: objects member by member, to any depth; in everything else (lists too) `own`
/// wins. Every value keeps its origin.
Value overlay(const Value& below, const Value& own);

/// What an object is when it has `defaults` behind it: overlay(defaults, own), but the properties named in
/// `force` ("wave", or "wave/amplitude" for one inside another) count as in the defaults, whatever the object
/// says of its own; one that the defaults do not have is taken out, so that the built-in default counts. What
/// comes from the defaults is marked `inherited`: Reader passes over it where the kind of the object has no
/// such property.
Value merge(const Value& defaults, const Value& own, std::span<const std::string> force = {});

}  // namespace frond
