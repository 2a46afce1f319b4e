#include "studio/grammar_files.h"

#include <algorithm>

#include "core/assets.h"
#include "core/files.h"
#include "core/utf8.h"
#include "core/work_folder.h"
#include "cpfg/cpfg.h"
#include "organisms/cpfg_picture.h"
#include "organisms/grammar_file.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kShownLetters = 4000;             // characters
constexpr std::size_t kMostShown = 1 << 20;             // bytes of a file that is shown
constexpr std::size_t kMostWalked = 300'000;            // modules of a word that is drawn
constexpr std::size_t kMostDrawn = 30'000;              // lines and polygons of a picture
constexpr const char* kCommandLine = "specifications";  // of cpfg, for a model
/// So that the page is answered in a second or so.
constexpr CpfgLimits kShownLimits{.steps = 1'000'000, .modules = 1'000'000, .work = 200'000'000};

bool is_model(const fs::path& grammar) { return grammar.extension() == ".l"; }

/// Where a file stands, as seen from the folder of its grammar.
std::string name_in(const fs::path& file, const fs::path& folder) {
  std::error_code error;
  return fs::weakly_canonical(file, error).lexically_relative(fs::weakly_canonical(folder, error)).string();
}

/// What a file of a grammar holds; null of what is no text.
Json text_json(const fs::path& file) {
  Result<std::string> text = read_file(file);
  if (!text || text->size() > kMostShown || invalid_utf8(*text) || text->find('\0') != text->npos)
    return nullptr;
  return *text;
}

/// Messages name files as seen from the grammar's folder.
Errors seen_from(Errors errors, const fs::path& folder) {
  const std::string before = folder.string() + "/";
  for (Error& error : errors)
    for (std::string* text : {&error.where, &error.what})
      for (std::size_t at; (at = text->find(before)) != text->npos;) text->erase(at, before.size());
  return errors;
}

/// Why the grammar of a file cannot be read; nothing where it can.
Errors faults_of(const fs::path& grammar) {
  if (is_model(grammar)) {
    Result<CpfgModel> model = read_cpfg(grammar);
    return model ? Errors{} : model.errors();
  }
  Result<std::string> text = read_file(grammar);
  if (!text) return text.errors();
  Result<GrammarText> rules = read_grammar(*text, grammar.string(), Assets(grammar, grammar.parent_path()));
  if (!rules) return rules.errors();
  Result<Grammar> compiled = compile(*rules);
  return compiled ? Errors{} : compiled.errors();
}

/// What a model's turtle draws, as SVG; null where that is much, or a file for it is missing.
Json picture_of(const CpfgModel& model, const CpfgDrawing& drawing) {
  if (drawing.word.modules.size() > kMostWalked) return nullptr;
  Result<CpfgFigure> figure = draw(model, drawing);
  if (!figure || pieces_of(*figure) > kMostDrawn) return nullptr;
  return svg_of(drawing_of(*figure));
}

/// Adds what becomes of a model.
Errors add_word(const CpfgModel& model, const Json& question, Json& answer) {
  const int last = film_of(model, model.steps).last;
  const bool asked = question.contains("steps") && question["steps"].is_number();
  CpfgRequest request;
  request.steps =
      asked ? static_cast<int>(whole_number(question["steps"], "steps", 0, kShownLimits.steps)) : last;
  request.limits = kShownLimits;
  answer["of"] = last, answer["steps"] = *request.steps;
  for (const std::string& note : model.notes) answer["notes"].push_back(note);
  request.drawing = true;
  Result<CpfgDerived> derived = derive(model, request);
  // What is drawn may be too long where the word is not.
  if (!derived) request.drawing = false, derived = derive(model, request);
  if (!derived) return derived.errors();
  if (request.drawing) answer["svg"] = picture_of(model, derived->drawing);
  for (const std::string& note : derived->notes) answer["notes"].push_back(note);
  answer["word"] = text(derived->word, model).substr(0, kShownLetters);
  answer["length"] = derived->word.modules.size();
  for (const CpfgModule& module : derived->word.modules) {
    Json& count = answer["counts"][std::string(1, module.symbol)];
    count = count.is_null() ? 1 : count.get<int>() + 1;
  }
  return {};
}

/// The files that a grammar is read from, that itself first; below its folder. Where it cannot be read, those
/// beside it that have its name.
std::vector<fs::path> files_of_grammar(const fs::path& grammar) {
  std::vector<fs::path> files{grammar};
  if (!is_model(grammar)) return files;
  const fs::path folder = grammar.parent_path();
  std::vector<fs::path> read;
  if (Result<CpfgModel> model = read_cpfg(grammar))
    read = model->read;
  else
    for (const fs::path& file : files_in(folder))
      if (file.stem() == grammar.stem()) read.push_back(file);
  read.push_back(folder / kCommandLine);
  const std::string own = name_in(grammar, folder);
  std::map<std::string, fs::path> others;
  for (const fs::path& file : read)
    if (std::string name = name_in(file, folder); name != own && !name.starts_with("..") && is_file(file))
      others.emplace(std::move(name), file);
  for (auto& [name, file] : others) files.push_back(std::move(file));
  return files;
}

/// The readable grammar that a question names.
std::optional<fs::path> grammar_of(const Documents& documents, const Json& question) {
  std::optional<fs::path> file = documents.readable(question.at("file").get<std::string>());
  const bool fine = file && (is_model(*file) || file->extension() == ".ls" || file->extension() == ".txt");
  return fine && is_file(*file) ? file : std::nullopt;
}

}  // namespace

Result<PutFiles> put_grammar(const fs::path& folder, const fs::path& grammar,
                             const std::map<std::string, std::string>& texts) {
  std::map<std::string, std::string> contents;
  for (const fs::path& file : files_of_grammar(grammar)) {
    std::string name = name_in(file, grammar.parent_path());
    auto changed = texts.find(name);
    Result<std::string> content = changed != texts.end() ? Result(changed->second) : read_file(file);
    if (!content) return content.errors();
    contents.emplace(std::move(name), std::move(*content));
  }
  const std::string own = grammar.filename().string();
  if (!is_model(grammar)) return put_beside(folder, own, contents.begin()->second);
  Result<PutFiles> put = put_folder(folder, grammar.stem().string(), contents);
  if (put) put->name += "/" + own;
  return put;
}

Answer grammar_files(const Documents& documents, const Json& question) {
  std::optional<fs::path> grammar = grammar_of(documents, question);
  if (!grammar) return refused(403, "no such grammar may be read");
  const fs::path folder = grammar->parent_path();
  Json answer{{"files", Json::array()},
              {"steps", 0},
              {"of", 0},
              {"word", nullptr},
              {"length", nullptr},
              {"counts", Json::object()},
              {"svg", nullptr},
              {"notes", Json::array()},
              {"errors", Json::array()}};
  for (const fs::path& file : files_of_grammar(*grammar))
    answer["files"].push_back({{"name", name_in(file, folder)}, {"text", text_json(file)}});
  Errors errors;
  if (!is_model(*grammar)) {
    errors = faults_of(*grammar);
  } else {
    Result<CpfgModel> model = read_cpfg(*grammar);
    errors = model ? add_word(*model, question, answer) : model.errors();
  }
  answer["errors"] = errors_json(seen_from(std::move(errors), folder));
  return {200, std::move(answer)};
}

Answer changed_grammar(const Documents& documents, const Json& question) {
  std::optional<fs::path> grammar = grammar_of(documents, question);
  if (!grammar) return refused(403, "no such grammar may be read");
  const std::map<std::string, std::string> texts{
      {question.at("name").get<std::string>(), question.at("text").get<std::string>()}};
  const fs::path folder = grammar->parent_path();
  const std::vector<fs::path> files = files_of_grammar(*grammar);
  if (std::ranges::none_of(files,
                           [&](const fs::path& file) { return texts.contains(name_in(file, folder)); }))
    return refused(400, "the grammar has no such file");
  // It is tried where nobody else sees it.
  WorkFolder tried;
  for (const fs::path& file : files) {
    std::string name = name_in(file, folder);
    auto changed = texts.find(name);
    Result<std::string> content = changed != texts.end() ? Result(changed->second) : read_file(file);
    Result<bool> written = content ? write_file(tried.path() / name, *content) : content.errors();
    if (!written) return refused(500, written.errors().front().text());
  }
  if (Errors errors = faults_of(tried.path() / grammar->filename()); !errors.empty())
    return wrong(seen_from(std::move(errors), tried.path()));
  return documents.add_grammar(*grammar, texts, question.value("of", ""));
}

}  // namespace frond
