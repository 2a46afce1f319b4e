#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "core/result.h"

/// Stills that pictures of docs/gallery are made of, and hashes of their scenes, which tell a picture that is
/// older than what it shows.
namespace frond {

/// A picture to be rendered.
struct Still {
  std::filesystem::path preset;
  int frame = 1;
  std::array<int, 2> size{};
  std::string quality = "good";
  std::vector<std::string> sets;
};

/// A picture that was rendered, and a hash of the scene that it shows.
struct Rendered {
  std::filesystem::path picture;
  std::string scene_id;
};

/// A hash of the scenes of a folder and of what they are made of there, with the macros of povinc that they
/// reach and, where the folder has a build.ninja, the flags that POV-Ray is called with.
Result<std::string> scene_id(const std::filesystem::path& root, const std::filesystem::path& folder,
                             const std::vector<std::filesystem::path>& scenes);

/// The scenes of one frame in the folder of a film: one an exposure.
std::vector<std::filesystem::path> scenes_of(const std::filesystem::path& film, int frame);

/// Runs a program for the folder of Frond, whose words are for people.
Errors call_for(const std::filesystem::path& root, std::vector<std::string> words,
                const std::filesystem::path& folder = {});

/// Writes the scene of a still in a folder.
Errors write_scene(const std::filesystem::path& root, const Still& still,
                   const std::filesystem::path& folder);

/// Renders a still in a folder, unless it is there and nothing has changed.
Result<Rendered> render_still(const std::filesystem::path& root, const Still& still,
                              const std::filesystem::path& folder);

/// A hash of all that the scenes of stills are made from: this program, their presets and the files these
/// name, templates and macros. Empty where a preset cannot be read.
std::string source_id(const std::filesystem::path& root, const std::vector<Still>& stills);

/// The file of the hashes below a folder of Frond.
std::filesystem::path scene_ids_file(const std::filesystem::path& root);

/// Notes the hash of what a picture shows.
Errors note_scene_id(const std::filesystem::path& root, const std::string& name, const std::string& id);

}  // namespace frond
