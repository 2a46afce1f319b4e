#pragma once

#include "cli/commands.h"
#include "core/bounds.h"
#include "preset/value.h"

namespace frond {

/// A plant as another program's file draws it, for a preset that a person goes on with.
struct ImportedPlant {
  Bounds box;           ///< in its own units
  DVec3 side{0, 0, 1};  ///< from where it is seen
  Value grammar = make_object();
  Value looks = make_object();  ///< further properties of the plant
  bool measured = false;        ///< its units are metres, which it keeps
};

/// The preset to write.
std::string preset_path(const ImportArguments& arguments);

/// Writes the preset: the plant, a metre along its longest side, before the wall of the studio.
void write_imported(const ImportArguments& arguments, const ImportedPlant& plant);

/// The command for grammars of LParser and Houdini, whose rules it writes into the preset.
void import_rules(const ImportArguments& arguments);

}  // namespace frond
