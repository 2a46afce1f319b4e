#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "core/result.h"
#include "studio/put_files.h"

// Meshes beside a preset, with the files that they name: those of an OBJ's materials and their pictures.
namespace frond {

/// Puts a mesh into a folder; returns its name there. It ends as what it holds demands, whatever `name` ends
/// with. `beside` are files by their names that the mesh may need: where it names some of them it gets a
/// folder of its own with these, in which all keep their names. What is there already is taken as it is. An
/// error where the content is no mesh that Frond reads; nothing is written then.
Result<PutFiles> put_mesh(const std::filesystem::path& folder, const std::string& name,
                          const std::string& content, const std::map<std::string, std::string>& beside);

/// Puts a mesh that lies in another folder, with what it names there, into a folder, as put_mesh() does. What
/// cannot be read as a mesh is copied as it is.
Result<PutFiles> copy_mesh(const std::filesystem::path& folder, const std::filesystem::path& file);

/// Whether a file's name ends as those of meshes do.
bool is_mesh_name(const std::filesystem::path& file);

}  // namespace frond
