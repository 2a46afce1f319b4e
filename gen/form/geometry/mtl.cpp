#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/files.h"
#include "core/printable.h"
#include "core/text.h"
#include "geometry/mesh_formats.h"
#include "geometry/text_lines.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

/// The name of a file behind options such as `-s 2 2 1`, which begin with a hyphen and are followed by
/// numbers or a word.
std::string map_name(std::string_view rest) {
  while (rest.starts_with('-')) {
    auto drop_word = [&] {
      rest.remove_prefix(std::min(rest.find_first_of(" \t"), rest.size()));
      rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
    };
    drop_word();
    drop_word();
    while (number_of(rest.substr(0, rest.find_first_of(" \t")))) drop_word();
  }
  return std::string(rest);
}

/// A file of that name in a folder or below it; also by its last part alone, for names that hold the folders
/// of another machine.
std::optional<fs::path> found_below(const fs::path& folder, std::string name) {
  std::ranges::replace(name, '\\', '/');
  std::error_code error;
  fs::path top = fs::weakly_canonical(folder.empty() ? "." : folder, error);
  if (error || name.find('\0') != name.npos) return std::nullopt;
  for (const fs::path& path : {fs::path(name), fs::path(name).filename()}) {
    if (path.empty() || path.is_absolute()) continue;
    fs::path real = fs::weakly_canonical(top / path, error);
    if (error || !fs::is_regular_file(real, error)) continue;
    auto [rest, step] = std::mismatch(top.begin(), top.end(), real.begin(), real.end());
    if (rest == top.end()) return real;
  }
  return std::nullopt;
}

/// Reads what an MTL text says of the materials that a mesh names: `Kd`, `d` or `Tr`, `map_Kd`.
void read_mtl(std::string_view text, PolygonMesh& mesh) {
  TextLines lines(text);
  MeshMaterial* material = nullptr;
  while (lines.next()) {
    std::string kind = lower_case(lines.word());
    if (kind == "newmtl") {
      auto found = std::ranges::find(mesh.material, lines.others(), &MeshMaterial::name);
      material = found == mesh.material.end() ? nullptr : &*found;
    }
    if (!material) continue;
    if (kind == "kd") {
      std::optional<double> red = number_of(lines.word()), green = number_of(lines.word()),
                            blue = number_of(lines.word());
      auto channel = [](double x) { return static_cast<float>(std::clamp(x, 0.0, 1.0)); };
      // One number stands for all three.
      if (red)
        material->color = Color{channel(*red), channel(green.value_or(*red)), channel(blue.value_or(*red))};
    }
    if (kind == "d" || kind == "tr") {
      std::optional<double> x = number_of(lines.word());
      if (x) material->opacity = std::clamp(kind == "d" ? *x : 1 - *x, 0.0, 1.0);
    }
    if (kind == "map_kd") material->picture_name = map_name(lines.others());
  }
}

}  // namespace

void read_materials(const fs::path& obj, PolygonMesh& mesh, std::vector<fs::path>* noted,
                    std::string* content) {
  std::error_code error;
  const fs::path top = fs::weakly_canonical(obj.parent_path().empty() ? "." : obj.parent_path(), error);
  auto read = [&](const std::string& name) -> std::optional<std::string> {
    std::optional<fs::path> path = found_below(obj.parent_path(), name);
    if (!path) return std::nullopt;
    Result<std::string> text = read_file(*path);
    if (!text) return std::nullopt;
    if (noted) noted->push_back(obj.parent_path() / path->lexically_relative(top));
    if (content) *content += *text;
    return std::move(*text);
  };
  for (const std::string& library : mesh.library) {
    // A name may hold blanks, or there are several.
    std::vector<std::string> names{library};
    if (!found_below(obj.parent_path(), library) && library.find(' ') != library.npos) {
      TextLines words(library);
      words.next();
      std::vector<std::string> parts;
      for (std::string_view word = words.word(); !word.empty(); word = words.word()) parts.emplace_back(word);
      auto is_there = [&](const std::string& name) {
        return found_below(obj.parent_path(), name).has_value();
      };
      if (std::ranges::any_of(parts, is_there)) names = std::move(parts);
    }
    for (const std::string& name : names) {
      if (std::optional<std::string> text = read(name))
        read_mtl(*text, mesh);
      else
        mesh.notes.push_back(fmt::format(
            "names the file of materials \"{}\", which is not in its folder; its colours are not known",
            printable(name)));
    }
  }
  for (MeshMaterial& material : mesh.material) {
    if (material.picture_name.empty() || material.picture) continue;
    if (std::optional<std::string> bytes = read(material.picture_name))
      material.picture = std::make_shared<const std::string>(std::move(*bytes));
    else
      mesh.notes.push_back(fmt::format("material \"{}\" names the picture \"{}\", which is not in its folder",
                                       printable(material.name), printable(material.picture_name)));
  }
}

}  // namespace frond
