#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
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

/// Appends a preset and its options as the words of a call of this program.
void add_words(std::vector<std::string>& words, const PresetArguments& preset);

/// A path that no program takes for an option.
std::string as_path(const std::string& path);

/// The commands that draw or start other programs: each adds itself to the command line and puts its exit
/// code into `result` when it is called.
void add_confine(CLI::App& app, int& result);
void add_draw(CLI::App& app, int& result);
void add_frame(CLI::App& app, int& result);
void add_film(CLI::App& app, int& result);
void add_render(CLI::App& app, int& result);
void add_sheet(CLI::App& app, int& result);
void add_compare(CLI::App& app, int& result);
void add_task(CLI::App& app, int& result);
void add_farm(CLI::App& app, int& result);
void add_gallery(CLI::App& app, int& result);

}  // namespace frond
