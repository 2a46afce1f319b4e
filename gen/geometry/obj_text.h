#pragma once

#include <string>
#include <string_view>

#include "core/result.h"

namespace frond {

/// What is wrong in a Wavefront OBJ text without comments: places and normals that are no finite numbers,
/// faces and lines with too few corners or with corners that do not exist. The first fault, by `name:line`;
/// empty where there is none. Nothing of the text is shown.
Errors check_obj(std::string_view text, const std::string& name);

}  // namespace frond
