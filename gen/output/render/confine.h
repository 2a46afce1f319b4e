#pragma once

#include <filesystem>
#include <vector>

#include "core/result.h"

/// Programs that may open nothing but what they are given, whatever they do: by Landlock (Linux 5.13).
namespace frond {

/// What a program may open besides the system's own programs and libraries.
struct Confinement {
  std::vector<std::filesystem::path> read;   ///< files, and folders with all that is below them
  std::vector<std::filesystem::path> write;  ///< folders that it may read and write below
};

/// Whether the kernel can do it.
bool can_confine();

/// What there is to say where it cannot.
Error no_landlock();

/// Confines this process, and all that it starts, for the rest of its life; it may run `program`. No rights
/// can be gained any more either, as by a program with the rights of another user.
Errors confine(const Confinement& to, const std::filesystem::path& program);

}  // namespace frond
