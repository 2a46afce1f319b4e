#pragma once

#include <span>
#include <string>

#include "preset/value.h"

namespace frond {

/// `own` merged over `below`: objects member by member, to any depth; for all other values (lists too) `own`
/// wins. Every value keeps its origin.
Value overlay(const Value& below, const Value& own);

/// An object with `defaults` behind it: overlay(defaults, own), but the properties named in `force` ("wave",
/// or "wave/amplitude" for a nested one) are taken from the defaults, whatever the object says; one missing
/// from the defaults is removed, so that the built-in default applies. Values from the defaults are marked
/// `inherited`: Reader ignores them if the kind of the object has no such property.
Value merge(const Value& defaults, const Value& own, std::span<const std::string> force = {});

}  // namespace frond
