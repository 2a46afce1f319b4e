#pragma once

#include <string>

#include "cli/commands.h"

namespace frond {

/// Whether a path names a model of cpfg, or of a program that uses its ending.
bool is_cpfg_model(const std::string& path);

/// `frond info`, `derive` and `turtle` of such a model.
void info_cpfg(const GrammarArguments& arguments, bool json);
void derive_cpfg(const GrammarArguments& arguments);
void turtle_cpfg(const GrammarArguments& arguments);

}  // namespace frond
