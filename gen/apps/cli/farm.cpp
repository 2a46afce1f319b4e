#include <fmt/format.h>

#include <algorithm>

#include "cli/commands.h"
#include "cli/inputs.h"
#include "cli/messages.h"
#include "cli/rendering.h"
#include "cli/streams.h"
#include "cli/terminal_events.h"
#include "core/files.h"
#include "core/printable.h"
#include "core/text.h"
#include "farm/farm_hand.h"
#include "farm/hand_over.h"
#include "render/process.h"
#include "render/slurm.h"

// A film on many machines: farm. output/farm hands it over, and farm_task.cpp is what each task does.

namespace frond {

namespace fs = std::filesystem;

namespace {

/// A number from 1 to 99999; 0 where the text is none.
int count_of(const std::string& text) {
  constexpr int kMost = 99'999;
  int number = text.starts_with('0') ? 0 : counting_number(text);
  return number <= kMost ? number : 0;
}

bool are_hosts(const std::string& text) {
  auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  auto begins = [&](char c) { return is_letter(c) || (c >= '0' && c <= '9'); };
  auto goes_on = [&](char c) { return begins(c) || std::string_view("@._:-").find(c) != std::string::npos; };
  std::vector<std::string> names = split(text, ',');
  return !text.empty() && text.back() != ',' && std::ranges::all_of(names, [&](const std::string& name) {
    return !name.empty() && begins(name[0]) && std::ranges::all_of(name, goes_on);
  });
}

/// What is wrong with the words of a call; empty where nothing is.
std::string wrong_farm_words(const FarmArguments& a) {
  for (const auto& [name, given] :
       {std::pair("--frames", &a.order.frames), std::pair("--site", &a.site),
        std::pair("--partition", &a.order.partition), std::pair("--hosts", &a.order.hosts),
        std::pair("--openjd", &a.order.openjd), std::pair("--opencue", &a.order.opencue)})
    if (*given && (*given)->empty()) return fmt::format("{} needs a value", name);
  for (const auto& [name, given] : {std::pair("--chunk", &a.chunk), std::pair("--bands", &a.bands)})
    if (count_of(*given) == 0) return fmt::format("{} needs a number from 1 on, not '{}'", name, *given);
  if (a.order.hosts && !are_hosts(*a.order.hosts))
    return fmt::format("--hosts needs names of machines with commas between them, not '{}'", *a.order.hosts);
  return {};
}

/// The first lines of what was said of a picture that failed, on one.
std::string first_words_of(const fs::path& note) {
  constexpr std::size_t kLines = 3;
  Result<std::string> text = read_file(note);
  std::string words;
  if (!text) return words;
  std::vector<std::string> lines = lines_of(*text);
  for (std::size_t i = 0; i < std::min(lines.size(), kLines); ++i) words += (i ? " " : "") + lines[i];
  return words;
}

/// The word for a state of Slurm whose tasks are still to come or at work; empty for other states.
std::string_view word_of(std::string_view state) {
  return state == "RUNNING"      ? "running"
         : state == "PENDING"    ? "pending"
         : state == "COMPLETING" ? "completing"
                                 : "";
}

void show_status(const fs::path& farm) {
  fs::path job = farm / "latest";
  std::string text = farm_status(job);
  if (Result<std::string> jobs = read_file(job / "jobs"); jobs && find_program("squeue"))
    for (const auto& [state, count] : slurm_tasks(jobs_in(*jobs), "all"))
      if (std::string_view word = word_of(state); !word.empty())
        text += fmt::format("{} tasks are {}\n", count, word);
  put(text);
  for (const fs::path& note : files_in(job / "failed"))
    if (is_file(note))
      put(printable(fmt::format("{} failed: {}", note.filename().string(), first_words_of(note))) + "\n");
  for (const fs::path& result : results_of(farm))
    if (result.stem() == "film" || result.stem() == "still") put(result.filename().string() + " is there\n");
}

void show_logs(const fs::path& farm) {
  constexpr std::size_t kLines = 20;
  std::string text;
  for (const fs::path& log : files_below(farm / "latest" / "log")) {
    Result<std::string> said = is_file(log) ? read_file(log) : std::string();
    if (!said || said->empty()) continue;
    std::vector<std::string> lines = lines_of(*said);
    text += fmt::format("{}==> {} <==\n", text.empty() ? "" : "\n", log.string());
    for (std::size_t i = lines.size() - std::min(lines.size(), kLines); i < lines.size(); ++i)
      text += lines[i] + '\n';
  }
  put(text);
}

void look_at(const FarmArguments& a, const fs::path& farm) {
  if (!is_folder(farm / "latest"))
    fail_run({{"", farm.string() + ": no film was handed to a farm there"}}, kWrongInput);
  if (a.cancel && !a.status) return or_fail_run(cancel_farm(farm), kCouldNot);
  a.status ? show_status(farm) : show_logs(farm);
}

}  // namespace

void farm(const FarmArguments& a) {
  if (std::string wrong = wrong_farm_words(a); !wrong.empty()) fail_run({{"", wrong}}, kWrongInput);
  refuse_missing(a.preset);
  fs::path out = out_folder(a.out, a.preset);
  if (a.status || a.cancel || a.logs) return look_at(a, farm_folder(out));
  FarmOrder order = a.order;
  order.file = a.preset.path;
  order.assets = a.preset.assets;
  order.out = out;
  order.program = environment_or("FROND_BIN", own_program().string());
  order.chunk = count_of(a.chunk);
  order.bands = count_of(a.bands);
  if (a.site) {
    Result<std::string> text = read_file(*a.site);
    order.site = or_fail(text ? read_farm_site(*text, *a.site) : text.errors(), kWrongInput);
  }
  Preset preset = or_fail(load_preset(a.preset), kWrongInput);
  PresetArguments rest = a.preset;
  rest.assets.reset();
  add_words(order.words, rest);
  order.words.erase(order.words.begin());  // the preset
  StopSignals stop;
  TerminalEvents events;
  RenderedFilm handed = hand_over(order, preset, stop, events);
  if (handed.outcome.stopped) throw CommandEnd{kInterrupted};
  if (!handed.outcome.well())
    fail_run(handed.outcome.errors, handed.outcome.of_the_preset ? kWrongInput : kCouldNot);
  for (const fs::path& result : handed.results) put(result.string() + "\n");
}

}  // namespace frond
