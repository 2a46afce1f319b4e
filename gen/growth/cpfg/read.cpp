
#include <algorithm>

#include "core/content.h"
#include "core/files.h"
#include "core/lookalike.h"
#include "core/plain_text.h"
#include "cpfg/cpfg.h"
#include "cpfg/reader.h"
#include "cpfg/run.h"
#include "cpfg/shapes.h"
#include "cpfg/view.h"

namespace frond {

namespace {

/// Whether a line of the text begins with a word and goes on, or ends, as the test says.
template <class Test>
bool has_line(std::string_view text, std::string_view word, const Test& test) {
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = std::min(text.find('\n', at), text.size());
    std::string_view line = trim(text.substr(at, end - at));
    if (line.starts_with(word) && test(line.substr(word.size()))) return true;
    at = end + 1;
  }
  return false;
}

/// Refuses what other programs with the same endings read, known by lines that only they have.
std::optional<Error> other_language(const std::filesystem::path& path, std::string_view text) {
  auto holds = [&](std::string_view word) { return text.find(word) != text.npos; };
  auto ends = [](char sign) { return [=](std::string_view rest) { return rest.ends_with(sign); }; };
  auto colon = [](std::string_view rest) { return trim(rest) == ":"; };
  bool lpfg = holds("lpfgall.h") || has_line(text, "module ", ends(';')) ||
              has_line(text, "derivation length", ends(';')) || has_line(text, "produce ", ends(';'));
  if (lpfg)
    return Error{path.string(),
                 "this is a model of lpfg (L+C), a program in C++, which cannot be read; write its "
                 "productions as `A(x) : condition --> …` of cpfg, or as rules of a preset"};
  bool python =
      has_line(text, "from ", [](std::string_view rest) { return rest.find(" import ") != rest.npos; }) ||
      has_line(text, "import ", [](std::string_view) { return true; }) || has_line(text, "def ", ends(':')) ||
      has_line(text, "nproduce", [](std::string_view) { return true; });
  if (has_ending(path.string(), ".lpy") || python || has_line(text, "production", colon) ||
      has_line(text, "interpretation", colon) ||
      has_line(text, "module ", [](std::string_view) { return true; }))
    return Error{
        path.string(),
        "this is a model of L-Py, a program in Python, which cannot be read; write each of its productions "
        "as `A(t) : t%4 == 0 --> …` of cpfg, or as a rule `A(t) : t%4 == 0 -> …` of a preset, its "
        "`interpretation` as the preset's, and what a loop produces as the modules that it makes"};
  return std::nullopt;
}

/// The first sign of the grammar, outside its strings, that looks like one of ASCII and is not.
std::optional<Error> odd_sign(const cpfg::PlainText& plain) {
  std::string_view text = plain.text;
  for (std::optional<Lookalike> odd = find_lookalike(text); odd;
       odd = find_lookalike(text, odd->at + odd->size)) {
    std::size_t line = odd->at == 0 ? 0 : text.rfind('\n', odd->at - 1) + 1;
    std::string_view before = text.substr(line, odd->at - line);
    if (std::ranges::count(before, '"') % 2 == 1) continue;
    return error_at(plain.where(odd->at), "column {}: {} is not {}, which is meant; write that",
                    column_of(before, before.size()), odd->name, odd->meant);
  }
  return std::nullopt;
}

}  // namespace

Result<CpfgModel> read_cpfg(const std::filesystem::path& path) {
  Result<std::string> text = read_file(path);
  if (!text) return text.errors();
  return read_cpfg(path, *text);
}

Result<CpfgModel> read_cpfg(const std::filesystem::path& path, std::string_view bytes) {
  std::string lines = plain_text(bytes);
  std::string_view text = lines;
  if (std::optional<Error> other = other_language(path, text)) return *other;
  Result<CpfgFiles> files = cpfg::files_of(path);
  if (!files) return files.errors();
  cpfg::ModelFolder folder(path.has_parent_path() ? path.parent_path() : ".");
  CpfgModel model;
  model.files = *files;
  Result<std::vector<CpfgViewLine>> view = cpfg::read_view(folder, files->view);
  if (!view) return view.errors();
  model.view = std::move(*view);
  // The animation does not change the word.
  if (Result<std::vector<CpfgViewLine>> animation = cpfg::read_view(folder, files->animation))
    model.animation = std::move(*animation);
  else
    model.notes.push_back(animation.errors()[0].text());
  for (const CpfgViewLine& line : model.view)
    if (line.key == "line")
      model.notes.push_back(line.where + ": lines are drawn round, not as a surface");
    else if (line.key == "texture")
      model.notes.push_back(line.where + ": textures are not drawn; what wears one has its plain colour");
  Result<cpfg::ViewCurves> curves = cpfg::read_curves(folder, model.view);
  if (!curves) return curves.errors();
  model.shapes = std::make_shared<const cpfg::Shapes>(cpfg::read_shapes(folder, model.view, files->colours));
  for (const std::string& note : model.shapes->notes) model.notes.push_back(note);
  auto include = [&](const std::string& name) { return folder.read(name); };
  Result<cpfg::PlainText> plain = cpfg::preprocess(path.string(), text, curves->names, include);
  if (!plain) return plain.errors();
  if (std::optional<Error> odd = odd_sign(*plain)) return *odd;

  auto code = std::make_shared<cpfg::Code>();
  code->functions = std::move(curves->functions);
  code->curves = std::move(curves->curves);
  cpfg::GrammarReader reader(*plain, *code);
  reader.read();
  if (std::optional<Error> error = reader.error()) {
    if (error->where.empty()) error->where = path.string();
    return *error;
  }
  model.notes.insert(model.notes.end(), reader.notes.begin(), reader.notes.end());
  if (int length = code->systems[0].length; length >= 0) {
    double steps = cpfg::constant_of(*code, length);
    model.steps = steps > 0 ? static_cast<int>(std::min(steps, 1e9)) : 0;
  }
  model.code = std::move(code);
  model.read = folder.files();
  model.read.push_back(path);
  model.content = content_id(folder.content() + std::string(text));
  return model;
}

}  // namespace frond
