#include "core/version.h"

namespace frond {

std::string version() { return FROND_VERSION; }

}  // namespace frond
