#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace frond {

// What shells and manuals know of the command line, made from its own description, so that it cannot be out
// of date.

/// What may stand in place of the last of the words behind the program's name, which has been begun:
/// commands, options, their values, presets, and properties after `--set`.
std::vector<std::string> completions(const CLI::App& app, const std::vector<std::string>& words);

/// A script for bash, zsh or fish, which asks `frond complete`.
std::string completion_script(const std::string& shell);

/// frond(1), in the language of man pages.
std::string manual_page(const CLI::App& app);

/// Adds the commands `complete`, `completion` and `man`.
void add_completion(CLI::App& app, int& result);

}  // namespace frond
