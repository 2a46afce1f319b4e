#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"

/// The pictures of docs/gallery, as text: the list of them, and the page that shows them.
namespace frond {

/// A part of a picture: one frame of one preset.
struct GalleryPart {
  std::string preset;  ///< its path below presets/, without .json
  int frame = 1;
  std::vector<std::string> sets;  ///< POINTER=VALUE
};

struct GalleryPicture {
  std::string name;
  std::array<int, 2> size{};  ///< of each part, in pixels
  int columns = 1;            ///< that the parts are laid in
  std::vector<GalleryPart> parts;
};

struct GalleryList {
  std::vector<GalleryPicture> pictures;
  std::vector<std::string> large;  ///< names of those that are rendered large, too
};

/// Reads it from the text of a file, a picture a line: NAME WIDTHxHEIGHT COLUMNS PRESET[@FRAME][,SET]...
Result<GalleryList> read_gallery(std::string_view text, const std::string& file_name);

/// The size of a picture that is as wide as large ones are.
std::array<int, 2> large_size(std::array<int, 2> size);

/// What the page says of a picture.
struct GalleryRow {
  std::uint64_t seed = 0;
  std::size_t nodes = 0;          ///< of all parts
  std::optional<double> seconds;  ///< of processor; none where there is no telling
};

/// The row of a picture. Where there is no telling how long it took, it keeps what it had on the page before.
std::string gallery_row(const GalleryPicture& picture, const GalleryRow& row, std::string_view page);

/// The row that a picture has on a page; empty where it has none.
std::string row_on_page(std::string_view page, const std::string& name);

/// A row whose picture leads to its large one.
std::string row_with_large(const std::string& row, const std::string& name);

/// The page of these rows, each a line.
std::string gallery_page(const std::vector<std::string>& rows);

/// Hashes of the scenes that pictures show, by their names; those of large ones begin with "large/".
using SceneIds = std::map<std::string, std::string>;

/// Reads them from the text of a file and writes that, a line each: NAME HASH. Other lines do not count.
SceneIds read_scene_ids(std::string_view text);
std::string scene_ids_text(const SceneIds& ids);

/// A scene of docs/examples says in its first lines how it is made.
struct ExampleScene {
  std::vector<std::vector<std::string>> calls;  ///< of this program, the words behind its name
  std::array<int, 2> size{};
};

ExampleScene read_example(std::string_view scene);

/// A preset that shows a grammar: a layout whose line @grammar@ gives way to it, and @organs@ to the organs
/// that it places.
std::string grammar_preset(std::string_view layout, std::string_view grammar);

}  // namespace frond
