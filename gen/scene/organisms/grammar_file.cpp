#include "organisms/grammar_file.h"

#include <fmt/format.h>

#include "grammar/import.h"
#include "grammar/kind.h"
#include "organisms/describe_grammar.h"
#include "preset/fault.h"
#include "preset/json.h"
#include "preset/reader.h"

namespace frond {

Result<GrammarText> read_grammar(std::string_view text, const std::string& path, const Assets& files,
                                 std::string_view system) {
  GrammarKind kind = grammar_kind(path, text);
  if (kind == GrammarKind::cpfg)
    return Error{"",
                 "a model of cpfg is no grammar of ours; expected JSON, or a grammar of LParser, Houdini or "
                 "Fractint"};
  if (kind != GrammarKind::preset) {
    Result<GrammarText> grammar = import_grammar(path, text, system);
    if (grammar) grammar->where = path;
    return grammar;
  }
  Result<Document> document = parse_json(text, path);
  if (!document) return document.errors();
  Result<GrammarText> grammar = read_preset<GrammarText>(*document, nullptr, &files);
  if (!grammar) return grammar.errors();
  grammar->where = fmt::format("{}: /steps", origin_at(document->root, "/steps").text());
  return grammar;
}

Errors load_grammar(const NamedFile& file, GrammarText& grammar) {
  GrammarKind kind = grammar_kind(file.path.string(), file.text);
  if (kind == GrammarKind::cpfg || kind == GrammarKind::preset)
    return {Error{
        "", "a grammar of another program is one of LParser, Houdini or Fractint, or a skeleton as SWC"}};
  Result<GrammarText> import = import_grammar(file.path.string(), file.text);
  if (!import) {
    // What stands in a file that a preset names is not shown.
    Errors errors = import.errors();
    for (Error& error : errors) error.what = "cannot be read; `frond derive` of that file says why";
    return errors;
  }
  import->file = grammar.file, import->where = grammar.where, import->organs = grammar.organs;
  grammar = std::move(*import);
  return {};
}

Errors in_file(Errors errors, const std::string& path) {
  for (Error& error : errors)
    if (!error.where.starts_with(path)) error.where = path + (error.where.empty() ? "" : ": " + error.where);
  return errors;
}

}  // namespace frond
