#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "scene/preset.h"
#include "studio/made_files.h"
#include "studio/packet.h"
#include "studio/put_files.h"
#include "studio/studio.h"

namespace frond {

/// The text of a preset on its way, and the file whose it is: what messages call it, and where the files that
/// it names are looked for.
struct Doc {
  std::string text;
  std::filesystem::path file;
};

/// An answer to the page: JSON, or bytes.
struct Answer {
  int status = 200;  ///< of HTTP; 204: nothing is said
  Json json = {};
  std::string packet = {};
  const char* type = nullptr;  ///< of the packet; none: it is the JSON that is sent
};

/// The answer that something was not allowed, or not found.
Answer refused(int status, std::string_view why);

/// The files that the page may see.
class Documents {
 public:
  explicit Documents(const StudioOptions& options);

  /// What the page begins with: the preset to open, and those that Frond brings.
  Json opened() const;
  Json shipped() const;

  /// The folder of one's own presets.
  const std::filesystem::path& folder() const { return folder_; }
  /// Whether a file may be read; its path without links.
  std::optional<std::filesystem::path> readable(const std::string& file) const;
  /// `{"file", "text", "disk", "copy"}` of a preset.
  Result<Json> read(const std::string& file) const;
  /// What stands for a file as it is on the disk; empty where it is not there, or may not be read.
  std::string disk(const std::string& file) const;
  /// The presets in the folders that may be written, those first that were written last.
  Json own() const;
  /// A file of the documentation: of the shelf "gallery" the picture of a shipped preset, of "strip" that of
  /// a property, of "docs" a page, "presets.md" or "kinds/tree.md".
  Result<std::string> leaf(const std::string& shelf, const std::string& name) const;
  /// The properties of which there are pictures, each three in a row: `["tree-habit-droop", …]`.
  Json strips() const;

  /// Reads a preset; files that it names only from where it may.
  Result<Preset> preset(const Doc& doc, const std::vector<std::string>& sets = {}) const;

  /// Writes a preset where it may, with the files that it names where it comes from another folder. `disk`
  /// stands for what the page believes to be there, empty: nothing.
  Answer save(const std::string& file, const Doc& doc, const std::string& disk, bool overwrite) const;
  /// Puts a picture (".png") beside the preset under a name like the one given, for the preset `of`: see
  /// studio/made_files.h.
  Answer add_file(const std::string& name, const char* type, const std::string& content,
                  const std::string& of) const;
  /// Puts a mesh beside the preset as add_file() does a picture, and those of the files `beside` that the
  /// mesh names, see put_mesh(); 400 where it is no mesh.
  Answer add_mesh(const std::string& name, const std::string& content,
                  const std::map<std::string, std::string>& beside, const std::string& of) const;
  /// Puts a grammar with some texts changed beside the preset as add_file() does a picture, see
  /// put_grammar().
  Answer add_grammar(const std::filesystem::path& grammar, const std::map<std::string, std::string>& texts,
                     const std::string& of) const;
  /// Puts back what was removed because no preset named it, if that text does.
  void restore(const std::string& text) const { made_->restore(text); }

 private:
  /// Where a file that the page names is to be written; empty where it may not be.
  std::optional<std::filesystem::path> writable(const std::string& file) const;

  /// Puts files beside the preset `of` and notes them for it; `fault` is the answer where they cannot be put.
  Answer add(const std::string& of, int fault, const std::function<Result<PutFiles>()>& put) const;
  /// Whether a preset may read what lies in the folder of one's own.
  bool reaches(const std::filesystem::path& of) const;

  std::filesystem::path presets_, docs_, folder_;
  std::shared_ptr<MadeFiles> made_;
  std::optional<std::filesystem::path> preset_, assets_;
};

/// `[{"text", "where", "line", "column", "pointer"}]`
Json errors_json(const Errors& errors);

}  // namespace frond
