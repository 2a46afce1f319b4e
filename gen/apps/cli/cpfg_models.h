#pragma once

#include <string>

#include "cli/commands.h"

namespace frond {

/// Whether a path names a model of cpfg, or of a program that uses its ending.
bool is_cpfg_model(const std::string& path);

/// `frond info`, `derive` and `turtle` of such a model.
int info_cpfg(const GrammarArguments& arguments, bool json);
int derive_cpfg(const GrammarArguments& arguments);
int turtle_cpfg(const GrammarArguments& arguments);

}  // namespace frond
