#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <charconv>
#include <optional>

#include "cli/bar.h"
#include "cli/commands.h"
#include "cli/inputs.h"
#include "cli/messages.h"
#include "cli/rendering.h"
#include "cli/streams.h"
#include "core/text.h"
#include "pipeline/out_folder.h"
#include "render/process.h"
#include "sheets/sheet.h"

// Stills of one preset over seeds or over a value of it: sheet.

namespace frond {

namespace fs = std::filesystem;

namespace {

std::vector<Sweep> read_sweeps(const RenderArguments& a) {
  constexpr int kMost = 99;
  auto wrong = [](const std::string& what) { fail_run({{"", what}}, kWrongInput); };
  std::vector<Sweep> sweeps;
  for (const std::string& text : a.sweeps) {
    std::optional<Sweep> sweep = read_sweep(text);
    if (!sweep)
      wrong("--sweep needs POINTER=FROM:TO:COUNT, as in /organisms/0/pitch=10:60:6, not '" + text + "'");
    sweeps.push_back(std::move(*sweep));
  }
  if (a.seeds) {
    int seeds = counting_number(*a.seeds);
    if (seeds < 1 || seeds > kMost)
      wrong(fmt::format("--contact-seeds needs a number from 1 to 99, not '{}'", *a.seeds));
    sweeps.insert(sweeps.begin(), sweep_of("/seed", 1, seeds, seeds));
  }
  if (sweeps.empty()) wrong("over what? --sweep or --contact-seeds");
  if (sweeps.size() > 2) wrong("a sheet has two directions, not three");
  return sweeps;
}

/// Which frame the sheet shows: that of --frames, or the last.
int frame_shown(const RenderArguments& a) {
  if (!a.frames) return or_fail_run(load_preset(a.preset), kWrongInput).film.frames;
  int frame = 0;
  std::from_chars(a.frames->data(), a.frames->data() + a.frames->size(), frame);
  if (frame < 1 || (*a.frames != fmt::format("{}", frame) && *a.frames != fmt::format("{0}-{0}", frame)))
    fail_run({error_at("", "--frames needs one frame, as in 40-40, not '{}'", *a.frames)}, kWrongInput);
  return frame;
}

/// What is wrong with one of the pictures: told before the first is made.
Errors judge_cells(const RenderArguments& a, const std::vector<SheetCell>& cells, int frame) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    PresetArguments preset = a.preset;
    preset.sets.insert(preset.sets.end(), cells[i].sets.begin(), cells[i].sets.end());
    Result<Preset> read = load_preset(preset);
    Errors errors = read ? refuse_resolving(read->film, a.resolve) : read.errors();
    if (errors.empty() && frame > read->film.frames)
      errors = {error_at("--frames", "{} is no frame of this film; expected one of 1-{}", frame,
                         read->film.frames)};
    if (errors.empty()) continue;
    errors.push_back(error_at("", "picture {} of {} ({}) could not be made; none has been begun", i + 1,
                              cells.size(), cells[i].text));
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

}  // namespace

void sheet(const RenderArguments& a) {
  refuse_missing(a.preset);
  std::error_code error;
  std::vector<Sweep> sweeps = read_sweeps(a);
  int frame = frame_shown(a);
  fs::path out = fs::absolute(out_folder(a.out, a.preset, "-sheet"), error).lexically_normal();
  fs::path pictures = out / "pictures";
  std::vector<SheetCell> cells = cells_of(sweeps, pictures);
  or_fail_run(judge_cells(a, cells, frame), kWrongInput);
  or_fail_run(refuse_folder(out), kCouldNot);
  or_fail_run(refuse_link(pictures), kCouldNot);
  fs::create_directories(pictures, error);
  if (error) fail_run({{"", out.string() + ": the folder cannot be made"}}, kCouldNot);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    say(fmt::format("Picture {} of {}: {}", i + 1, cells.size(), cells[i].text));
    Result<int> code = render_cell(a, cells[i], frame);
    if (!code || *code != 0)
      fail_run({error_at("", "picture {} of {} ({}) could not be made; those before it are kept", i + 1,
                         cells.size(), cells[i].text)},
               code ? static_cast<ExitCode>(*code) : kCouldNot);
  }
  or_fail_run(make_sheet(cells, frame, columns_of(sweeps), out / "sheet.png"), kCouldNot);
  put((out / "sheet.png").string() + "\n");
}

}  // namespace frond
