#include "studio/answers.h"

#include "core/content.h"
#include "grammar/symbols.h"

namespace frond {

Answer wrong(const Errors& errors, const Errors& notes) {
  return {422, {{"errors", errors_json(errors)}, {"notes", errors_json(notes)}}, {}};
}

std::string key_of(const Doc& doc, const Preset& preset) {
  return content_id(doc.file.string() + keys_of(preset).all());
}

std::set<std::size_t> numbers(const Json& question, const char* name) {
  std::set<std::size_t> set;
  if (question.contains(name) && question[name].is_array())
    for (const Json& value : question[name])
      if (value.is_number_unsigned()) set.insert(value.get<std::size_t>());
  return set;
}

Json symbols_json() {
  Json symbols = Json::array();
  for (const TurtleSymbol& symbol : turtle_symbols())
    symbols.push_back({{"symbol", symbol.name}, {"doc", symbol.doc}});
  return symbols;
}

}  // namespace frond
