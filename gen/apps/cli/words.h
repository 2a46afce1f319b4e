#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace frond {

/// The words of the command line. One that begins with a dash as no option does, and names a file, is that
/// file.
std::vector<std::string> words_of(int count, char** words);

/// Lists the commands in the program's help in the order and under the headings in which people work.
/// Commands that only scripts and other programs call are not listed; they keep their names and their own
/// help.
void group_commands(CLI::App& app);

/// Lets every command of the program judge its options once they are read: of two that do not go together,
/// and of one that does nothing without another, CLI11 tells as of all wrong words.
void judge_options(CLI::App& app);

/// What is wrong with the name of a command, with the nearest that there is; or nothing.
std::string unknown_command(const CLI::App& app, std::string_view word);

/// What is wrong with the first long option that the command does not have, with the nearest that there is;
/// empty where it has them all.
std::string unknown_option(const CLI::App& app, const std::vector<std::string>& words);

/// The versions of Frond, of the libraries that it was built with, and of the POV-Ray that renders, a line
/// each.
std::string versions();

/// What a call without a command shows; `program` is as it was called.
std::string first_words(const std::string& program);

}  // namespace frond
