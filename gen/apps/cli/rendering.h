#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "cli/commands.h"

namespace frond {

/// Options that several commands have: `--assets`, and a preset with what is set of it.
void add_assets(CLI::App* command, std::optional<std::string>& assets);
void add_preset(CLI::App* command, PresetArguments& preset);
void add_sets(CLI::App* command, std::vector<std::string>& sets);
/// Turns the word of an option into the file that `find` gives for it, see cli/named.h.
CLI::Validator named_by(std::string (*find)(const std::string&));
/// Options of the pictures of a preset. add_size(): how large, fine and many they are. add_print(): their
/// size on paper and what is behind them. add_pictures(): both, and which part of them is drawn, and how
/// deep.
void add_size(CLI::App* command, PresetArguments& preset);
void add_print(CLI::App* command, PresetArguments& preset);
void add_pictures(CLI::App* command, PresetArguments& preset);
/// Options of a grammar; returns that of the steps, which may take a further check.
CLI::Option* add_grammar(CLI::App* command, GrammarArguments& grammar);
void add_mutations(CLI::App* command, int& mutations);
void add_system(CLI::App* command, std::string& system);
/// `--resolve` and `--no-resolve`; none where neither is given.
void add_resolving(CLI::App* command, std::optional<bool>& resolve);

/// frond(1), in the language of man pages.
std::string manual_page(const CLI::App& app);

/// Appends a preset and its options as the words of a call of this program.
void add_words(std::vector<std::string>& words, const PresetArguments& preset);

/// A path that no program takes for an option.
std::string as_path(const std::string& path);

/// Adds a command that calls `run` with its arguments; gives it and these, which live as long as it does.
template <class Arguments>
auto add_command(CLI::App& app, const char* name, const char* says, void (*run)(Arguments)) {
  auto to = std::make_shared<std::remove_cvref_t<Arguments>>();
  CLI::App* command = app.add_subcommand(name, says);
  command->callback([run, to] { run(*to); });
  return std::pair(command, to.get());
}

/// Each adds a command to the command line, which what it is named after does.
void add_check(CLI::App& app);
void add_completion(CLI::App& app);  ///< `complete`, `completion` and `man`
void add_confine(CLI::App& app);
void add_draw(CLI::App& app);
void add_frame(CLI::App& app);
void add_film(CLI::App& app);
void add_render(CLI::App& app);
void add_sheet(CLI::App& app);
void add_compare(CLI::App& app);
void add_task(CLI::App& app);
void add_farm(CLI::App& app);
void add_gallery(CLI::App& app);
void add_try(CLI::App& app);

}  // namespace frond
