#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace frond {

/// The words of the command line. One that begins with a dash as no option does, and names a file, is that
/// file.
std::vector<std::string> words_of(int count, char** words);

/// What is wrong with the name of a command, with the nearest that there is; or nothing.
std::string unknown_command(const CLI::App& app, std::string_view word);

/// What is wrong with the first long option that the command does not have, with the nearest that there is;
/// empty where it has them all.
std::string unknown_option(const CLI::App& app, const std::vector<std::string>& words);

/// What a call without a command shows; `program` is as it was called.
std::string first_words(const std::string& program);

}  // namespace frond
