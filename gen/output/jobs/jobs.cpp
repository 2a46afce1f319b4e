#include "jobs/jobs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "core/frame_name.h"
#include "core/text.h"
#include "jobs/escape.h"

namespace frond {

namespace {

/// Pictures of a contact sheet: 6 columns and 4 rows at most.
constexpr std::size_t kSheetPictures = 24;

std::string scene_file(int frame) { return "frames/" + frame_name(frame) + ".pov"; }
std::string raw_file(int frame) { return "raw/" + frame_name(frame) + ".png"; }
std::string picture_file(int frame) { return "frames/" + frame_name(frame) + ".png"; }

/// At most kSheetPictures of the frames, evenly spaced, the first and the last among them.
std::vector<int> sheet_frames(const std::vector<int>& frames) {
  if (frames.size() <= kSheetPictures) return frames;
  std::vector<int> chosen;
  for (std::size_t i = 0; i < kSheetPictures; ++i)
    chosen.push_back(frames[(i * (frames.size() - 1) + (kSheetPictures - 1) / 2) / (kSheetPictures - 1)]);
  return chosen;
}

/// Columns that make a sheet of wide pictures about as wide as it is high.
std::size_t sheet_columns(std::size_t pictures) {
  std::size_t columns = 1;
  while (2 * columns * columns < 3 * pictures) ++columns;
  return std::min(columns, pictures);
}

void append_variable(std::string& text, std::string_view name, std::string_view value) {
  text += fmt::format("{} = {}\n", name, ninja_value(value));
}

void append_rule(std::string& text, std::string_view name, std::string_view command,
                 std::string_view description) {
  text += fmt::format("\nrule {}\n  command = {}\n  description = {}\n", name, command, description);
}

/// The command's input list goes through a file: a film may have more frames than a command line has room
/// for.
void append_list_rule(std::string& text, std::string_view name, std::string_view command,
                      std::string_view description) {
  append_rule(text, name, command, description);
  text += "  rspfile = $out.list\n  rspfile_content = $in_newline\n";
}

void append_build(std::string& text, std::string_view output, std::string_view rule,
                  const std::vector<int>& frames) {
  text += fmt::format("\nbuild {}: {}", output, rule);
  for (int frame : frames) text += " $\n    " + picture_file(frame);
  text += '\n';
}

void append_frames(std::string& text, const JobList& jobs) {
  // Folders stand in variables: a variable may hold any character, a path written out may not hold a `|`.
  std::string includes;
  for (const std::string& include : jobs.includes) includes += " $povinc/" + ninja_path(include);
  if (!includes.empty()) text += "\nbuild includes: phony" + includes + "\n";
  text += '\n';
  for (int frame : jobs.raws.empty() ? jobs.frames : jobs.raws) {
    text += "build " + (jobs.raws.empty() ? picture_file(frame) : raw_file(frame)) + ": frame " +
            scene_file(frame);
    if (!includes.empty() || jobs.exposures > 1) text += " |";
    for (int i = 2; i <= jobs.exposures; ++i) text += " frames/" + exposure_name(frame, i) + ".pov";
    if (!includes.empty()) text += " includes";
    text += "\n  number = " + std::to_string(frame) + "\n";
  }
}

/// Blocks of frames of their raw ones. Each grows the scene anew, so they are not small; one at a time is at
/// work, as it uses all processors that are free.
void append_resolve(std::string& text, const JobList& jobs) {
  constexpr std::size_t kBlock = 96;
  std::string words;
  for (const std::string& word : jobs.resolve) words += (words.empty() ? "" : " ") + shell_quoted(word);
  append_variable(text += '\n', "preset", words);
  text += "\npool resolve\n  depth = 1\n";
  append_rule(text, "resolve", "exec $frond resolve $preset --frames $numbers", "resolving frames $numbers");
  text += "  pool = resolve\n";
  for (std::size_t begin = 0; begin < jobs.frames.size(); begin += kBlock) {
    std::size_t end = std::min(begin + kBlock, jobs.frames.size());
    int first = jobs.frames[begin], last = jobs.frames[end - 1];
    text += "\nbuild";
    for (std::size_t i = begin; i < end; ++i) text += " $\n    " + picture_file(jobs.frames[i]);
    text += ": resolve";
    for (int frame : jobs.raws)
      if (frame >= first - jobs.window && frame <= last + jobs.window) text += " $\n    " + raw_file(frame);
    text += "\n  numbers = " + std::to_string(first) + "-" + std::to_string(last) + "\n";
  }
}

}  // namespace

std::string_view povray_flags(std::string_view quality, bool lens) {
  for (const Rendering& rendering : kRenderings)
    if (rendering.quality == quality) return lens ? rendering.through_lens : rendering.flags;
  return {};
}

std::string film_file(std::string_view format) { return "film." + std::string(format); }

std::vector<std::string> result_files() {
  std::vector<std::string> files;
  for (std::string_view format : kFilmFormats) files.push_back(film_file(format));
  files.insert(files.end(), {"contact.png", "still.png"});
  return files;
}

std::string ninja_text(const JobList& jobs) {
  assert(!jobs.frames.empty() && !povray_flags(jobs.quality, jobs.lens).empty());
  std::string text =
      "# What is to be rendered, written by `frond generate`. Run `ninja` in this folder; what is up to date "
      "is not\n# made again.\nninja_required_version = 1.7\n\n";
  append_variable(text, "povinc", jobs.povinc);
  append_variable(text, "frond", shell_quoted(jobs.program));
  append_variable(text, "size", fmt::format("{}x{}", jobs.size[0], jobs.size[1]));
  append_variable(text, "flags", jobs.raws.empty() ? povray_flags(jobs.quality, jobs.lens) : kRawFlags);

  if (!jobs.rendered) {
    append_rule(text, "frame", "exec $frond frame $in $out $size -- $flags", "frame $number");
    append_frames(text, jobs);
  }
  if (!jobs.raws.empty()) append_resolve(text, jobs);

  if (jobs.still) {
    std::string dpi = jobs.dpi > 0 ? " --dpi " + number_text(jobs.dpi) : "";
    append_list_rule(text += '\n', "still", "exec $frond film $out.list $out" + dpi, "still.png");
    append_build(text, "still.png", "still", {jobs.frames.front()});
    return text;
  }
  text += '\n';
  append_variable(text, "fps", number_text(jobs.fps, 6));
  append_variable(text, "title", shell_quoted("--title=" + jobs.title));
  append_variable(text, "comment", shell_quoted("--comment=seed " + std::to_string(jobs.seed)));
  append_list_rule(text, "film",
                   std::string("exec $frond film $out.list $out --fps $fps $title $comment") +
                       (jobs.transparent ? " --alpha" : ""),
                   "$out");
  std::string first = film_file(film_format(jobs.transparent));
  for (const std::string& film : {first, film_file("webm"), film_file("gif"), film_file("webp")})
    append_build(text, film, "film", jobs.frames);

  std::vector<int> sheet = sheet_frames(jobs.frames);
  append_variable(text += '\n', "columns", std::to_string(sheet_columns(sheet.size())));
  append_list_rule(text, "contact", "exec $frond film $out.list $out --columns $columns", "contact.png");
  append_build(text, "contact.png", "contact", sheet);
  text += "\ndefault " + first + " contact.png\n";
  return text;
}

std::string ninja_variable(std::string_view ninja, std::string_view name) {
  std::string begin = "\n" + std::string(name) + " = ";
  std::size_t at = ninja.find(begin);
  if (at == ninja.npos) return {};
  ninja.remove_prefix(at + begin.size());
  std::string value(ninja.substr(0, ninja.find('\n')));
  for (std::size_t i = 0; (i = value.find('$', i)) != value.npos; ++i) value.erase(i, 1);  // $$ and $blank
  return value;
}

std::string manifest_text(const Manifest& manifest) {
  std::string text = "{\n";
  auto line = [&](std::string_view key, std::string_view value) {
    text += fmt::format("  \"{}\": {},\n", key, value);
  };
  line("tool", "\"frond\"");
  line("version", json_quoted(manifest.version));
  line("preset", json_quoted(manifest.preset));
  line("title", json_quoted(manifest.title));
  line("preset_hash", json_quoted(manifest.preset_hash));
  line("seed", std::to_string(manifest.seed));
  line("fps", number_text(manifest.fps, 6));
  line("size", fmt::format("[{}, {}]", manifest.size[0], manifest.size[1]));
  line("quality", json_quoted(manifest.quality));
  line("still", manifest.still ? "true" : "false");
  if (manifest.transparent) line("transparent", "true");
  line("render_seconds", number_text(manifest.render_seconds, 2));
  if (manifest.raw[0] > 0) line("raw", fmt::format("[{}, {}]", manifest.raw[0], manifest.raw[1]));
  std::string budgets;
  for (const Manifest::Budget& budget : manifest.budgets)
    budgets +=
        fmt::format("{}{{\"pointer\": {}, \"seconds\": {}, \"internodes\": {}}}", budgets.empty() ? "" : ", ",
                    json_quoted(budget.pointer), number_text(budget.seconds, 6), budget.internodes);
  if (!budgets.empty()) line("budgets", "[" + budgets + "]");
  text += "  \"frames\": [";
  std::string_view between = "\n    ";
  for (const Manifest::Frame& frame : manifest.frames) {
    text +=
        fmt::format("{}{{\"number\": {}, \"time\": {}, \"nodes\": {}, \"file\": {}}}", between, frame.number,
                    number_text(frame.time, 6), frame.nodes, json_quoted(scene_file(frame.number)));
    between = ",\n    ";
  }
  text += manifest.frames.empty() ? "]\n}\n" : "\n  ]\n}\n";
  return text;
}

}  // namespace frond
