#include <algorithm>
#include <cmath>
#include <filesystem>

#include "cli/commands.h"
#include "cli/cpfg_models.h"
#include "cli/imported_preset.h"
#include "cli/messages.h"
#include "cpfg/cpfg.h"
#include "cpfg/view.h"

// A preset of a model of cpfg: import.

namespace frond {

namespace fs = std::filesystem;

namespace {

/// Three numbers of a line of the view.
std::optional<DVec3> vector_in(const CpfgModel& model, std::string_view key) {
  for (const CpfgViewLine& line : model.view) {
    if (line.key != key) continue;
    std::vector<double> numbers;
    for (std::string_view rest = line.value; !rest.empty();) {
      std::string_view part = rest.substr(0, rest.find(','));
      std::vector<std::string> words = cpfg::words_in(part);
      if (words.size() != 1) break;
      numbers.push_back(cpfg::leading_number(words[0]));
      rest.remove_prefix(std::min(part.size() + 1, rest.size()));
    }
    if (numbers.size() == 3) return DVec3{numbers[0], numbers[1], numbers[2]};
  }
  return std::nullopt;
}

/// From where the view looks at its model.
DVec3 side_of(const CpfgModel& model) {
  DVec3 from = vector_in(model, "viewpoint").value_or(DVec3{0, 0, 1}),
        to = vector_in(model, "view reference point").value_or(DVec3{0, 0, 0});
  DVec3 side = from - to;
  if (!(glm::length(side) > 1e-9) || !std::isfinite(glm::length(side))) side = {0, 0, 1};
  return side;
}

}  // namespace

void import_model(const ImportArguments& arguments) {
  if (!is_cpfg_model(arguments.path)) return import_rules(arguments);
  if (arguments.mutations > 0 || arguments.seed)
    fail({{arguments.path, "a model of cpfg has its seed in its file and is not mutated"}}, kWrongInput);
  CpfgModel model = or_fail(read_cpfg(arguments.path), kWrongInput);
  int steps = arguments.steps.value_or(film_of(model, model.steps).last);
  CpfgRequest request;
  request.steps = steps, request.drawing = true;
  CpfgDerived derived = or_fail(derive(model, request), kWrongInput);
  CpfgFigure figure = or_fail(draw(model, derived.drawing), kWrongInput);
  ImportedPlant plant{{Vec3(figure.low), Vec3(figure.high)}, side_of(model)};
  fs::path folder = fs::path(preset_path(arguments)).parent_path();
  std::error_code error;
  fs::path file = fs::proximate(arguments.path, folder.empty() ? "." : folder, error);
  if (error) fail({{arguments.path, "cannot be named from the preset's folder"}}, kWrongInput);
  plant.grammar.set("file", make_text(file.generic_string())).set("steps", make_number(steps));
  write_imported(arguments, plant);
}

}  // namespace frond
