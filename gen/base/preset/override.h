#pragma once

#include <string_view>

#include "preset/json.h"

namespace frond {

/// Executes one `--set POINTER=VALUE` of the command line. POINTER is a JSON pointer (RFC 6901: `/film/fps`,
/// `~1` for `/` and `~0` for `~` in a name). VALUE is JSON, or otherwise a text: `--set /film/quality=best`.
/// Missing parent objects are created, and `-` appends to a list. The new value has the origin `--set
/// POINTER`. On errors the document stays unchanged.
Errors apply_set(Document& document, std::string_view assignment);

}  // namespace frond
