#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "core/result.h"

/// Hashes of the scenes that the pictures of docs/gallery show, which tell a picture that is older than what
/// it shows.
namespace frond {

/// A picture to be rendered.
struct Still {
  std::filesystem::path preset;
  int frame = 1;
  std::array<int, 2> size{};
  std::string quality = "good";
  std::vector<std::string> sets;
};

/// A hash of the scenes of a folder and of what they are made of there, with the macros of povinc that they
/// reach and, where the folder has a build.ninja, the flags that POV-Ray is called with.
Result<std::string> scene_id(const std::filesystem::path& root, const std::filesystem::path& folder,
                             const std::vector<std::filesystem::path>& scenes);

/// The scenes of one frame in the folder of a film: one an exposure.
std::vector<std::filesystem::path> scenes_of(const std::filesystem::path& film, int frame);

/// A hash of all that the scenes of stills are made from: this program, their presets and the files these
/// name, templates and macros. Empty where a preset cannot be read.
std::string source_id(const std::filesystem::path& root, const std::vector<Still>& stills);

/// The file of the hashes below a folder of Frond.
std::filesystem::path scene_ids_file(const std::filesystem::path& root);

/// Notes the hash of what a picture shows.
Errors note_scene_id(const std::filesystem::path& root, const std::string& name, const std::string& id);

}  // namespace frond
