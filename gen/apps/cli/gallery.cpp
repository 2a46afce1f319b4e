#include "cli/gallery.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cli/commands.h"
#include "cli/inputs.h"
#include "cli/messages.h"
#include "cli/streams.h"
#include "core/content.h"
#include "core/files.h"
#include "core/frame_name.h"
#include "jobs/jobs.h"
#include "pipeline/frame_times.h"
#include "render/film.h"
#include "render/jpeg.h"
#include "render/process.h"

// The pictures of docs/gallery, made from the presets as they are: gallery.

namespace frond {

namespace fs = std::filesystem;

std::vector<std::string> Gallery::all_names() const {
  std::vector<std::string> names;
  for (const GalleryPicture& picture : list_.pictures) names.push_back(picture.name);
  for (const fs::path& scene : scenes()) names.push_back(std::string(kExamplePrefix) + scene.stem().string());
  names.emplace_back(kGrammarSheet);
  for (const std::string& name : list_.large) names.push_back(std::string(kLargePrefix) + name);
  return names;
}

std::string Gallery::wrong_name() const {
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

/// Writes a scene in a folder.
Errors Gallery::write_scene(const Still& still, const fs::path& folder) const {
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
  return call(words);
}

/// Renders a picture in a folder, unless it is there and nothing has changed.
Result<Rendered> Gallery::still(const Still& still, const fs::path& folder) const {
  if (Errors errors = write_scene(still, folder); !errors.empty()) return errors;
  // Before it is rendered: what is a frame's own may go then.
  Result<std::string> id = scene_id(root_, folder / "frames", scenes_of(folder, still.frame));
  if (!id) return id.errors();
  std::string picture = "frames/" + frame_name(still.frame) + ".png";
  if (Errors errors = call({"ninja", picture}, folder); !errors.empty()) return errors;
  return Rendered{folder / picture, std::move(*id)};
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

std::vector<Still> Gallery::stills_of(const GalleryPicture& picture, bool large) const {
  std::vector<Still> stills;
  for (const GalleryPart& part : picture.parts)
    stills.push_back({root_ / "presets" / (part.preset + ".json"), part.frame,
                      large ? large_size(picture.size) : picture.size, "good", part.sets});
  return stills;
}

Errors Gallery::picture(const GalleryPicture& picture, bool large) {
  JpegJob job{{}, large ? large_size(picture.size) : picture.size, picture.columns, ""};
  std::string made = picture.name + (large ? "-large" : ""),
              name = std::string(large ? kLargePrefix : "") + picture.name;
  std::vector<Still> stills = stills_of(picture, large);
  std::string ids;
  for (const Still& one : stills) {
    Result<Rendered> part = still(one, work_ / fmt::format("{}-{}", made, job.pictures.size()));
    if (!part) return part.errors();
    job.pictures.push_back(part->picture);
    ids += part->scene_id + '\n';
  }
  if (Errors errors = show(job, work_ / (made + ".jpg"), name); !errors.empty()) return errors;
  if (Errors errors = note_scene_id(root_, name, content_id(ids)); !errors.empty()) return errors;
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

Errors Gallery::pictures() {
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
Result<ExampleScene> Gallery::write_example(const fs::path& scene, const fs::path& folder) const {
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
    if (Errors errors = call(words); !errors.empty()) return errors;
  }
  return example;
}

Errors Gallery::example(const fs::path& scene, const std::string& name) const {
  fs::path folder = work_ / name;
  Result<ExampleScene> written = write_example(scene, folder);
  if (!written) return written.errors();
  const ExampleScene& example = *written;
  std::string picture = name + ".png";
  OutputCapture said;  // POV-Ray's own, which are many
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
  Result<std::string> id = scene_id(root_, folder, {scene});
  if (!id) return id.errors();
  Errors errors = show({{folder / picture}, {}, 1, ""}, folder / (name + ".jpg"), name);
  return errors.empty() ? note_scene_id(root_, name, *id) : errors;
}

Errors Gallery::examples() {
  for (const fs::path& scene : scenes()) {
    std::string name = std::string(kExamplePrefix) + scene.stem().string();
    if (!wanted(name)) continue;
    if (Errors errors = example(scene, name); !errors.empty()) return errors;
  }
  return {};
}

/// A preset for each grammar of presets/grammars, before the studio's wall. At this size a draft shows all.
Result<std::vector<Still>> Gallery::write_grammars() const {
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
Result<Rendered> Gallery::grammar(const Still& one) const {
  std::string name = one.preset.stem();
  fs::path place = work_ / kGrammarSheet / name;
  Result<Rendered> picture = still(one, place);
  if (!picture) return picture;
  // Names are of letters, digits, dashes and underscores, which need no quotes in a filter.
  Errors errors = call({environment_or("FROND_FFMPEG", "ffmpeg"), "-y", "-nostdin", "-loglevel", "error",
                        "-i", "file:" + picture->picture.string(), "-vf",
                        fmt::format("format=rgb24,pad=iw:ih+28:0:0:0x202020,drawtext=text={}:fontcolor=white:"
                                    "fontsize='clip(w/14,8,16)':x='max(0,(w-tw)/2)':y=h-20",
                                    name),
                        "file:" + place.string() + ".png"});
  if (!errors.empty()) return errors;
  return Rendered{place.string() + ".png", std::move(picture->scene_id)};
}

Errors Gallery::grammars() {
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

Errors Gallery::render() {
  Errors errors = pictures();
  if (errors.empty()) errors = examples();
  if (errors.empty()) errors = grammars();
  bool only_large = !names_.empty() && std::ranges::all_of(names_, [](const std::string& name) {
    return name.starts_with(kLargePrefix);
  });
  return errors.empty() && !only_large ? page() : errors;
}

int gallery(const GalleryArguments& arguments) {
  Result<fs::path> root = home();
  if (!root) return fail_run(root.errors(), kCouldNot);
  std::error_code error;
  fs::path from_root = fs::absolute(*root, error).lexically_normal();
  Result<std::string> text = read_file(from_root / "docs" / "gallery" / "pictures.txt");
  Result<GalleryList> list = text ? read_gallery(*text, "docs/gallery/pictures.txt") : text.errors();
  if (!list) return fail_run(list.errors(), kCouldNot);
  std::vector<std::string> names = arguments.names;
  if (arguments.large && names.empty()) names = list->large;
  if (arguments.large)
    for (std::string& name : names) name.insert(0, name.starts_with(kLargePrefix) ? "" : kLargePrefix);
  fs::path work = fs::absolute(arguments.out, error).lexically_normal();
  bool everything = names.empty();
  Gallery gallery(from_root, work, std::move(*list), std::move(names));
  if (std::string wrong = gallery.wrong_name(); !wrong.empty()) return fail_run({{"", wrong}}, kWrongInput);
  fs::create_directories(work, error);
  if (error) return fail_run({{"", work.string() + ": the folder cannot be made"}}, kCouldNot);
  Errors errors = arguments.stale ? gallery.tell_stale() : gallery.render();
  if (errors.empty() && arguments.stale && everything) gallery.tell_others();
  return errors.empty() ? int{kDone} : fail_run(errors, kCouldNot);
}

}  // namespace frond
