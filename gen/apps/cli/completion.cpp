#include <algorithm>
#include <memory>
#include <set>

#include "cli/rendering.h"
#include "cli/streams.h"
#include "core/files.h"
#include "core/home.h"
#include "jobs/jobs.h"
#include "organisms/kinds.h"
#include "preset/json.h"
#include "preset/manual.h"
#include "scene/preset.h"

namespace frond {

namespace fs = std::filesystem;

// What shells know of the command line, made from its own description, so that it cannot be out of date.

namespace {

using Strings = std::vector<std::string>;

/// Names of the presets that come with Frond.
Strings preset_names() {
  Strings names;
  for (const fs::path& file : files_below(home_folder() / "presets"))
    if (file.extension() == ".json" && file.parent_path().filename() != "grammars")
      names.push_back(file.stem().string());
  return names;
}

Strings kind_names() {
  Strings names;
  for (const auto& row : organism_kinds()) names.emplace_back(row.name);
  return names;
}

/// What a path of the documentation is called in a preset: `tree/habit/pace` of the second organism
/// `/organisms/1/habit/pace`; `all` are the names of kinds, `kinds` those of the organisms in their order.
void add_pointers(const Topic& topic, const Strings& all, const Strings& kinds,
                  std::set<std::string>& pointers) {
  std::size_t slash = topic.path.find('/');
  std::string head = topic.path.substr(0, slash);
  bool of_all = head == "organism";
  if (slash == topic.path.npos || (!of_all && std::ranges::find(all, head) == all.end())) {
    pointers.insert("/" + topic.path);
    return;
  }
  for (std::size_t i = 0; i < kinds.size(); ++i)
    if (of_all || kinds[i] == head)
      pointers.insert("/organisms/" + std::to_string(i) + topic.path.substr(slash));
}

/// JSON pointers of what can be set of the preset among the words; without one, of a preset with no organism.
Strings pointers_in(const Strings& words) {
  Strings kinds;
  for (const std::string& word : words) {
    std::optional<fs::path> shipped = shipped_by_name(word);
    Result<std::string> text = read_file(shipped.value_or(fs::path(word)));
    Result<Document> document = text ? parse_json(*text, word) : text.errors();
    const Value* organisms = document ? document->root.find("organisms") : nullptr;
    if (!organisms) continue;
    for (const Value& organism : organisms->items) {
      const Value* kind = organism.find("kind");
      kinds.push_back(kind ? kind->text : "");
    }
    break;
  }
  std::set<std::string> pointers;
  const Strings all = kind_names();
  for (const Topic& topic : topics_of(preset_schema())) add_pointers(topic, all, kinds, pointers);
  Strings list;
  for (const std::string& pointer : pointers) list.push_back(pointer + "=");
  return list;
}

/// The values of an option that are known by their names.
Strings values_of(const std::string& option, const Strings& words) {
  if (option == "--set" || option == "--sweep") return pointers_in(words);
  if (option == "--quality") return {"draft", "good", "best"};
  if (option == "--format") return {std::begin(kFilmFormats), std::end(kFilmFormats)};
  if (option != "--from") return {};
  Strings names = preset_names();
  std::ranges::move(kind_names(), std::back_inserter(names));
  return names;
}

Strings options_of(const CLI::App& command) {
  Strings names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

Strings commands_of(const CLI::App& app) {
  Strings names;
  for (const CLI::App* command : app.get_subcommands({}))
    if (!command->get_group().empty()) names.push_back(command->get_name());
  return names;
}

/// Whether an option of a command takes a value, which then stands behind it.
bool takes_value(const CLI::App& command, const std::string& word) {
  const CLI::Option* option = word.starts_with("-") ? command.get_option_no_throw(word) : nullptr;
  return option && option->get_items_expected_max() > 0;
}

Strings candidates(const CLI::App& app, const Strings& words) {
  if (words.size() < 2) return commands_of(app);
  auto named = [&](const CLI::App* one) { return one->get_name() == words[0]; };
  std::vector<const CLI::App*> commands = app.get_subcommands(named);
  if (commands.empty()) return {};
  const CLI::App* command = commands[0];
  const std::string& before = words[words.size() - 2];
  if (takes_value(*command, before)) return values_of(before, words);
  if (words.back().starts_with('-')) return options_of(*command);
  if (words[0] == "describe") return kind_names();
  return command->get_option_no_throw("preset") ? preset_names() : Strings{};
}

constexpr const char* kBash = R"(# Completion of frond in bash: `source <(frond completion bash)`
_frond() {
  local IFS=$'\n'
  COMP_WORDBREAKS=${COMP_WORDBREAKS//[=:]/}
  COMPREPLY=($("${COMP_WORDS[0]}" complete -- "${COMP_WORDS[@]:1:COMP_CWORD}" 2>/dev/null))
  if [[ ${COMPREPLY[0]:-} == *= ]]; then compopt -o nospace; fi
}
complete -o default -F _frond frond
)";

constexpr const char* kZsh = R"(#compdef frond
# Completion of frond in zsh: as _frond in a folder of $fpath, or `source <(frond completion zsh)`
_frond() {
  local -a found
  found=("${(@f)$("${words[1]}" complete -- "${(@)words[2,CURRENT]}" 2>/dev/null)}")
  if [[ -n ${found[1]} ]]; then
    if [[ ${found[1]} == *= ]]; then compadd -S '' -- "${found[@]}"; else compadd -- "${found[@]}"; fi
  fi
  if [[ ${words[CURRENT]} != -* ]]; then _files; fi
}
compdef _frond frond
)";

constexpr const char* kFish = R"(# Completion of frond in fish: `frond completion fish | source`
complete -c frond -a '(set -l words (commandline -opc) (commandline -ct); $words[1] complete -- $words[2..-1] 2>/dev/null)'
)";

/// What may stand in place of the last of the words behind the program's name, which has been begun:
/// commands, options, their values, presets, and properties after `--set`.
Strings completions(const CLI::App& app, const Strings& words) {
  Strings found = candidates(app, words);
  std::erase_if(found, [&](const std::string& word) { return !word.starts_with(words.back()); });
  std::ranges::sort(found);
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

void print_script(const std::string& shell) { put(shell == "bash" ? kBash : shell == "zsh" ? kZsh : kFish); }

}  // namespace

void add_completion(CLI::App& app) {
  auto words = std::make_shared<Strings>();
  auto* complete = app.add_subcommand("complete", "What may stand in place of the last word, for shells");
  complete->add_option("words", *words, "The words behind the program's name, the last begun");
  complete->callback([&app, words] {
    if (!words->empty())
      for (const std::string& word : completions(app, *words)) put(word + "\n");
  });
  auto [completion, shell] =
      add_command(app, "completion", "A script that completes words in bash, zsh or fish", print_script);
  completion->add_option("shell", *shell, "bash, zsh or fish")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  completion->footer(R"(Example:
  source <(frond completion bash))");
  auto* man = app.add_subcommand("man", "The manual page of this program, for man(1)");
  man->footer(R"(Example:
  frond man | man -l -)");
  man->callback([&app] { put(manual_page(app)); });
}

}  // namespace frond
