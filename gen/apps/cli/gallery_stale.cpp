#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cli/gallery.h"
#include "cli/messages.h"
#include "cli/streams.h"
#include "core/content.h"
#include "core/files.h"

// Which pictures of docs/gallery are older than what they show: gallery --stale.

namespace frond {

namespace fs = std::filesystem;

/// A hash of the scenes of stills that are written only to be read. What is known of the same sources is not
/// asked again.
Result<std::string> Gallery::id_now(const std::vector<Still>& stills, const std::string& name) const {
  fs::path known = work_ / "scenes" / name;
  std::string source = source_id(root_, stills);
  Result<std::string> text = read_file(known);
  SceneIds ids = read_scene_ids(text ? *text : "");
  if (!source.empty() && ids.contains(source)) return ids[source];
  std::string all;
  for (const Still& one : stills) {
    fs::path folder = known.string() + "-scene";
    std::error_code error;
    fs::remove_all(folder, error);
    if (Errors errors = write_scene(one, folder); !errors.empty()) return errors;
    Result<std::string> id = scene_id(root_, folder / "frames", scenes_of(folder, one.frame));
    fs::remove_all(folder, error);
    if (!id) return id;
    all += *id + "\n";
  }
  std::string id = content_id(all);
  Result<bool> written = write_file(known, scene_ids_text({{source, id}}));
  if (!written) return written.errors();
  return id;
}

Result<std::string> Gallery::example_id(const fs::path& scene, const fs::path& folder) const {
  Result<ExampleScene> written = write_example(scene, folder);
  return written ? scene_id(root_, folder, {scene}) : written.errors();
}

Result<std::string> Gallery::id_now(const std::string& name) const {
  bool large = name.starts_with(kLargePrefix);
  for (const GalleryPicture& picture : list_.pictures)
    if (picture.name == name.substr(large ? kLargePrefix.size() : 0))
      return id_now(stills_of(picture, large), name);
  if (name == kGrammarSheet) {
    Result<std::vector<Still>> stills = write_grammars();
    return stills ? id_now(*stills, name) : stills.errors();
  }
  fs::path folder = work_ / "scenes" / name;
  Result<std::string> id =
      example_id(root_ / "docs" / "examples" / (name.substr(kExamplePrefix.size()) + ".pov"), folder);
  std::error_code error;
  fs::remove_all(folder, error);
  return id;
}

Errors Gallery::tell_stale() {
  Result<std::string> text = read_file(scene_ids_file(root_));
  SceneIds noted = read_scene_ids(text ? *text : "");
  for (const std::string& name : names_.empty() ? all_names() : names_) {
    std::error_code error;
    if (!fs::exists(root_ / "docs" / "gallery" / (name + ".jpg"), error)) {
      tell(fmt::format("{}: there is no such picture", name));
    } else if (!noted.contains(name)) {
      tell(fmt::format("{}: what it shows is not noted", name));
    } else {
      Result<std::string> id = id_now(name);
      if (!id) return id.errors();
      if (*id == noted[name]) continue;
      tell(fmt::format("{}: its scene is another now", name));
    }
    put(name + "\n");
    flush();
  }
  return {};
}

void Gallery::tell_others() const {
  std::vector<std::string> known = all_names(), others;
  for (const fs::path& file : files_in(root_ / "docs" / "gallery"))
    if (fs::path type = file.extension(); type == ".jpg" || type == ".png" || type == ".svg")
      if (std::ranges::find(known, file.stem().string()) == known.end())
        others.push_back(file.filename().string());
  if (!others.empty())
    tell(fmt::format("note: pictures that are made elsewhere, whose age is not known: {}",
                     fmt::join(others, " ")));
}

}  // namespace frond
