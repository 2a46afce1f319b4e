#include "render/gallery.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "app/commands.h"
#include "app/inputs.h"
#include "app/messages.h"
#include "app/render_notes.h"
#include "app/streams.h"
#include "core/files.h"
#include "core/frame_name.h"
#include "jobs/jobs.h"
#include "render/film.h"
#include "render/jpeg.h"
#include "render/process.h"

// The pictures of docs/gallery, made from the presets as they are: gallery.

namespace frond {

namespace fs = std::filesystem;

namespace {

/// A picture to be rendered.
struct Still {
  fs::path preset;
  int frame = 1;
  std::array<int, 2> size{};
  std::string quality = "good";
  std::vector<std::string> sets;
};

class Gallery {
 public:
  /// The folder of Frond, that of what pictures are made of, the list, and the names asked for.
  Gallery(fs::path root, fs::path work, GalleryList list, std::vector<std::string> names)
      : root_(std::move(root)), work_(std::move(work)), list_(std::move(list)), names_(std::move(names)) {}

  /// What of the names is none; empty where all are.
  std::string wrong_name() const;

  Errors pictures(bool large);
  Errors examples();
  Errors grammars();
  Errors page() const;

 private:
  bool wanted(const std::string& name) const {
    return names_.empty() || std::ranges::find(names_, name) != names_.end();
  }
  std::vector<fs::path> scenes() const;
  Errors call(std::vector<std::string> words, const fs::path& folder = {}) const;
  Result<fs::path> still(const Still& still, const fs::path& folder) const;
  Errors picture(const GalleryPicture& picture, bool large);
  Errors note_row(const GalleryPicture& picture) const;
  Errors example(const fs::path& scene, const std::string& name) const;
  Result<fs::path> grammar(const fs::path& file, const std::string& layout) const;
  Errors show(JpegJob job, const fs::path& scratch, const std::string& name) const;

  fs::path root_, work_;
  GalleryList list_;
  std::vector<std::string> names_;
};

std::string Gallery::wrong_name() const {
  for (const std::string& name : names_) {
    bool there = name == "grammars" ||
                 std::ranges::any_of(list_.pictures,
                                     [&](const GalleryPicture& picture) { return picture.name == name; });
    for (const fs::path& scene : scenes()) there |= name == "example-" + scene.stem().string();
    if (!there) return fmt::format("{}: no picture of docs/gallery/pictures.txt", name);
  }
  return {};
}

std::vector<fs::path> Gallery::scenes() const {
  std::vector<fs::path> scenes = files_in(root_ / "docs" / "examples");
  std::erase_if(scenes, [](const fs::path& file) { return file.extension() != ".pov"; });
  return scenes;
}

/// Runs a program, whose words are for people.
Errors Gallery::call(std::vector<std::string> words, const fs::path& folder) const {
  Command command;
  std::string what = words[0];
  command.words = std::move(words);
  command.environment = {"FROND_HOME=" + root_.string()};
  command.folder = folder;
  command.out = 2;
  command.end_with = SIGTERM;
  Result<int> code = run(command);
  if (!code) return code.errors();
  return *code == 0 ? Errors{} : Errors{{"", fmt::format("{} ended with exit code {}", what, *code)}};
}

/// Renders a picture in a folder, unless it is there and nothing has changed; its path.
Result<fs::path> Gallery::still(const Still& still, const fs::path& folder) const {
  std::vector<std::string> words{own_program().string(),
                                 "generate",
                                 still.preset.string(),
                                 "--out=" + folder.string(),
                                 fmt::format("--frames={0}-{0}", still.frame),
                                 fmt::format("--size={}x{}", still.size[0], still.size[1]),
                                 "--quality=" + still.quality,
                                 "--no-resolve",  // of a film eight frames more would be rendered
                                 "-q"};
  for (const std::string& set : still.sets) words.push_back("--set=" + set);
  if (Errors errors = call(words); !errors.empty()) return errors;
  std::string picture = "frames/" + frame_name(still.frame) + ".png";
  if (Errors errors = call({"ninja", picture}, folder); !errors.empty()) return errors;
  return folder / picture;
}

/// Makes docs/gallery/NAME.jpg, and says so.
Errors Gallery::show(JpegJob job, const fs::path& scratch, const std::string& name) const {
  job.ffmpeg = environment_or("FROND_FFMPEG", "ffmpeg");
  fs::path place = fs::path("docs") / "gallery" / (name + ".jpg");
  if (Errors errors = write_jpeg(job, scratch, root_ / place); !errors.empty()) return errors;
  put(place.string() + "\n");
  flush();
  return {};
}

Errors Gallery::picture(const GalleryPicture& picture, bool large) {
  JpegJob job{{}, large ? large_size(picture.size) : picture.size, picture.columns, ""};
  std::string made = picture.name + (large ? "-large" : "");
  for (const GalleryPart& part : picture.parts) {
    Still one{root_ / "presets" / (part.preset + ".json"), part.frame, job.size, "good", part.sets};
    Result<fs::path> file = still(one, work_ / fmt::format("{}-{}", made, job.pictures.size()));
    if (!file) return file.errors();
    job.pictures.push_back(*file);
  }
  if (Errors errors = show(job, work_ / (made + ".jpg"), (large ? "large/" : "") + picture.name);
      !errors.empty())
    return errors;
  return large ? Errors{} : note_row(picture);
}

/// Notes what the page will say of a picture.
Errors Gallery::note_row(const GalleryPicture& picture) const {
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

Errors Gallery::pictures(bool large) {
  for (const GalleryPicture& each : list_.pictures) {
    if (!wanted(each.name)) continue;
    if (Errors errors = picture(each, large); !errors.empty()) {
      errors.push_back({"", each.name + " could not be rendered"});
      return errors;
    }
  }
  return {};
}

/// A scene of docs/examples; its first lines hold the commands that make what it includes.
Errors Gallery::example(const fs::path& scene, const std::string& name) const {
  Result<std::string> text = read_file(scene);
  if (!text) return text.errors();
  ExampleScene example = read_example(*text);
  fs::path folder = work_ / name;
  std::error_code error;
  fs::create_directories(folder, error);
  for (std::vector<std::string> words : example.calls) {
    fs::path include;
    for (std::string& word : words) {
      if (word.starts_with("presets/")) word = (root_ / word).string();
      if (word.ends_with(".inc")) word = (include = folder / word).string();
    }
    if (fs::exists(include, error)) continue;
    words.insert(words.begin(), own_program().string());
    words.emplace_back("-q");
    if (Errors errors = call(words); !errors.empty()) return errors;
  }
  std::string picture = name + ".png";
  Words said;  // POV-Ray's own, which are many
  Command render;
  render.words = {environment_or("FROND_POVRAY", "povray"),
                  "+I" + scene.string(),
                  "+O" + picture,
                  fmt::format("+W{}", example.size[0]),
                  fmt::format("+H{}", example.size[1]),
                  "+A",
                  "-D"};
  render.folder = folder;
  render.out = render.err = said.descriptor();
  render.end_with = SIGTERM;
  Result<int> code = run(render);
  if (!code || *code != 0) return {{"", name + " could not be rendered"}};
  return show({{folder / picture}, {}, 1, ""}, folder / (name + ".jpg"), name);
}

Errors Gallery::examples() {
  for (const fs::path& scene : scenes()) {
    std::string name = "example-" + scene.stem().string();
    if (!wanted(name)) continue;
    if (Errors errors = example(scene, name); !errors.empty()) return errors;
  }
  return {};
}

/// The picture of a grammar with its name below it. At this size a draft shows all.
Result<fs::path> Gallery::grammar(const fs::path& file, const std::string& layout) const {
  std::string name = file.stem();
  fs::path place = work_ / "grammars" / name;
  Result<std::string> text = read_file(file);
  if (!text) return text.errors();
  Result<bool> written = write_file(place.string() + ".json", grammar_preset(layout, *text));
  if (!written) return written.errors();
  constexpr int kSide = 200;
  Result<fs::path> picture = still({place.string() + ".json", 1, {kSide, kSide}, "draft", {}}, place);
  if (!picture) return picture;
  // Names are of letters, digits, dashes and underscores, which need no quotes in a filter.
  Errors errors = call({environment_or("FROND_FFMPEG", "ffmpeg"), "-y", "-nostdin", "-loglevel", "error",
                        "-i", "file:" + picture->string(), "-vf",
                        fmt::format("format=rgb24,pad=iw:ih+28:0:0:0x202020,drawtext=text={}:fontcolor=white:"
                                    "fontsize='clip(w/14,8,16)':x='max(0,(w-tw)/2)':y=h-20",
                                    name),
                        "file:" + place.string() + ".png"});
  if (!errors.empty()) return errors;
  return fs::path(place.string() + ".png");
}

/// The grammars of presets/grammars, each before the studio's wall.
Errors Gallery::grammars() {
  constexpr int kColumns = 8, kWidth = 200;
  if (!wanted("grammars")) return {};
  Result<std::string> layout = read_file(root_ / "docs" / "gallery" / "grammar.txt");
  if (!layout) return layout.errors();
  SheetJob sheet{{}, work_ / "grammars.png", kColumns, kWidth, environment_or("FROND_FFMPEG", "ffmpeg")};
  for (const fs::path& file : files_in(root_ / "presets" / "grammars")) {
    bool draws = file.stem() != "algae" && file.stem() != "cells";  // words without lines
    if (file.extension() != ".json" || !draws) continue;
    Result<fs::path> picture = grammar(file, *layout);
    if (!picture) return picture.errors();
    sheet.pictures.push_back(*picture);
  }
  if (Errors errors = tile_sheet(sheet); !errors.empty()) return errors;
  return show({{sheet.sheet}, {}, 1, ""}, work_ / "grammars.jpg", "grammars");
}

/// Writes docs/gallery.md. What was not rendered now keeps its row.
Errors Gallery::page() const {
  fs::path file = root_ / "docs" / "gallery.md";
  Result<std::string> before = read_file(file);
  std::vector<std::string> rows;
  std::error_code error;
  for (const GalleryPicture& picture : list_.pictures) {
    Result<std::string> noted = read_file(work_ / "rows" / picture.name);
    std::string row = noted ? noted->substr(0, noted->find('\n'))
                            : row_on_page(before ? *before : std::string_view(), picture.name);
    if (row.empty()) continue;
    bool large = fs::exists(root_ / "docs" / "gallery" / "large" / (picture.name + ".jpg"), error);
    rows.push_back(large ? row_with_large(row, picture.name) : row);
  }
  Result<bool> written = write_file(file, gallery_page(rows));
  return written ? Errors{} : written.errors();
}

}  // namespace

int gallery(const GalleryArguments& arguments) {
  Result<fs::path> root = home();
  if (!root) return fail_run(root.errors(), kCouldNot);
  std::error_code error;
  fs::path from_root = fs::absolute(*root, error).lexically_normal();
  Result<std::string> text = read_file(from_root / "docs" / "gallery" / "pictures.txt");
  Result<GalleryList> list = text ? read_gallery(*text, "docs/gallery/pictures.txt") : text.errors();
  if (!list) return fail_run(list.errors(), kCouldNot);
  std::vector<std::string> names = arguments.names, large = list->large;
  for (const std::string& name : names)
    if (arguments.large && std::ranges::find(large, name) == large.end())
      return fail_run(
          {{"", fmt::format("{}: no picture of --large; expected some of {}", name, fmt::join(large, " "))}},
          kWrongInput);
  if (arguments.large && names.empty()) names = large;
  fs::path work = fs::absolute(arguments.out, error).lexically_normal();
  Gallery gallery(from_root, work, std::move(*list), std::move(names));
  if (std::string wrong = gallery.wrong_name(); !wrong.empty()) return fail_run({{"", wrong}}, kWrongInput);
  fs::create_directories(work, error);
  if (error) return fail_run({{"", work.string() + ": the folder cannot be made"}}, kCouldNot);
  Errors errors = gallery.pictures(arguments.large);
  if (errors.empty() && !arguments.large) errors = gallery.examples();
  if (errors.empty() && !arguments.large) errors = gallery.grammars();
  if (errors.empty() && !arguments.large) errors = gallery.page();
  return errors.empty() ? int{kDone} : fail_run(errors, kCouldNot);
}

}  // namespace frond
