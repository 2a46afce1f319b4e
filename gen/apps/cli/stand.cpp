#include <fmt/format.h>

#include <filesystem>

#include "cli/commands.h"
#include "cli/inputs.h"
#include "cli/messages.h"
#include "cli/streams.h"
#include "core/files.h"
#include "dynamics/plots.h"
#include "scene/stand.h"

namespace frond {

int draw_stand(const StandArguments& arguments) {
  Result<Preset> preset = load_preset(arguments.preset);
  if (!preset) return fail(preset.errors(), kWrongInput);
  const std::string& path = arguments.preset.path;
  if (!preset->stand) return fail({Error{path, "the preset has no stand"}}, kWrongInput);
  if (arguments.year > preset->stand->years)
    return fail({Error{path, fmt::format("--year {:g} is after the last year, {}", arguments.year,
                                         preset->stand->years)}},
                kWrongInput);
  tell_notes(preset->notes);
  std::string out =
      arguments.out.empty() ? std::filesystem::path(path).stem().string() + "_stand.svg" : arguments.out;
  StandHistory history = stand_history(*preset);
  double year = arguments.year < 0 ? history.years : arguments.year;
  Result<bool> written =
      write_file(out, out.ends_with(".csv") ? stand_csv(history) : stand_svg(history, year));
  if (!written) return fail(written.errors(), kCouldNot);
  put(out + "\n");
  return kDone;
}

}  // namespace frond
