#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "studio/answers.h"
#include "studio/documents.h"
#include "studio/put_files.h"

// Grammars that stand in files of their own, which a preset names as `grammar.file`: models of cpfg, of
// several files, and rules of LParser and Houdini.
namespace frond {

/// Copies a grammar's files below a folder, some with other texts (by their paths below the grammar's
/// folder); its new name there. A model of several files gets a folder of its own, where all keep their
/// names. What is there already is taken as it is.
Result<PutFiles> put_grammar(const std::filesystem::path& folder, const std::filesystem::path& grammar,
                             const std::map<std::string, std::string>& texts = {});

/// What is in the files of the grammar `file`, and, of a model of cpfg, its word after `steps`:
/// see docs/studio-wire.md.
Answer grammar_files(const Documents& documents, const Json& question);

/// Writes a grammar beside the presets that is `file` with another `text` of the file `name`. Nothing is
/// written where it could not be read then: the answer says why.
Answer changed_grammar(const Documents& documents, const Json& question);

}  // namespace frond
