#include "cpfg/view.h"

#include <algorithm>
#include <cmath>

#include "core/files.h"
#include "core/plain_text.h"
#include "core/read_as.h"

namespace frond::cpfg {

namespace {

namespace fs = std::filesystem;

bool is_colour(const fs::path& file) { return file.extension() == ".map" || file.extension() == ".mat"; }

/// The command line of cpfg in the specifications that names this grammar; empty where none does.
std::vector<std::string> command_of(std::string_view specifications, const std::string& grammar) {
  while (!specifications.empty()) {
    std::size_t end = std::min(specifications.find('\n'), specifications.size());
    std::vector<std::string> words = words_in(specifications.substr(0, end));
    specifications.remove_prefix(std::min(end + 1, specifications.size()));
    bool is_cpfg = !words.empty() && fs::path(words[0]).filename().string().starts_with("cpfg");
    if (is_cpfg && std::ranges::find(words, grammar) != words.end()) return words;
  }
  return {};
}

/// The file of a kind beside the grammar: of its name, or the only one.
fs::path beside(const fs::path& grammar, std::string_view extension) {
  fs::path same = grammar, only;
  same.replace_extension(extension);
  int count = 0;
  for (const fs::path& file : files_in(grammar.parent_path().empty() ? "." : grammar.parent_path())) {
    if (file.extension() != extension) continue;
    if (file.filename() == same.filename()) return file;
    only = file;
    ++count;
  }
  return count == 1 ? only : fs::path();
}

}  // namespace

std::vector<std::string> words_in(std::string_view text) {
  std::vector<std::string> words;
  while (!(text = trim(text)).empty()) {
    std::size_t length = std::min(text.find_first_of(" \t\r\n"), text.size());
    words.emplace_back(text.substr(0, length));
    text.remove_prefix(length);
  }
  return words;
}

double leading_number(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = consume_as<double>(word).value_or(0);
  return std::isfinite(value) ? value : 0;
}

int leading_whole(std::string_view word) {
  return static_cast<int>(std::clamp(leading_number(word), -1e9, 1e9));
}

Result<std::string> ModelFolder::read(const std::string& name) {
  std::error_code error;
  fs::path root = fs::weakly_canonical(folder_, error), file = fs::weakly_canonical(folder_ / name, error);
  auto [at, rest] = std::ranges::mismatch(root, file);
  if (error || fs::path(name).is_absolute() || at != root.end())
    return error_at("", "\"{}\" is not below the model's folder; copy it there and name it so", name);
  if (!fs::is_regular_file(file, error))
    return error_at("", "there is no file \"{}\" in the model's folder", name);
  Result<std::string> text = read_file(file);
  if (!text) return Error{"", text.errors()[0].what};
  files_.push_back(folder_ / name);
  content_ += name + '\n' + *text;
  return text;
}

Result<CpfgFiles> files_of(const fs::path& grammar) {
  CpfgFiles files;
  files.grammar = grammar;
  fs::path folder = grammar.parent_path();
  std::vector<std::string> command;
  if (is_file(folder / "specifications"))
    if (Result<std::string> text = read_file(folder / "specifications"))
      command = command_of(*text, grammar.filename().string());
  for (std::size_t i = 0; i < command.size(); ++i) {
    fs::path named = command[i];
    if (command[i] == "-e")
      return Error{grammar.string(),
                   "the model asks a program for its environment (-e in its specifications), without which "
                   "cpfg cannot derive it"};
    if (named.extension() == ".v") files.view = folder / named;
    if (named.extension() == ".a") files.animation = folder / named;
    if (is_colour(named)) files.colours.push_back(folder / named);
  }
  if (files.view.empty()) files.view = beside(grammar, ".v");
  if (files.animation.empty()) files.animation = beside(grammar, ".a");
  if (command.empty())
    for (std::string_view kind : {".map", ".mat"})
      if (fs::path file = beside(grammar, kind); !file.empty()) files.colours.push_back(file);
  return files;
}

Result<std::vector<CpfgViewLine>> read_view(ModelFolder& folder, const fs::path& file) {
  std::vector<CpfgViewLine> lines;
  if (file.empty()) return lines;
  std::error_code error;
  Result<std::string> text = folder.read(fs::relative(file, folder.path(), error).string());
  if (!text) return Error{file.string(), text.errors()[0].what};
  Result<PlainText> plain =
      preprocess(file.string(), *text, {}, [&](const std::string& name) { return folder.read(name); });
  if (!plain) return plain.errors();
  std::string_view rest = plain->text;
  for (std::size_t at = 0; at < plain->places.size(); ++at) {
    std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
    std::size_t colon = line.find(':');
    if (line.starts_with('\t') && !lines.empty())
      lines.back().value += ' ' + std::string(trim(line));
    else if (colon != line.npos)
      lines.push_back({std::string(trim(line.substr(0, colon))), std::string(trim(line.substr(colon + 1))),
                       plain->places[at].text()});
  }
  return lines;
}

Result<ViewCurves> read_curves(ModelFolder& folder, const std::vector<CpfgViewLine>& view) {
  ViewCurves read;
  for (const CpfgViewLine& line : view) {
    bool one = line.key == "function", set = line.key == "function set", curve = line.key == "curve";
    if (!one && !set && !curve) continue;
    std::vector<std::string> words = words_in(line.value);
    if (words.empty()) return Error{line.where, "expected the name of a file"};
    Result<std::string> text = folder.read(words[0]);
    if (!text) return Error{line.where, text.errors()[0].what};
    int samples = words.size() > 1 ? std::clamp(leading_whole(words[1]), 0, 100'000) : 0;
    auto wrong = [&](const Errors& errors) { return Error{line.where, words[0] + ": " + errors[0].what}; };
    if (one) {
      Result<FunctionTable> function = read_function(*text, samples);
      if (!function) return wrong(function.errors());
      read.functions.push_back(std::move(*function));
    } else if (set) {
      Result<std::vector<NamedFunction>> functions = read_function_set(*text);
      if (!functions) return wrong(functions.errors());
      for (NamedFunction& function : *functions) {
        read.functions.push_back(std::move(function.function));
        if (!function.name.empty())
          read.names.push_back({function.name, std::to_string(read.functions.size())});
      }
    } else {
      Result<ContourFile> contour = read_contour(*text);
      if (!contour) return wrong(contour.errors());
      read.curves.push_back(measure(*contour, samples > 0 ? samples : 100));
    }
  }
  return read;
}

}  // namespace frond::cpfg
