#include "gallery/gallery.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/content.h"
#include "core/files.h"
#include "gallery/stills.h"
#include "jobs/jobs.h"
#include "pipeline/frame_times.h"
#include "render/film.h"
#include "render/jpeg.h"
#include "render/process.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

// Names of pictures that are not of the list, and beginnings of such.
constexpr std::string_view kGrammarSheet = "grammars", kExamplePrefix = "example-";

class Gallery {
 public:
  explicit Gallery(const GalleryOrder& order, GalleryListener made = {})
      : root_(order.root),
        work_(order.work),
        list_(order.list),
        names_(order.names),
        made_(std::move(made)) {}

  std::string wrong_name() const {
    std::vector<std::string> all = all_names();
    for (const std::string& name : names_) {
      if (std::ranges::find(all, name) != all.end()) continue;
      if (!name.starts_with(kLargePrefix))
        return fmt::format("{}: no picture of docs/gallery/pictures.txt", name);
      return fmt::format("{}: no picture of --large; expected some of {}", name.substr(kLargePrefix.size()),
                         fmt::join(list_.large, " "));
    }
    return {};
  }

  Errors render() {
    Errors errors = pictures();
    if (errors.empty()) errors = examples();
    if (errors.empty()) errors = grammars();
    bool only_large = !names_.empty() && std::ranges::all_of(names_, [](const std::string& name) {
      return name.starts_with(kLargePrefix);
    });
    return errors.empty() && !only_large ? page() : errors;
  }

  Errors find_stale(const FoundStale& found) const {
    Result<std::string> text = read_file(scene_ids_file(root_));
    SceneIds noted = read_scene_ids(text ? *text : "");
    for (const std::string& name : names_.empty() ? all_names() : names_) {
      if (!path_exists(root_ / "docs" / "gallery" / (name + ".jpg"))) {
        found(name, "there is no such picture");
      } else if (!noted.contains(name)) {
        found(name, "what it shows is not noted");
      } else {
        Result<std::string> id = id_now(name);
        if (!id) return id.errors();
        if (*id != noted[name]) found(name, "its scene is another now");
      }
    }
    return {};
  }

  std::vector<std::string> others() const {
    std::vector<std::string> known = all_names(), others;
    for (const fs::path& file : files_in(root_ / "docs" / "gallery"))
      if (fs::path type = file.extension(); type == ".jpg" || type == ".png" || type == ".svg")
        if (std::ranges::find(known, file.stem().string()) == known.end())
          others.push_back(file.filename().string());
    return others;
  }

 private:
  bool wanted(const std::string& name) const {
    return names_.empty() ? !name.starts_with(kLargePrefix) : std::ranges::find(names_, name) != names_.end();
  }

  /// The names of all pictures, large ones last.
  std::vector<std::string> all_names() const {
    std::vector<std::string> names;
    for (const GalleryPicture& picture : list_.pictures) names.push_back(picture.name);
    for (const fs::path& scene : scenes())
      names.push_back(std::string(kExamplePrefix) + scene.stem().string());
    names.emplace_back(kGrammarSheet);
    for (const std::string& name : list_.large) names.push_back(std::string(kLargePrefix) + name);
    return names;
  }

  std::vector<fs::path> scenes() const {
    std::vector<fs::path> scenes = files_in(root_ / "docs" / "examples");
    std::erase_if(scenes, [](const fs::path& file) { return file.extension() != ".pov"; });
    return scenes;
  }

  /// Makes docs/gallery/NAME.jpg, and tells it.
  Errors show(JpegJob job, const fs::path& scratch, const std::string& name) const {
    job.ffmpeg = environment_or("FROND_FFMPEG", "ffmpeg");
    fs::path place = fs::path("docs") / "gallery" / (name + ".jpg");
    if (Errors errors = write_jpeg(job, scratch, root_ / place); !errors.empty()) return errors;
    made_(place.string());
    return {};
  }

  std::vector<Still> stills_of(const GalleryPicture& picture, bool large) const {
    std::vector<Still> stills;
    for (const GalleryPart& part : picture.parts)
      stills.push_back({root_ / "presets" / (part.preset + ".json"), part.frame,
                        large ? large_size(picture.size) : picture.size, "good", part.sets});
    return stills;
  }

  Errors picture(const GalleryPicture& picture, bool large) {
    JpegJob job{{}, large ? large_size(picture.size) : picture.size, picture.columns, ""};
    std::string made = picture.name + (large ? "-large" : ""),
                name = std::string(large ? kLargePrefix : "") + picture.name;
    std::vector<Still> stills = stills_of(picture, large);
    std::string ids;
    for (const Still& one : stills) {
      Result<Rendered> part =
          render_still(root_, one, work_ / fmt::format("{}-{}", made, job.pictures.size()));
      if (!part) return part.errors();
      job.pictures.push_back(part->picture);
      ids += part->scene_id + '\n';
    }
    if (Errors errors = show(job, work_ / (made + ".jpg"), name); !errors.empty()) return errors;
    if (Errors errors = note_scene_id(root_, name, content_id(ids)); !errors.empty()) return errors;
    return large ? Errors{} : note_row(picture);
  }

  /// Notes what the page will say of a picture.
  Errors note_row(const GalleryPicture& picture) const {
    GalleryRow row;
    row.seconds = 0;
    for (std::size_t i = 0; i < picture.parts.size(); ++i) {
      fs::path folder = work_ / fmt::format("{}-{}", picture.name, i);
      Result<Manifest> manifest = manifest_in(folder);
      if (!manifest) return manifest.errors();
      row.seed = manifest->seed;
      row.nodes += manifest->frames.back().nodes;
      std::vector<FrameTime> times = read_times(folder);
      if (times.empty()) row.seconds.reset();  // a run that was killed could not say what it took
      if (row.seconds) *row.seconds += times.back().seconds;
    }
    Result<std::string> page = read_file(root_ / "docs" / "gallery.md");
    Result<bool> written =
        write_file(work_ / "rows" / picture.name, gallery_row(picture, row, page ? *page : "") + "\n");
    return written ? Errors{} : written.errors();
  }

  Errors pictures() {
    for (bool large : {false, true})
      for (const GalleryPicture& each : list_.pictures) {
        if (!wanted(std::string(large ? kLargePrefix : "") + each.name)) continue;
        if (Errors errors = picture(each, large); !errors.empty()) {
          errors.push_back({"", each.name + " could not be rendered"});
          return errors;
        }
      }
    return {};
  }

  /// A scene of docs/examples; its first lines hold the commands that make what it includes, in that folder.
  Result<ExampleScene> write_example(const fs::path& scene, const fs::path& folder) const {
    Result<std::string> text = read_file(scene);
    if (!text) return text.errors();
    ExampleScene example = read_example(*text);
    std::error_code error;
    fs::create_directories(folder, error);
    for (std::vector<std::string> words : example.calls) {
      for (std::string& word : words) {
        if (word.starts_with("presets/")) word = (root_ / word).string();
        if (word.ends_with(".inc")) word = (folder / word).string();
      }
      words.insert(words.begin(), own_program().string());
      words.emplace_back("-q");
      if (Errors errors = call_for(root_, words); !errors.empty()) return errors;
    }
    return example;
  }

  Errors example(const fs::path& scene, const std::string& name) const {
    fs::path folder = work_ / name;
    Result<ExampleScene> written = write_example(scene, folder);
    if (!written) return written.errors();
    const ExampleScene& example = *written;
    std::string picture = name + ".png";
    OutputCapture said;  // POV-Ray's own, which are many
    Command render;
    render.words = {environment_or("FROND_POVRAY", "povray"), "+I" + scene.string(), "+O" + picture};
    render.add({fmt::format("+W{}", example.size[0]), fmt::format("+H{}", example.size[1]), "+A", "-D"});
    render.folder = folder;
    render.out = render.err = said.descriptor();
    render.end_with = SIGTERM;
    Result<int> code = run(render);
    if (!code || *code != 0) return {{"", name + " could not be rendered"}};
    Result<std::string> id = scene_id(root_, folder, {scene});
    if (!id) return id.errors();
    Errors errors = show({{folder / picture}, {}, 1, ""}, folder / (name + ".jpg"), name);
    return errors.empty() ? note_scene_id(root_, name, *id) : errors;
  }

  Errors examples() {
    for (const fs::path& scene : scenes()) {
      std::string name = std::string(kExamplePrefix) + scene.stem().string();
      if (!wanted(name)) continue;
      if (Errors errors = example(scene, name); !errors.empty()) return errors;
    }
    return {};
  }

  /// A preset for each grammar of presets/grammars, before the studio's wall. At this size a draft shows all.
  Result<std::vector<Still>> write_grammars() const {
    constexpr int kSide = 200;
    Result<std::string> layout = read_file(root_ / "docs" / "gallery" / "grammar.txt");
    if (!layout) return layout.errors();
    std::vector<Still> stills;
    for (const fs::path& file : files_in(root_ / "presets" / "grammars")) {
      bool draws = file.stem() != "algae" && file.stem() != "cells";  // words without lines
      if (file.extension() != ".json" || !draws) continue;
      Result<std::string> text = read_file(file);
      if (!text) return text.errors();
      fs::path preset = work_ / kGrammarSheet / file.filename();
      Result<bool> written = write_file(preset, grammar_preset(*layout, *text));
      if (!written) return written.errors();
      stills.push_back({preset, 1, {kSide, kSide}, "draft", {}});
    }
    return stills;
  }

  /// The picture of a grammar with its name below it.
  Result<Rendered> grammar(const Still& one) const {
    std::string name = one.preset.stem();
    fs::path place = work_ / kGrammarSheet / name;
    Result<Rendered> picture = render_still(root_, one, place);
    if (!picture) return picture;
    // Names are of letters, digits, dashes and underscores, which need no quotes in a filter.
    Errors errors = call_for(
        root_, {environment_or("FROND_FFMPEG", "ffmpeg"), "-y", "-nostdin", "-loglevel", "error", "-i",
                "file:" + picture->picture.string(), "-vf",
                fmt::format("format=rgb24,pad=iw:ih+28:0:0:0x202020,drawtext=text={}:fontcolor=white:"
                            "fontsize='clip(w/14,8,16)':x='max(0,(w-tw)/2)':y=h-20",
                            name),
                "file:" + place.string() + ".png"});
    if (!errors.empty()) return errors;
    return Rendered{place.string() + ".png", std::move(picture->scene_id)};
  }

  Errors grammars() {
    constexpr int kColumns = 8, kWidth = 200;
    if (!wanted(std::string(kGrammarSheet))) return {};
    Result<std::vector<Still>> stills = write_grammars();
    if (!stills) return stills.errors();
    SheetJob sheet{{}, work_ / "grammars.png", kColumns, kWidth, environment_or("FROND_FFMPEG", "ffmpeg")};
    std::string ids;
    for (const Still& one : *stills) {
      Result<Rendered> picture = grammar(one);
      if (!picture) return picture.errors();
      sheet.pictures.push_back(picture->picture);
      ids += picture->scene_id + '\n';
    }
    if (Errors errors = tile_sheet(sheet); !errors.empty()) return errors;
    std::string name(kGrammarSheet);
    Errors errors = show({{sheet.sheet}, {}, 1, ""}, work_ / (name + ".jpg"), name);
    return errors.empty() ? note_scene_id(root_, name, content_id(ids)) : errors;
  }

  /// Writes docs/gallery.md. What was not rendered now keeps its row.
  Errors page() const {
    fs::path file = root_ / "docs" / "gallery.md";
    Result<std::string> before = read_file(file);
    std::vector<std::string> rows;
    for (const GalleryPicture& picture : list_.pictures) {
      Result<std::string> noted = read_file(work_ / "rows" / picture.name);
      std::string row = noted ? noted->substr(0, noted->find('\n'))
                              : row_on_page(before ? *before : std::string_view(), picture.name);
      if (row.empty()) continue;
      bool large = path_exists(root_ / "docs" / "gallery" / "large" / (picture.name + ".jpg"));
      rows.push_back(large ? row_with_large(row, picture.name) : row);
    }
    Result<bool> written = write_file(file, gallery_page(rows));
    return written ? Errors{} : written.errors();
  }

  /// A hash of the scenes of stills that are written only to be read. What is known of the same sources is
  /// not asked again.
  Result<std::string> id_now(const std::vector<Still>& stills, const std::string& name) const {
    fs::path known = work_ / "scenes" / name;
    std::string source = source_id(root_, stills);
    Result<std::string> text = read_file(known);
    SceneIds ids = read_scene_ids(text ? *text : "");
    if (!source.empty() && ids.contains(source)) return ids[source];
    std::string all;
    for (const Still& one : stills) {
      fs::path folder = known.string() + "-scene";
      remove_tree(folder);
      if (Errors errors = write_scene(root_, one, folder); !errors.empty()) return errors;
      Result<std::string> id = scene_id(root_, folder / "frames", scenes_of(folder, one.frame));
      remove_tree(folder);
      if (!id) return id;
      all += *id + "\n";
    }
    std::string id = content_id(all);
    Result<bool> written = write_file(known, scene_ids_text({{source, id}}));
    if (!written) return written.errors();
    return id;
  }

  Result<std::string> id_now(const std::string& name) const {
    bool large = name.starts_with(kLargePrefix);
    for (const GalleryPicture& picture : list_.pictures)
      if (picture.name == name.substr(large ? kLargePrefix.size() : 0))
        return id_now(stills_of(picture, large), name);
    if (name == kGrammarSheet) {
      Result<std::vector<Still>> stills = write_grammars();
      return stills ? id_now(*stills, name) : stills.errors();
    }
    fs::path folder = work_ / "scenes" / name;
    fs::path scene = root_ / "docs" / "examples" / (name.substr(kExamplePrefix.size()) + ".pov");
    Result<ExampleScene> written = write_example(scene, folder);
    Result<std::string> id = written ? scene_id(root_, folder, {scene}) : written.errors();
    remove_tree(folder);
    return id;
  }

  const fs::path &root_, &work_;
  const GalleryList& list_;
  const std::vector<std::string>& names_;
  const GalleryListener made_;
};

}  // namespace

std::string wrong_name(const GalleryOrder& order) { return Gallery(order).wrong_name(); }

Errors render_gallery(const GalleryOrder& order, const GalleryListener& made) {
  return Gallery(order, made).render();
}

Errors find_stale(const GalleryOrder& order, const FoundStale& found) {
  return Gallery(order).find_stale(found);
}

std::vector<std::string> others_in_gallery(const GalleryOrder& order) { return Gallery(order).others(); }

}  // namespace frond
