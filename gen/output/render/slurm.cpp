#include "render/slurm.h"

#include <algorithm>
#include <charconv>

#include "core/text.h"
#include "render/process.h"

namespace frond {

namespace {

/// What a program of Slurm has said.
struct Answer {
  bool well = false;
  std::string out, err;
};

Answer ask(std::vector<std::string> words) {
  OutputCapture out, err;
  Command command;
  command.words = std::move(words);
  command.out = out.descriptor();
  command.err = err.descriptor();
  Result<int> code = run(command);
  if (!code) return {false, "", code.errors()[0].text()};
  return {*code == 0, out.text(), err.text()};
}

/// The lines that hold something, without blanks round them.
std::vector<std::string> names_in(const std::string& text) {
  std::vector<std::string> names;
  for (const std::string& line : lines_of(text)) {
    std::size_t from = line.find_first_not_of(" \t"), to = line.find_last_not_of(" \t");
    if (from != line.npos) names.push_back(line.substr(from, to + 1 - from));
  }
  return names;
}

/// A text without the ends of its last lines.
std::string without_end(std::string text) {
  while (text.ends_with('\n')) text.pop_back();
  return text;
}

}  // namespace

std::map<std::string, int> slurm_tasks(const std::string& jobs, const std::string& states) {
  std::map<std::string, int> tasks;
  Answer answer =
      ask({"squeue", "--noheader", "--array", "--jobs=" + jobs, "--states=" + states, "--format=%T"});
  for (const std::string& state : names_in(answer.out)) ++tasks[state];
  return tasks;
}

bool has_slurm_partition(const std::string& name) {
  return !names_in(ask({"sinfo", "--noheader", "--partition=" + name, "--format=%P"}).out).empty();
}

Result<std::vector<std::string>> slurm_partitions() {
  Answer answer = ask({"sinfo", "--noheader", "--format=%R"});
  if (!answer.well) return Error{"", without_end(answer.err + "Slurm does not answer")};
  std::vector<std::string> names = names_in(answer.out);
  std::ranges::sort(names);
  names.erase(std::ranges::unique(names).begin(), names.end());
  return names;
}

int most_slurm_tasks() {
  constexpr int kUsual = 1001;  // of a Slurm that does not say it
  int largest = kUsual;
  for (const std::string& line : names_in(ask({"scontrol", "show", "config"}).out)) {
    if (!line.starts_with("MaxArraySize")) continue;
    std::size_t at = std::min(line.find_first_of("0123456789"), line.size());
    std::from_chars(line.data() + at, line.data() + line.size(), largest);
  }
  return std::max(1, largest - 1);
}

Result<std::string> submit_to_slurm(const std::vector<std::string>& words) {
  std::vector<std::string> call{"sbatch"};
  call.insert(call.end(), words.begin(), words.end());
  Answer answer = ask(std::move(call));
  std::vector<std::string> lines = names_in(answer.out);
  if (!answer.well || lines.empty()) return Error{"", "sbatch: " + without_end(answer.err + answer.out)};
  return lines.back().substr(0, lines.back().find(';'));  // what follows is the cluster
}

Errors cancel_in_slurm(const std::string& jobs) {
  std::vector<std::string> call = split(without_end(jobs), ',');
  call.insert(call.begin(), "scancel");
  Answer answer = ask(std::move(call));
  if (answer.well) return {};
  return {{"", "the jobs could not be ended: " + without_end(answer.err + answer.out)}};
}

}  // namespace frond
