#include "scene/stand.h"
#include "cli/commands.h"
#include "cli/inputs.h"
#include "cli/messages.h"
#include "cli/streams.h"
#include "core/files.h"
#include "dynamics/plots.h"
#include "dynamics/reef_plots.h"
#include "scene/reef.h"

namespace frond {

void draw_stand(const StandArguments& arguments) {
  Preset preset = or_fail(load_preset(arguments.preset), kWrongInput);
  const std::string& path = arguments.preset.path;
  if (!preset.stand && !preset.reef) fail({Error{path, "the preset has no stand and no reef"}}, kWrongInput);
  int years = preset.stand ? preset.stand->years : preset.reef->years;
  if (arguments.year > years)
    fail({error_at(path, "--year {:g} is after the last year, {}", arguments.year, years)}, kWrongInput);
  tell_notes(preset.notes);
  std::string out = out_file(arguments.out, arguments.preset, preset.stand ? "_stand.svg" : "_reef.svg");
  double year = arguments.year < 0 ? years : arguments.year;
  bool table = out.ends_with(".csv");
  std::string text;
  if (preset.stand) {
    StandHistory history = stand_history(preset);
    text = table ? stand_csv(history) : stand_svg(history, year);
  } else {
    ReefHistory history = reef_history(preset);
    text = table ? reef_csv(history) : reef_svg(history, year);
  }
  or_fail(write_file(out, text), kCouldNot);
  put(out + "\n");
}

}  // namespace frond
