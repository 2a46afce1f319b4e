#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

namespace frond {

/// The folder of Frond, with templates/, povinc/ and presets/: $FROND_HOME, the one that was set, or the one
/// that the program or the library was built in or is installed with. Nobody has looked whether it holds
/// them where it is none of those.
std::filesystem::path home_folder();

/// For programs that are not Frond's own, as Python. Before anything else is asked for.
void set_home_folder(std::filesystem::path folder);

/// Where what may be made again is kept for this user: below $XDG_CACHE_HOME or ~/.cache.
std::filesystem::path cache_folder();

/// A preset that comes with Frond, by its path seen from the folder of Frond or from presets/ in it, with or
/// without .json, or by the name of its file alone; of several of one name the first by their paths.
/// Grammars, in presets/grammars, are none.
std::optional<std::filesystem::path> shipped_preset(std::string_view name);

}  // namespace frond
