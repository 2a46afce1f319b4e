#include <fmt/format.h>

#include <algorithm>

#include "core/content.h"
#include "core/files.h"
#include "cpfg/cpfg.h"
#include "cpfg/macros.h"
#include "cpfg/reader.h"
#include "cpfg/run.h"
#include "cpfg/shapes.h"
#include "cpfg/view.h"

namespace frond {

namespace {

/// Refuses what other programs with the same endings read.
std::optional<Error> other_language(const std::filesystem::path& path, std::string_view text) {
  auto holds = [&](std::string_view word) { return text.find(word) != text.npos; };
  if (holds("lpfgall.h") || (holds("produce ") && holds("\nmodule ")))
    return Error{
        path.string(),
        "this is a model of lpfg (L+C), a program in C++, which cannot be read; write its productions as "
        "`A(x) : condition --> …` of cpfg, or as rules of a preset"};
  if (path.extension() == ".lpy" || holds("from openalea") || holds("\ndef StartEach"))
    return Error{
        path.string(),
        "this is a model of L-Py, a program in Python, which cannot be read; write its productions as "
        "`A(x) : condition --> …` of cpfg, or as rules of a preset"};
  return std::nullopt;
}

}  // namespace

Result<CpfgModel> read_cpfg(const std::filesystem::path& path) {
  Result<std::string> text = read_file(path);
  if (!text) return text.errors();
  return read_cpfg(path, *text);
}

Result<CpfgModel> read_cpfg(const std::filesystem::path& path, std::string_view text) {
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

  auto code = std::make_shared<cpfg::Code>();
  code->functions = std::move(curves->functions);
  code->curves = std::move(curves->curves);
  cpfg::GrammarReader reader(*plain, *code);
  reader.read();
  if (reader.error()) return *reader.error();
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
