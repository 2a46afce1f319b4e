#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "cli/bar.h"
#include "cli/commands.h"
#include "cli/inputs.h"
#include "cli/judge.h"
#include "cli/messages.h"
#include "cli/rendering.h"
#include "cli/streams.h"
#include "core/content.h"
#include "core/files.h"
#include "core/frame_name.h"
#include "core/text.h"
#include "core/work_folder.h"
#include "jobs/jobs.h"
#include "pipeline/out_folder.h"
#include "render/film.h"
#include "render/label.h"
#include "render/process.h"

// Stills of one preset over seeds or over a value of it: sheet.

namespace frond {

namespace fs = std::filesystem;

namespace {

/// A value of a preset, and what it takes from picture to picture.
struct Sweep {
  std::string pointer, name;
  std::vector<std::string> values;
};

bool consume_number(std::string_view& text, double& number) {
  auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || !std::isfinite(number)) return false;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return true;
}

bool consume_colon(std::string_view& text) {
  if (!text.starts_with(':')) return false;
  text.remove_prefix(1);
  return true;
}

Sweep sweep_of(std::string pointer, double from, double to, int count) {
  Sweep sweep{std::move(pointer), "", {}};
  for (int i = 0; i < count; ++i)
    sweep.values.push_back(fmt::format("{:.6g}", from + (count > 1 ? i * (to - from) / (count - 1) : 0)));
  return sweep;
}

Result<Sweep> read_sweep(const std::string& text) {
  constexpr int kMost = 99;
  std::size_t equals = text.rfind('=');
  double from = 0, to = 0, count = 0;
  std::string_view rest = std::string_view(text).substr(equals == text.npos ? text.size() : equals + 1);
  if (text.starts_with('/') && consume_number(rest, from) && consume_colon(rest) &&
      consume_number(rest, to) && consume_colon(rest) && consume_number(rest, count) && rest.empty() &&
      count >= 1 && count <= kMost && count == std::floor(count))
    return sweep_of(text.substr(0, equals), from, to, static_cast<int>(count));
  return Error{
      "",
      fmt::format("--sweep needs POINTER=FROM:TO:COUNT, as in /organisms/0/pitch=10:60:6, not '{}'", text)};
}

/// What a picture is called by: the last step of the pointer, with the one before where that is an index.
std::string name_of(const std::string& pointer) {
  std::size_t last = pointer.rfind('/');
  std::string name = pointer.substr(last + 1);
  if (name.empty() || last == 0 || name.find_first_not_of("0123456789") != name.npos) return name;
  return pointer.substr(pointer.rfind('/', last - 1) + 1);
}

Result<std::vector<Sweep>> read_sweeps(const RenderArguments& a) {
  constexpr int kMost = 99;
  std::vector<Sweep> sweeps;
  for (const std::string& text : a.sweeps) {
    Result<Sweep> sweep = read_sweep(text);
    if (!sweep) return sweep.errors();
    sweeps.push_back(std::move(*sweep));
  }
  if (a.seeds) {
    int seeds = counting_number(*a.seeds);
    if (seeds < 1 || seeds > kMost)
      return Error{"", fmt::format("--contact-seeds needs a number from 1 to 99, not '{}'", *a.seeds)};
    sweeps.insert(sweeps.begin(), sweep_of("/seed", 1, seeds, seeds));
  }
  if (sweeps.empty()) return Error{"", "over what? --sweep or --contact-seeds"};
  if (sweeps.size() > 2) return Error{"", "a sheet has two directions, not three"};
  for (Sweep& sweep : sweeps) sweep.name = name_of(sweep.pointer);
  if (sweeps.size() > 1 && sweeps[0].name == sweeps[1].name)
    for (Sweep& sweep : sweeps) sweep.name = sweep.pointer;
  return sweeps;
}

/// Which frame the sheet shows: that of --frames, or the last.
Result<int> frame_shown(const RenderArguments& a) {
  if (!a.frames) {
    Result<Preset> preset = load_preset(a.preset);
    if (!preset) return preset.errors();
    return preset->film.frames;
  }
  int frame = 0;
  std::from_chars(a.frames->data(), a.frames->data() + a.frames->size(), frame);
  if (frame < 1 || (*a.frames != fmt::format("{}", frame) && *a.frames != fmt::format("{0}-{0}", frame)))
    return Error{"", fmt::format("--frames needs one frame, as in 40-40, not '{}'", *a.frames)};
  return frame;
}

/// A picture of a sheet.
struct SheetCell {
  std::vector<std::string> sets;
  std::string text;
  fs::path folder;
};

std::vector<SheetCell> cells_of(const std::vector<Sweep>& sweeps, const fs::path& pictures) {
  std::vector<SheetCell> cells;
  std::vector<std::string> down = sweeps.size() > 1 ? sweeps[1].values : std::vector<std::string>{""};
  for (const std::string& second : down)
    for (const std::string& first : sweeps[0].values) {
      SheetCell cell{{sweeps[0].pointer + "=" + first}, sweeps[0].name + " " + first, {}};
      if (sweeps.size() > 1) {
        cell.sets.push_back(sweeps[1].pointer + "=" + second);
        cell.text += "   " + sweeps[1].name + " " + second;
      }
      // Its folder is named by what is set, so that another sheet finds it.
      std::string all;
      for (const std::string& set : cell.sets) all += set + '\n';
      cell.folder = pictures / content_id(all).substr(0, 12);
      cells.push_back(std::move(cell));
    }
  return cells;
}

/// What is wrong with one of the pictures: told before the first is made.
Errors judge_cells(const RenderArguments& a, const std::vector<SheetCell>& cells, int frame) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    PresetArguments preset = a.preset;
    preset.sets.insert(preset.sets.end(), cells[i].sets.begin(), cells[i].sets.end());
    Result<Preset> read = load_preset(preset);
    Errors errors = read ? refuse_resolving(read->film, a.resolve) : read.errors();
    if (errors.empty() && frame > read->film.frames)
      errors = {{"--frames",
                 fmt::format("{} is no frame of this film; expected one of 1-{}", frame, read->film.frames)}};
    if (errors.empty()) continue;
    errors.push_back({"", fmt::format("picture {} of {} ({}) could not be made; none has been begun", i + 1,
                                      cells.size(), cells[i].text)});
    return errors;
  }
  return {};
}

/// Has the picture made, by a run like any other; its exit code.
Result<int> render_cell(const RenderArguments& a, const SheetCell& cell, int frame) {
  Command command;
  command.words = {own_program().string(), "render"};
  add_words(command.words, a.preset);
  command.words.push_back("--out=" + cell.folder.string());
  command.words.push_back(fmt::format("--frames={0}-{0}", frame));
  for (const std::string& set : cell.sets) command.words.push_back("--set=" + set);
  if (a.resolve) command.words.push_back(*a.resolve ? "--resolve" : "--no-resolve");
  if (a.jobs > 0) command.words.push_back(fmt::format("--jobs={}", a.jobs));
  if (a.threads > 0) command.words.push_back(fmt::format("--threads={}", a.threads));
  command.end_with = SIGTERM;
  command.out = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  Result<int> code = run(command);
  ::close(command.out);
  return code;
}

/// Labels the pictures and puts them side by side.
Errors make_sheet(const std::vector<SheetCell>& cells, int frame, int columns, const fs::path& sheet) {
  WorkFolder work;
  if (work.path().empty()) return {{"", "no folder can be made for the labels"}};
  std::string ffmpeg = environment_or("FROND_FFMPEG", "ffmpeg");
  Result<Manifest> manifest = manifest_in(cells[0].folder);
  if (!manifest) return manifest.errors();
  Labels labels(work.path());
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (Errors errors = labels.add(fmt::format("label{}", i), cells[i].text, manifest->size[0]);
        !errors.empty())
      return errors;
  constexpr int kWidest = 16384;
  SheetJob job{{}, sheet, columns, kWidest, ffmpeg};
  for (std::size_t i = 0; i < cells.size(); ++i) {
    fs::path picture = cells[i].folder / "frames" / (frame_name(frame) + ".png");
    job.pictures.push_back(work.path() / fmt::format("{}.png", i));
    Command command;
    command.folder = work.path();
    command.words = {ffmpeg,
                     "-hide_banner",
                     "-nostdin",
                     "-loglevel",
                     "error",
                     "-y",
                     "-i",
                     "file:" + picture.string(),
                     "-vf",
                     (manifest->transparent ? "format=gbrap,premultiply=inplace=1," + over_checks() + ","
                                            : std::string()) +
                         "format=rgb24," + labels.filter(fmt::format("label{}", i)),
                     "-frames:v",
                     "1",
                     "-update",
                     "1",
                     job.pictures.back().string()};
    Result<int> code = run(command);
    if (!code || *code != 0) return {{"", picture.string() + " could not be labelled"}};
  }
  return tile_sheet(job);
}

}  // namespace

int sheet(const RenderArguments& a) {
  std::error_code error;
  if (!fs::is_regular_file(a.preset.path, error))
    return fail_run({{"", a.preset.path + ": no such preset" + nearest_presets(a.preset.path)}}, kWrongInput);
  Result<std::vector<Sweep>> sweeps = read_sweeps(a);
  if (!sweeps) return fail_run(sweeps.errors(), kWrongInput);
  Result<int> frame = frame_shown(a);
  if (!frame) return fail_run(frame.errors(), kWrongInput);
  fs::path out = a.out.empty() ? fs::path("out") / (fs::path(a.preset.path).stem().string() + "-sheet")
                               : fs::path(a.out);
  out = fs::absolute(out, error).lexically_normal();
  fs::path pictures = out / "pictures";
  std::vector<SheetCell> cells = cells_of(*sweeps, pictures);
  if (Errors errors = judge_cells(a, cells, *frame); !errors.empty()) return fail_run(errors, kWrongInput);
  if (Errors errors = refuse_folder(out); !errors.empty()) return fail_run(errors, kCouldNot);
  if (Errors link = refuse_link(pictures); !link.empty()) return fail_run(link, kCouldNot);
  fs::create_directories(pictures, error);
  if (error) return fail_run({{"", out.string() + ": the folder cannot be made"}}, kCouldNot);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    say(fmt::format("Picture {} of {}: {}", i + 1, cells.size(), cells[i].text));
    Result<int> code = render_cell(a, cells[i], *frame);
    if (!code || *code != 0)
      return fail_run({{"", fmt::format("picture {} of {} ({}) could not be made; those before it are kept",
                                        i + 1, cells.size(), cells[i].text)}},
                      code ? static_cast<ExitCode>(*code) : kCouldNot);
  }
  int columns = static_cast<int>((*sweeps)[0].values.size());
  if (sweeps->size() == 1)
    for (columns = 1; columns * columns < static_cast<int>(cells.size());) ++columns;
  if (Errors errors = make_sheet(cells, *frame, columns, out / "sheet.png"); !errors.empty())
    return fail_run(errors, kCouldNot);
  put((out / "sheet.png").string() + "\n");
  return kDone;
}

}  // namespace frond
