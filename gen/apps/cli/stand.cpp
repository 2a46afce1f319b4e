
#include "scene/stand.h"
#include "cli/commands.h"
#include "cli/inputs.h"
#include "cli/messages.h"
#include "cli/streams.h"
#include "core/files.h"
#include "dynamics/plots.h"

namespace frond {

void draw_stand(const StandArguments& arguments) {
  Preset preset = or_fail(load_preset(arguments.preset), kWrongInput);
  const std::string& path = arguments.preset.path;
  if (!preset.stand) fail({Error{path, "the preset has no stand"}}, kWrongInput);
  if (arguments.year > preset.stand->years)
    fail({error_at(path, "--year {:g} is after the last year, {}", arguments.year, preset.stand->years)},
         kWrongInput);
  tell_notes(preset.notes);
  std::string out = out_file(arguments.out, arguments.preset, "_stand.svg");
  StandHistory history = stand_history(preset);
  double year = arguments.year < 0 ? history.years : arguments.year;
  or_fail(write_file(out, out.ends_with(".csv") ? stand_csv(history) : stand_svg(history, year)), kCouldNot);
  put(out + "\n");
}

}  // namespace frond
