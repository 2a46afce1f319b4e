#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "cli/gallery_scenes.h"
#include "core/result.h"
#include "render/gallery.h"
#include "render/jpeg.h"

namespace frond {

// Names of pictures that are not of the list, and beginnings of such.
inline constexpr std::string_view kGrammarSheet = "grammars", kExamplePrefix = "example-",
                                  kLargePrefix = "large/";

/// A picture that was rendered, and a hash of the scene that it shows.
struct Rendered {
  std::filesystem::path picture;
  std::string scene_id;
};

/// The pictures of docs/gallery, made from the presets as they are.
class Gallery {
 public:
  /// The folder of Frond, that of what pictures are made of, the list, and the names asked for, of which
  /// those of large pictures begin with "large/".
  Gallery(std::filesystem::path root, std::filesystem::path work, GalleryList list,
          std::vector<std::string> names)
      : root_(std::move(root)), work_(std::move(work)), list_(std::move(list)), names_(std::move(names)) {}

  /// The names of all pictures, large ones last.
  std::vector<std::string> all_names() const;
  /// What of the names is none; empty where all are.
  std::string wrong_name() const;

  Errors render();
  /// Tells which pictures do not show what their presets are now.
  Errors tell_stale();
  /// Tells which pictures of the folder are not of the list.
  void tell_others() const;

 private:
  bool wanted(const std::string& name) const {
    return names_.empty() ? !name.starts_with(kLargePrefix) : std::ranges::find(names_, name) != names_.end();
  }
  std::vector<std::filesystem::path> scenes() const;
  Errors call(std::vector<std::string> words, const std::filesystem::path& folder = {}) const;
  Errors write_scene(const Still& still, const std::filesystem::path& folder) const;
  Result<Rendered> still(const Still& still, const std::filesystem::path& folder) const;
  std::vector<Still> stills_of(const GalleryPicture& picture, bool large) const;
  Errors picture(const GalleryPicture& picture, bool large);
  Errors note_row(const GalleryPicture& picture) const;
  Errors pictures();
  Errors examples();
  Errors grammars();
  Errors page() const;
  Result<ExampleScene> write_example(const std::filesystem::path& scene,
                                     const std::filesystem::path& folder) const;
  Errors example(const std::filesystem::path& scene, const std::string& name) const;
  Result<std::vector<Still>> write_grammars() const;
  Result<Rendered> grammar(const Still& one) const;
  Errors show(JpegJob job, const std::filesystem::path& scratch, const std::string& name) const;
  Result<std::string> id_now(const std::vector<Still>& stills, const std::string& name) const;
  Result<std::string> example_id(const std::filesystem::path& scene,
                                 const std::filesystem::path& folder) const;
  Result<std::string> id_now(const std::string& name) const;

  std::filesystem::path root_, work_;
  GalleryList list_;
  std::vector<std::string> names_;
};

}  // namespace frond
