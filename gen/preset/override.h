#pragma once

#include <string_view>

#include "preset/json.h"

namespace frond {

/// Carries out one `--set POINTER=VALUE` of the command line. POINTER is a JSON pointer (RFC 6901:
/// `/film/fps`, `~1` for `/` and `~0` for `~` in a name). VALUE is JSON, or a text where it is none: `--set
/// /film/quality=best`. Objects on the way that are missing are made, and `-` adds to a list. What is set has
/// the origin `--set POINTER`. No errors: done; else the document is as it was.
Errors apply_set(Document& document, std::string_view assignment);

}  // namespace frond
