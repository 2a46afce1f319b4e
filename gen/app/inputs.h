#pragma once

#include <filesystem>

#include "app/commands.h"
#include "core/result.h"
#include "scene/preset.h"

namespace frond {

/// The folder that holds templates/, povinc/ and presets/: $FROND_HOME, or the one above the program's own.
Result<std::filesystem::path> home();

/// Reads the preset that the command line names, with its overrides.
Result<Preset> load_preset(const PresetArguments& arguments);

/// Reads the OBJ file of lines that a grammar's guide names, if it names one, from the folder of the file
/// that the grammar stands in.
Errors load_guide(GuideText& guide, const std::filesystem::path& file, const std::string& pointer);

/// Whether a file holds a grammar rather than a preset: one of another tool, or JSON without organisms.
bool is_grammar(const std::string& path);

/// A range as in `--frames 5-12` or `--frames 7`, within 1..count.
struct FrameRange {
  int first, last;
};
Result<FrameRange> read_frames(const std::string& text, int count);

/// Prints errors to stderr, one a line; returns the given exit code.
int fail(const Errors& errors, ExitCode code);

}  // namespace frond
