#include "studio/mesh_files.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <vector>

#include "core/files.h"
#include "core/printable.h"
#include "core/work_folder.h"
#include "geometry/mesh_file.h"
#include "geometry/mesh_formats.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

constexpr std::array kBeside{".mtl", ".png", ".jpg", ".jpeg", ".webp"};  // what a mesh may name

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// Whether a file of that name may lie beside a mesh: a plain one, in no other folder.
bool may_lie_beside(const std::string& name) {
  return !name.starts_with('.') && name.find_first_of("/\\") == name.npos && name.find('\0') == name.npos &&
         std::ranges::find(kBeside, lower(fs::path(name).extension().string())) != kBeside.end();
}

/// The files that a mesh names, as seen from its folder.
std::map<std::string, std::string> named_by(const fs::path& mesh, const std::vector<fs::path>& noted) {
  std::map<std::string, std::string> found;
  for (const fs::path& file : noted) {
    std::string name = file.lexically_relative(mesh.parent_path()).string();
    if (name.empty() || name.starts_with("..")) continue;
    if (Result<std::string> content = read_file(file)) found.emplace(std::move(name), std::move(*content));
  }
  return found;
}

/// Puts a mesh into a folder, in one of its own where it names others.
Result<PutFiles> put(const fs::path& folder, const std::string& name, const std::string& content,
                     std::map<std::string, std::string> named) {
  if (named.empty()) return put_beside(folder, name, content);
  named.emplace(name, content);
  Result<PutFiles> own = put_folder(folder, fs::path(name).stem().string(), named);
  if (own) own->name += "/" + name;
  return own;
}

}  // namespace

bool is_mesh_name(const fs::path& file) {
  const std::string type = lower(file.extension().string());
  return type == ".obj" || type == ".ply" || type == ".stl" || type == ".glb";
}

Result<PutFiles> put_mesh(const fs::path& folder, const std::string& name, const std::string& content,
                          const std::map<std::string, std::string>& beside) {
  // It is read where nobody else sees it, to learn whether it can be, and what it names.
  WorkFolder tried;
  const fs::path file = tried.path() / "mesh";
  for (const auto& [other, bytes] : beside)
    if (may_lie_beside(other))
      if (Result<bool> written = write_file(tried.path() / other, bytes); !written) return written.errors();
  std::vector<fs::path> noted;
  if (Result<PolygonMesh> mesh = read_mesh_file({file, content, &noted}); !mesh) {
    Error first = mesh.errors().front();
    // Lines are told as of the file that was sent.
    if (first.where.starts_with(file.string())) first.where.replace(0, file.string().size(), name);
    return first;
  }
  const std::string stem = plain_name(fs::path(name).stem().string(), "mesh").substr(0, 60);
  return put(folder, stem + mesh_ending(content), content, named_by(file, noted));
}

Result<PutFiles> copy_mesh(const fs::path& folder, const fs::path& file) {
  Result<std::string> content = read_file(file);
  if (!content) return content.errors();
  std::vector<fs::path> noted;
  (void)read_mesh_file({file, *content, &noted});
  return put(folder, file.filename().string(), *content, named_by(file, noted));
}

}  // namespace frond
