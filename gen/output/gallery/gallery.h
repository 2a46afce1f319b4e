#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "gallery/gallery_list.h"

/// The pictures of docs/gallery, made from the presets as they are.
namespace frond {

/// What the names of large pictures begin with.
inline constexpr std::string_view kLargePrefix = "large/";

struct GalleryOrder {
  std::filesystem::path root;      ///< the folder of Frond
  std::filesystem::path work;      ///< a folder that keeps what the pictures are made of
  GalleryList list;                ///< of docs/gallery/pictures.txt
  std::vector<std::string> names;  ///< of pictures; none: all, but for large ones where they are rendered
};

/// What of the names is no picture; empty where all are.
std::string wrong_name(const GalleryOrder& order);

/// Is told each picture that lies there now, as seen from the folder of Frond.
using GalleryListener = std::function<void(const std::string& picture)>;

/// Renders what has changed, and writes the page docs/gallery.md. Run again it goes on where it stopped.
Errors render_gallery(const GalleryOrder& order, const GalleryListener& made);

/// Is told each picture that does not show what its presets are now, and why.
using FoundStale = std::function<void(const std::string& name, std::string_view why)>;

/// Renders nothing, but writes the scenes anew. What is known of the same program and presets is not written
/// again.
Errors find_stale(const GalleryOrder& order, const FoundStale& found);

/// The pictures in docs/gallery that are not of the list.
std::vector<std::string> others_in_gallery(const GalleryOrder& order);

}  // namespace frond
