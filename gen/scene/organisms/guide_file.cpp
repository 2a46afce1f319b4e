#include "organisms/guide_file.h"

#include "geometry/obj.h"
#include "grammar/import.h"
#include "grammar/kind.h"

namespace frond {

Result<GuideLines> read_guide_file(const NamedFile& file) {
  std::string name = file.path.string();
  if (grammar_kind(name, file.text) == GrammarKind::skeleton) {
    Result<GuideLines> lines = skeleton_lines(file.text);
    // What stands in a file that a preset names is not shown.
    if (!lines) return Error{name, "is a skeleton that cannot be read; `frond derive` of it says why"};
    return lines;
  }
  Result<LineSet> lines = read_obj_lines(file.text, name);
  if (!lines) return lines.errors();
  return GuideLines{std::move(lines->place), std::move(lines->line)};
}

}  // namespace frond
